// Where the virtual pointer is: a tool point and a rotation, changed as people drag and type.
// Plain values, world frame, lengths in m, angles in rad; VAL's numbers in mm and degrees.

import { components } from "../viewer/poses.js";

/** @typedef {[number, number, number]} Vector */

/**
 * @typedef {object} PointerPose
 * @property {Vector} point of the tool: the base of the arrow [m]
 * @property {number[]} R rotation, nine numbers row by row; its columns: normal, orientation, approach
 * @property {number} length of the arrow [m]
 * @property {number[] | null} typed X Y Z [mm] O A T [degrees] as they were entered, while they hold
 */

export const SHORTEST = 0.05; // [m] arrow: shorter ones have no direction to speak of
export const LONGEST = 0.6; // [m]
const REACH = 3; // [m] the pointer stays within from the robot
const ROUNDED = 3e-6; // what six joints in single precision leave of a horizontal share
const VERTICAL = 1e-9; // squared length of what is left of a direction

/** @param {number} value @param {number} low @param {number} high */
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** @param {Vector} a @param {Vector} b @returns {Vector} */
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @param {Vector} a @param {number} s @returns {Vector} */
const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];

/** @param {Vector} a @param {Vector} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {Vector} p @returns {Vector} */
const within = (p) => [clamp(p[0], -REACH, REACH), clamp(p[1], -REACH, REACH), clamp(p[2], -REACH, REACH)];

/**
 * Return the pointer that shows a pose.
 * @param {import("../viewer/poses.js").Pose} X
 * @param {number} length of the arrow [m]
 * @returns {PointerPose}
 */
export function pointerAt(X, length) {
  const R = [X[0], X[4], X[8], X[1], X[5], X[9], X[2], X[6], X[10]];
  return { point: [X[12], X[13], X[14]], R: upright(R), length, typed: null };
}

/**
 * Return a rotation whose approach is exactly vertical where only rounding keeps it from that: poses
 * come in single precision, and there O and T would be any two numbers that belong together.
 * @param {number[]} R nine numbers row by row
 */
function upright(R) {
  if (Math.hypot(R[2], R[5]) > ROUNDED) return R;
  const up = Math.sign(R[8]);
  const turn = Math.atan2(R[4], R[1]); // of the orientation axis
  const [s, c] = [Math.sin(turn), Math.cos(turn)];
  return [s * up, c, 0, -c * up, s, 0, 0, 0, up];
}

/**
 * Return the pose as a matrix.
 * @param {PointerPose} pose
 * @returns {import("../viewer/poses.js").Pose}
 */
export function matrixOf({ R, point }) {
  return Float64Array.of(R[0], R[3], R[6], 0, R[1], R[4], R[7], 0, R[2], R[5], R[8], 0, ...point, 1);
}

/** @param {PointerPose} pose @returns {Vector} the direction of the arrow */
export function approach({ R }) {
  return [R[2], R[5], R[8]];
}

/** @param {PointerPose} pose @returns {Vector} the head of the arrow [m] */
export function tip(pose) {
  return plus(pose.point, times(approach(pose), pose.length));
}

/**
 * Return the pointer with the base of its arrow elsewhere; the head stays.
 * @param {PointerPose} pose @param {Vector} base [m] @returns {PointerPose}
 */
export function withBase(pose, base) {
  return between(pose, within(base), tip(pose), true);
}

/**
 * Return the pointer with the head of its arrow elsewhere; the base stays.
 * @param {PointerPose} pose @param {Vector} head [m] @returns {PointerPose}
 */
export function withTip(pose, head) {
  return between(pose, pose.point, head, false);
}

/**
 * Return the pointer moved as a whole.
 * @param {PointerPose} pose @param {Vector} by [m] @returns {PointerPose}
 */
export function shifted(pose, by) {
  return { ...pose, point: within(plus(pose.point, by)), typed: null };
}

/**
 * Return the pointer moved along its arrow.
 * @param {PointerPose} pose @param {number} distance ahead [m] @returns {PointerPose}
 */
export function along(pose, distance) {
  return shifted(pose, times(approach(pose), distance));
}

/**
 * Return the pointer turned about its arrow.
 * @param {PointerPose} pose @param {number} angle [rad] @returns {PointerPose}
 */
export function turned(pose, angle) {
  return { ...pose, R: rotated(pose.R, approach(pose), angle), typed: null };
}

/**
 * Return the pointer with its arrow vertical: down, unless it points up more than level.
 * @param {PointerPose} pose @returns {PointerPose}
 */
export function aligned(pose) {
  return directed(pose, [0, 0, approach(pose)[2] > 0.5 ? 1 : -1]);
}

