// How far a drag moves the pointer: finely at first, then nearly as fast as the mouse; in steps.

/** @typedef {import("./screen.js").Place} Place */
/** @typedef {[number, number, number]} Vector */

const FINE = 60; // [px] within which a drag is fine: half of what is seen there
export const FINER = 0.1; // with Shift

/**
 * Return a drag as it counts [px].
 * @param {number} pixels @returns {number}
 */
export function eased(pixels) {
  return (pixels * Math.abs(pixels)) / (Math.abs(pixels) + FINE);
}

/**
 * Return a number rounded to steps; a step of 0 rounds nothing.
 * @param {number} value @param {number} step in the same unit
 */
export function stepped(value, step) {
  return step > 0 ? Math.round(value / step) * step + 0 : value;
}

/**
 * Return how far a drag moves something level.
 * @param {Place} dragged [px]
 * @param {number} pixel what one is where the handle is [m]
 * @param {Vector} right level direction that is to the right in the picture, of length 1
 * @param {Vector} away level direction that leads away from the eye, of length 1
 * @param {number} step [m]
 * @returns {Vector} [m]
 */
export function level({ x, y }, pixel, right, away, step) {
  const length = Math.hypot(x, y);
  const share = length > 0 ? (eased(length) / length) * pixel : 0;
  const by = (/** @type {number} */ i) => stepped(share * (x * right[i] - y * away[i]), step);
  return [by(0), by(1), 0];
}

/**
 * Return how far a drag moves something along a line.
 * @param {Place} dragged [px]
 * @param {number} pixel what one is where the handle is [m]
 * @param {Place} seen direction in which the line leads in the picture, of length 1
 * @param {number} step [m]
 * @returns {number} [m]
 */
export function along({ x, y }, pixel, seen, step) {
  return stepped(eased(x * seen.x + y * seen.y) * pixel, step);
}
