// What things look like: materials of the robot and of bodies, colours of the two themes.

import { Color, MeshStandardMaterial } from "three";

/** @typedef {"light"|"dark"} Theme */

export const THEMES = {
  light: { sky: 0xe4e9ee, floor: 0xb9c0c7, minor: 0xa5adb5, major: 0x8d97a1, text: "#38424c", halo: "#ffffff",
    ambient: 0.5, sun: 2.6 },
  dark: { sky: 0x262b32, floor: 0x3a424b, minor: 0x4b5560, major: 0x65717e, text: "#e3e9ef", halo: "#181c21",
    ambient: 0.45, sun: 2.3 },
};

const WARM_WHITE = 0xe6dfd0; // the arm castings of the series: a warm light grey
const CHARCOAL = 0x36393d;
const STEEL = 0x9aa0a6;
const ALUMINIUM = 0xc9cdd1;
const RUBBER = 0x1d1e20;

/** Castings by link name; round covers of the joints are dark on all of them. */
const LINKS = {
  base: CHARCOAL, turret: WARM_WHITE, "upper arm": WARM_WHITE, forearm: WARM_WHITE,
  wrist: CHARCOAL, "wrist bend": WARM_WHITE, flange: STEEL,
};
const COVERED = new Set(["turret", "upper arm", "forearm"]);

/**
 * Return the material of a piece of a link.
 * @param {string} link name of the link
 * @param {string} shape of the piece
 */
export function linkMaterial(link, shape) {
  const cover = shape === "cylinder" && COVERED.has(link);
  const color = cover ? CHARCOAL : LINKS[/** @type {keyof typeof LINKS} */ (link)] ?? WARM_WHITE;
  if (color === STEEL) return metal(STEEL, 0.35);
  return new MeshStandardMaterial({ color, roughness: color === CHARCOAL ? 0.55 : 0.42, metalness: 0.05 });
}

/** @param {"body"|"finger"} part of the gripper */
export function gripperMaterial(part) {
  return part === "body" ? metal(ALUMINIUM, 0.38) : metal(STEEL, 0.3);
}

/** Return the material of the pads. */
export function padMaterial() {
  return new MeshStandardMaterial({ color: RUBBER, roughness: 0.9 });
}

/**
 * Return the material of a body by its kind.
 * @param {string} kind "can", "base", "table", ...
 * @param {number[]} rgb linear, 0..1
 */
export function bodyMaterial(kind, rgb) {
  const color = new Color().setRGB(rgb[0], rgb[1], rgb[2]);
  if (kind === "can") return new MeshStandardMaterial({ color, roughness: 0.32, metalness: 0.35 });
  if (kind === "table") return new MeshStandardMaterial({ color, roughness: 0.7 });
  return new MeshStandardMaterial({ color, roughness: 0.6 });
}

/** @param {number} color @param {number} roughness */
export function metal(color, roughness) {
  return new MeshStandardMaterial({ color, roughness, metalness: 0.75 });
}