/**
 * Return the pointer with its arrow in another direction, turned no more than that takes.
 * @param {PointerPose} pose @param {Vector} direction of length 1 @returns {PointerPose}
 */
export function directed(pose, direction) {
  const from = approach(pose);
  let axis = cross(from, direction);
  let sine = Math.hypot(...axis);
  const cosine = dot(from, direction);
  if (sine * sine < VERTICAL) {
    if (cosine > 0) return pose;
    axis = [pose.R[0], pose.R[3], pose.R[6]]; // straight back: about the normal
    sine = 0;
  }
  const R = rotated(pose.R, times(axis, 1 / Math.hypot(...axis)), Math.atan2(sine, cosine));
  [R[2], R[5], R[8]] = direction; // exactly
  return { ...pose, R, typed: null };
}

/**
 * Return VAL's six numbers: those that were typed while they hold, else as WHERE would show them.
 * @param {PointerPose} pose
 */
export function numbersOf(pose) {
  return pose.typed ?? components(matrixOf(pose)).map((n, i) => (i < 3 ? n : wrapped(n)));
}

/**
 * Return the pointer at numbers that were typed.
 * @param {PointerPose} pose @param {number[]} numbers X Y Z [mm] O A T [degrees] @returns {PointerPose}
 */
export function withNumbers(pose, numbers) {
  const typed = numbers.map((n, i) => (i < 3 ? clamp(n, -REACH * 1000, REACH * 1000) : wrapped(n)));
  const [x, y, z, o, a, t] = typed;
  return { ...pose, point: [x / 1000, y / 1000, z / 1000], R: rotationFromOat(o, a, t), typed };
}

/**
 * Return the rotation of VAL's angles in degrees, nine numbers row by row: R = Rz(O) M0 Ry(A) Rz(T).
 * Exact at multiples of 90 degrees.
 * @param {number} o @param {number} a @param {number} t
 */
export function rotationFromOat(o, a, t) {
  const [so, co] = sineCosine(o);
  const [sa, ca] = sineCosine(a);
  const [st, ct] = sineCosine(t);
  return [
    co * st - so * sa * ct, co * ct + so * sa * st, so * ca,
    so * st + co * sa * ct, so * ct - co * sa * st, -co * ca,
    -ca * ct, ca * st, -sa,
  ];
}

/** @param {number} degrees @returns {number} the same angle in (-180, 180] */
export function wrapped(degrees) {
  if (degrees > -180 && degrees <= 180) return degrees + 0;
  const rest = degrees - 360 * Math.round(degrees / 360);
  return rest === -180 ? 180 : rest;
}

/** @param {number} degrees @returns {[number, number]} */
function sineCosine(degrees) {
  const quarter = Math.round(degrees / 90);
  const rest = ((degrees - 90 * quarter) * Math.PI) / 180;
  const [s, c] = [Math.sin(rest), Math.cos(rest)];
  return /** @type {[number, number][]} */ ([[s, c], [c, -s], [-s, -c], [-c, s]])[((quarter % 4) + 4) % 4];
}

/**
 * Return the pointer between two ends. Ends that meet push each other along; ends far apart stretch
 * the arrow no further.
 * @param {PointerPose} pose @param {Vector} base @param {Vector} head [m]
 * @param {boolean} keepHead which end is where it was
 * @returns {PointerPose}
 */
function between(pose, base, head, keepHead) {
  const way = plus(head, times(base, -1));
  const distance = Math.hypot(...way);
  const length = clamp(distance, SHORTEST, LONGEST);
  if (distance < SHORTEST && !keepHead) return { ...pose, length, typed: null };
  const turnedPose = distance < SHORTEST ? pose : directed(pose, times(way, 1 / distance));
  return { ...turnedPose, point: base, length, typed: null };
}

/**
 * Return a rotation, then turned about an axis of the world, and made square again.
 * @param {number[]} R @param {Vector} axis of length 1 @param {number} angle [rad]
 */
function rotated(R, axis, angle) {
  /** @type {Vector[]} */
  const columns = [[R[0], R[3], R[6]], [R[1], R[4], R[7]], [R[2], R[5], R[8]]];
  const [s, c] = [Math.sin(angle), Math.cos(angle)];
  const [normal, , ahead] = columns.map((v) =>
    plus(plus(times(v, c), times(cross(axis, v), s)), times(axis, dot(axis, v) * (1 - c))));
  const z = times(ahead, 1 / Math.hypot(...ahead));
  const rest = plus(normal, times(z, -dot(normal, z)));
  const x = times(rest, 1 / Math.hypot(...rest));
  const y = cross(z, x);
  return [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];
}
