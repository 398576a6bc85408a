// Where the handles of the pointer are in the picture: never smaller, never one over another.

/** @typedef {import("./screen.js").Place} Place */

export const APART = { fine: 30, coarse: 48 }; // [px] from one handle to the next at least, by mouse and by finger
export const ARM = { fine: 48, coarse: 66 }; // [px] from a ball to the handle for its height
const TURNS = [0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150, 180]; // [degrees] that a handle goes aside

/**
 * @typedef {object} Seen what is seen of an arrow
 * @property {Place} base
 * @property {Place} tip
 * @property {Place | null} up where the upward axis of the base is seen to point, of length 1; null: to the eye
 * @property {1|-1} way of the base's axis: up or down; the tip's points the other way
 */

/** @typedef {{base: Place, tip: Place, baseHeight: Place, tipHeight: Place}} Places */

/** @param {Place} from @param {Place} along @param {number} length @returns {Place} */
const away = (from, along, length) => ({ x: from.x + along.x * length, y: from.y + along.y * length });

/** @param {Place} a @param {Place} b */
const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

/**
 * Return where the four handles of an arrow go. The base stays where it is; the tip goes aside where it is
 * seen too near to it, and the handles for the heights turn about their balls until they are free.
 * @param {Seen} seen @param {"fine"|"coarse"} by mouse or finger
 * @returns {Places}
 */
export function placesOf({ base, tip, up, way }, by) {
  const apart = APART[by];
  const shown = distance(base, tip);
  const ahead = shown > 1 ? { x: (tip.x - base.x) / shown, y: (tip.y - base.y) / shown } : { x: Math.SQRT1_2, y: -Math.SQRT1_2 };
  const tipPlace = shown < apart ? away(base, ahead, apart) : tip;
  const upward = up ?? { x: 0, y: -1 };
  const taken = [base, tipPlace];
  const free = (/** @type {Place} */ from, /** @type {number} */ sign) => {
    const length = ARM[by];
    const tries = TURNS.map((turn) => away(from, turned({ x: sign * upward.x, y: sign * upward.y }, turn), length));
    const worst = (/** @type {Place} */ place) => Math.min(...taken.map((other) => distance(place, other)));
    const found = tries.find((place) => worst(place) >= apart) ?? tries.reduce((a, b) => (worst(b) > worst(a) ? b : a));
    taken.push(found);
    return found;
  };
  const baseHeight = free(base, way);
  return { base, tip: tipPlace, baseHeight, tipHeight: free(tipPlace, -way) };
}

/** @param {Place} along @param {number} degrees @returns {Place} */
function turned({ x, y }, degrees) {
  const [s, c] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return { x: x * c - y * s, y: x * s + y * c };
}
