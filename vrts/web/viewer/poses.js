// Poses as 4x4 matrices in column-major order (what WebGL and three.js use): X_AB maps B to A.
// Lengths in metres, angles in radians.

/** @typedef {Float64Array} Pose 16 numbers, column major */

/** @returns {Pose} the identity */
export function identity() {
  const X = new Float64Array(16);
  X[0] = X[5] = X[10] = X[15] = 1;
  return X;
}

/**
 * Return X_AB @ X_BC = X_AC.
 * @param {Pose} a
 * @param {Pose} b
 * @returns {Pose}
 */
export function compose(a, b) {
  const c = new Float64Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[row + 4 * k] * b[k + 4 * column];
      c[row + 4 * column] = sum;
    }
  }
  return c;
}

/**
 * Return the pose written as nine numbers of a rotation, row by row, and three of a translation.
 * @param {ArrayLike<number>} n twelve numbers, translation in m
 * @returns {Pose}
 */
export function poseFrom(n) {
  return Float64Array.of(
    n[0], n[3], n[6], 0, n[1], n[4], n[7], 0, n[2], n[5], n[8], 0, n[9], n[10], n[11], 1);
}

/**
 * Return the pose of a frame moved along its parent's axes.
 * @returns {Pose}
 */
export function translation(/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) {
  const X = identity();
  X[12] = x;
  X[13] = y;
  X[14] = z;
  return X;
}

/**
 * Return VAL's six numbers of a pose: X Y Z in mm, O A T in degrees, A within -90..90.
 * With the tool vertical, T is 0 and O carries the whole turn.
 * @param {Pose} X
 * @returns {number[]}
 */
export function components(X) {
  const level = Math.hypot(X[8], X[9]);
  const a = Math.atan2(-X[10], level);
  const vertical = level < 1e-7;
  const o = vertical ? Math.atan2(X[5], X[4]) : Math.atan2(X[8], -X[9]);
  const t = vertical ? 0 : Math.atan2(X[6], -X[2]);
  const degrees = [o, a, t].map((angle) => (angle * 180) / Math.PI);
  return [X[12] * 1000, X[13] * 1000, X[14] * 1000, ...degrees];
}
