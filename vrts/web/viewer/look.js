// What things look like: materials of the robot and of bodies.

import { Color, MeshStandardMaterial } from "three";
import { ALUMINIUM, CHARCOAL, RUBBER, STEEL, linkColor } from "./colors.js";

/**
 * Return the material of a piece of a link.
 * @param {string} link name of the link
 * @param {string} shape of the piece
 */
export function linkMaterial(link, shape) {
  const color = linkColor(link, shape);
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
