// How somebody has arranged the page, remembered in this browser. What cannot be read or kept does no harm.

const KEPT = "vrts layout";
const VERSION = 1;
const LONGEST = 2_000; // characters: what is longer was not written here

/** What the numbers may be, and what they are at first. A page also keeps them within its window. */
export const LIMITS = {
  desk: { least: 320, most: 1_600, first: 400 }, // width of the panels [px]
  deskHigh: { least: 120, most: 1_200, first: 0 }, // height of the panels below the picture; 0: by the window [px]
  terminal: { least: 64, most: 900, first: 96 }, // height of the monitor [px]
};
export const PROJECTED = "table"; // view point of the projector at first, whatever is kept
export const LOOKS = ["overview", "table", "front", "side", "top", "hand"];

/**
 * @typedef {object} Layout
 * @property {number} desk
 * @property {number} deskHigh
 * @property {number} terminal
 * @property {boolean} deskFolded
 * @property {boolean} terminalFolded
 * @property {string} look view point that the page begins with
 */

/** @returns {Layout} */
export function firstLayout() {
  return { desk: LIMITS.desk.first, deskHigh: LIMITS.deskHigh.first, terminal: LIMITS.terminal.first,
    deskFolded: false, terminalFolded: false, look: "table" };
}

/**
 * Return a layout that was kept as text; what is missing, out of its limits or of another kind is as at first.
 * @param {string | null} text @returns {Layout}
 */
export function layoutFrom(text) {
  const layout = firstLayout();
  if (!text || text.length > LONGEST) return layout;
  /** @type {any} */
  let kept;
  try {
    kept = JSON.parse(text);
  } catch {
    return layout; // somebody else wrote it, or half of it
  }
  if (typeof kept !== "object" || kept === null || kept.version !== VERSION) return layout;
  for (const name of /** @type {(keyof typeof LIMITS)[]} */ (Object.keys(LIMITS))) {
    const { least, most } = LIMITS[name];
    const value = kept[name];
    if (typeof value === "number" && value >= least && value <= most) layout[name] = Math.round(value);
  }
  for (const name of /** @type {const} */ (["deskFolded", "terminalFolded"])) {
    if (typeof kept[name] === "boolean") layout[name] = kept[name];
  }
  if (LOOKS.includes(kept.look)) layout.look = kept.look;
  return layout;
}

/** @returns {Layout} as it was kept here, else as at first */
export function keptLayout() {
  try {
    return layoutFrom(localStorage.getItem(KEPT));
  } catch {
    return firstLayout(); // a browser may forbid all storage
  }
}

/** Remember a layout in this browser, if it lets us. @param {Layout} layout */
export function keepLayout(layout) {
  try {
    localStorage.setItem(KEPT, JSON.stringify({ version: VERSION, ...layout }));
  } catch {
    return; // full or forbidden: it holds for this page
  }
}
