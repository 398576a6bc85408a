// Where names are written over a picture so that none covers another.

/** @typedef {{x: number, y: number, width: number, height: number, weight: number}} Wanted a point and a size [px]; more weight comes first */
/** @typedef {{left: number, top: number} | null} Placed null: there is no room */

const APART = 2; // between two names [px]
const LIFT = 6; // above its point [px]
const HIGHER = 24; // where there is something else [px]

/**
 * Return where each name is written: above its point, else beside or under it, else nowhere.
 * @param {Wanted[]} names @param {{width: number, height: number}} area
 * @returns {Placed[]}
 */
export function placed(names, area) {
  /** @type {{left: number, top: number, right: number, bottom: number}[]} */
  const taken = [];
  /** @type {Placed[]} */
  const found = names.map(() => null);
  const order = names.map((_, index) => index).sort((a, b) => names[b].weight - names[a].weight || a - b);
  for (const index of order) {
    const name = names[index];
    if (!(name.x >= 0 && name.x <= area.width && name.y >= 0 && name.y <= area.height)) continue;
    for (const [left, top] of ways(name)) {
      const box = { left, top, right: left + name.width, bottom: top + name.height };
      if (box.left < 0 || box.top < 0 || box.right > area.width || box.bottom > area.height) continue;
      if (taken.some((other) => meets(box, other))) continue;
      taken.push(box);
      found[index] = { left, top };
      break;
    }
  }
  return found;
}

/** @param {Wanted} name */
function ways({ x, y, width, height }) {
  return [
    [x - width / 2, y - height - LIFT], [x + 10, y - height / 2], [x - 10 - width, y - height / 2],
    [x - width / 2, y - height - HIGHER], [x - width / 2, y + 10], [x + 4, y - height - LIFT], [x - 4 - width, y - height - LIFT],
  ];
}

/** @param {{left: number, top: number, right: number, bottom: number}} a @param {{left: number, top: number, right: number, bottom: number}} b */
function meets(a, b) {
  return a.left < b.right + APART && b.left < a.right + APART && a.top < b.bottom + APART && b.top < a.bottom + APART;
}
