// Where the links of a PUMA are: the standard Denavit-Hartenberg chain in VAL's joint angles.

import { compose, identity, translation } from "./poses.js";

/** @typedef {import("./poses.js").Pose} Pose */

/**
 * @typedef {object} Arm
 * @property {string} name
 * @property {string} title
 * @property {number} a2 [m]
 * @property {number} a3 [m]
 * @property {number} d2 [m]
 * @property {number} d4 [m]
 * @property {number} d6 [m]
 * @property {number} shoulderHeight of the base frame above the floor [m]
 * @property {number[]} lower joint limits [rad]
 * @property {number[]} upper joint limits [rad]
 * @property {number[]} speed largest joint speeds [rad/s]
 * @property {number} linearSpeed of straight lines at SPEED 100 [m/s]
 */

/** @typedef {{X_BL: Pose[], X_BF: Pose}} ArmFrames links 0..6 and the flange in the base frame */

/**
 * Return a turn about z by q, then the rest of a DH row: along z by d, along x by a, about x by alpha.
 * @param {number} alpha a multiple of a right angle [rad]
 * @returns {Pose}
 */
function row(/** @type {number} */ alpha, /** @type {number} */ a, /** @type {number} */ d) {
  const c = Math.round(Math.cos(alpha));
  const s = Math.round(Math.sin(alpha));
  return Float64Array.of(1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, a, 0, d, 1);
}

/**
 * @param {number} angle [rad]
 * @returns {Pose}
 */
function turn(angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return Float64Array.of(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
}

/**
 * Return the frames of links 0..6, each right after the rotation of its joint, and of the flange.
 * @param {Arm} arm
 * @param {ArrayLike<number>} q six joint positions in VAL's convention [rad]
 * @returns {ArmFrames}
 */
export function armFrames(arm, q) {
  const right = Math.PI / 2;
  const rows = [
    row(-right, 0, 0),
    row(0, arm.a2, arm.d2),
    row(right, arm.a3, 0),
    row(-right, 0, arm.d4),
    row(right, 0, 0),
    translation(0, 0, arm.d6),
  ];
  const X_BL = [identity()];
  let X = identity();
  for (let joint = 0; joint < 6; joint++) {
    const L = compose(X, turn(q[joint]));
    X_BL.push(L);
    X = compose(L, rows[joint]);
  }
  return { X_BL, X_BF: X };
}
