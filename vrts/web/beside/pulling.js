// How far a point of the world goes when it is pulled on the picture, or pushed by keys.

import { Vector3 } from "three";

/** @typedef {import("../live/pointing/screen.js").Screen} Screen */
/** @typedef {import("../live/pointing/screen.js").Place} Place */
/** @typedef {[number, number, number]} Numbers X Y Z [mm] */

const SEEN = 0.01; // [m] of which it is looked how long they are on the picture
const END_ON = 0.08; // a line seen shorter than this share is not pulled along
export const STEP = 0.1; // [mm] of a key, and what places are rounded to
const LARGE = 10; // steps of a key with Ctrl

/**
 * Return where a point goes that is pulled from one place of the picture to another: within the plane
 * that faces the camera, or along Z.
 * @param {Screen} screen @param {Numbers} start [mm] @param {Place} from @param {Place} to @param {boolean} upright
 * @returns {Numbers} [mm]
 */
export function pulled(screen, start, from, to, upright) {
  const point = new Vector3().fromArray(start).multiplyScalar(1e-3);
  const depth = screen.depth(point);
  if (!upright) {
    const by = screen.point(to, depth).sub(screen.point(from, depth)).multiplyScalar(1e3);
    return moved(start, [by.x, by.y, by.z]);
  }
  const [a, b] = [screen.place(point), screen.place(point.clone().add(new Vector3(0, 0, SEEN)))];
  const seen = { x: (b.x - a.x) / SEEN, y: (b.y - a.y) / SEEN }; // [px] of 1 m upward
  const square = seen.x ** 2 + seen.y ** 2;
  if (Math.sqrt(square) * screen.pixel(depth) < END_ON) return start;
  const up = ((to.x - from.x) * seen.x + (to.y - from.y) * seen.y) / square;
  return moved(start, [0, 0, up * 1e3]);
}

/**
 * Return where a key pushes a point: arrows along X and Y, with Shift (or by page keys) along Z, with
 * Ctrl ten steps at once; null: it is another key.
 * @param {Numbers} at [mm] @param {{key: string, shiftKey: boolean, ctrlKey: boolean, metaKey: boolean, altKey: boolean}} event
 * @returns {Numbers | null}
 */
export function pushed(at, { key, shiftKey, ctrlKey, metaKey, altKey }) {
  if (altKey) return null;
  /** @type {Record<string, [number, number]>} axis and sign */
  const keys = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [shiftKey ? 2 : 1, 1], ArrowDown: [shiftKey ? 2 : 1, -1], PageUp: [2, 1], PageDown: [2, -1] };
  const found = keys[key];
  if (!found) return null;
  const next = /** @type {Numbers} */ ([...at]);
  next[found[0]] += found[1] * STEP * (ctrlKey || metaKey ? LARGE : 1);
  return /** @type {Numbers} */ (next.map((value) => Math.round(value * 1e4) / 1e4));
}

/** Return a point moved by steps; what hardly moves stays as it is written. @param {Numbers} start @param {Numbers} by @returns {Numbers} */
function moved(start, by) {
  const steps = (/** @type {number} */ value) => Math.round(value / STEP) / Math.round(1 / STEP);
  return /** @type {Numbers} */ (start.map((value, i) => (Math.abs(by[i]) < STEP / 2 ? value : steps(value + by[i]))));
}

/** Return X, Y and Z in words. @param {Numbers} at [mm] */
export function written(at) {
  return at.map((value, i) => `${"XYZ"[i]} ${((value + 0).toFixed(1)).replace(/^-(0\.0)$/, "$1").replace("-", "−")}`).join("  ");
}
