// Colours of the robot, and of the two themes.

/** @typedef {"light"|"dark"} Theme */

export const THEMES = {
  light: { sky: 0xe4e9ee, floor: 0xb9c0c7, minor: 0xa5adb5, major: 0x8d97a1, text: "#38424c", halo: "#ffffff",
    ambient: 0.5, sun: 2.6 },
  dark: { sky: 0x262b32, floor: 0x3a424b, minor: 0x4b5560, major: 0x65717e, text: "#e3e9ef", halo: "#181c21",
    ambient: 0.45, sun: 2.3 },
};

const WARM_WHITE = 0xe6dfd0; // the arm castings of the series: a warm light grey
export const CHARCOAL = 0x36393d;
export const STEEL = 0x9aa0a6;
export const ALUMINIUM = 0xc9cdd1;
export const RUBBER = 0x1d1e20;

/** Castings by link name; round covers of the joints are dark on all of them. */
const LINKS = {
  base: CHARCOAL, turret: WARM_WHITE, "upper arm": WARM_WHITE, forearm: WARM_WHITE,
  wrist: CHARCOAL, "wrist bend": WARM_WHITE, flange: STEEL,
};
const COVERED = new Set(["turret", "upper arm", "forearm"]);

/** Return the colour of a piece of a link. @param {string} link its name @param {string} shape of the piece */
export function linkColor(link, shape) {
  const cover = shape === "cylinder" && COVERED.has(link);
  return cover ? CHARCOAL : LINKS[/** @type {keyof typeof LINKS} */ (link)] ?? WARM_WHITE;
}
