// The tool in the flange frame, from what WHERE shows: exact as long as BASE is not shifted.

import { armFrames } from "../viewer/kinematics.js";
import { compose, identity } from "../viewer/poses.js";
import { rotationFromOat } from "./pointer_pose.js";

const SAME = 2e-5; // [m] and share of a turn; below this it is rounding

/** @typedef {import("../viewer/poses.js").Pose} Pose */

/** Return the inverse of a pose. @param {Pose} X @returns {Pose} */
export function inverse(X) {
  const Y = identity();
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) Y[row + 4 * column] = X[column + 4 * row];
    Y[12 + row] = -(X[4 * row] * X[12] + X[4 * row + 1] * X[13] + X[4 * row + 2] * X[14]);
  }
  return Y;
}

/**
 * Return the tool in the flange frame; what was known, where the difference is rounding.
 * @param {import("../viewer/kinematics.js").Arm} arm
 * @param {import("./protocol.js").Status} status @param {Pose} known @returns {Pose}
 */
export function toolFrom(arm, status, known) {
  const [x, y, z, o, a, t] = status.location;
  const R = rotationFromOat(o, a, t);
  const X_WT = Float64Array.of(R[0], R[3], R[6], 0, R[1], R[4], R[7], 0, R[2], R[5], R[8], 0, x / 1000, y / 1000, z / 1000, 1);
  const X_FT = compose(inverse(armFrames(arm, status.joints_rad).X_BF), X_WT);
  return X_FT.every((value, index) => Math.abs(value - known[index]) < SAME) ? known : X_FT;
}
