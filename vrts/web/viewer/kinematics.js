// Where the links of an arm are: six joints, one behind the other, each turning about its own z.

import { compose, identity, poseFrom } from "./poses.js";

/** @typedef {import("./poses.js").Pose} Pose */

/**
 * @typedef {object} Arm
 * @property {string} name
 * @property {string} title
 * @property {number[][]} joints twelve numbers each: link k in link k-1, with joint k at zero
 * @property {number[]} flange twelve numbers: the flange in link 6
 * @property {number} shoulderHeight of the base frame above the floor [m]
 * @property {number[]} lower joint limits [rad]
 * @property {number[]} upper joint limits [rad]
 * @property {number[]} speed largest joint speeds [rad/s]
 * @property {number} linearSpeed of straight lines at SPEED 100 [m/s]
 */

/** @typedef {{X_BL: Pose[], X_BF: Pose}} ArmFrames links 0..6 and the flange in the base frame */

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
 * @param {ArrayLike<number>} q six joint positions [rad]
 * @returns {ArmFrames}
 */
export function armFrames(arm, q) {
  const X_BL = [identity()];
  for (let joint = 0; joint < 6; joint++) {
    X_BL.push(compose(compose(X_BL[joint], poseFrom(arm.joints[joint])), turn(q[joint])));
  }
  return { X_BL, X_BF: compose(X_BL[6], poseFrom(arm.flange)) };
}
