// Pieces as flat faces, few enough for a processor to draw: no rounded edges, cylinders with corners.

import { poseFrom } from "../../viewer/poses.js";

/** @typedef {import("../../viewer/shapes.js").PieceData} PieceData */
/** @typedef {number[]} Point x, y and z [m] */
/** @typedef {Point[]} Face corners of a flat convex face, seen counter-clockwise from outside */

const CORNERS = 32; // of a cylinder
const SIDES = [[1, 2], [2, 0], [0, 1]]; // the other axes of each axis

/** Return the faces of a piece in its body's frame. @param {PieceData} piece @returns {Face[]} */
export function facesOf(piece) {
  const X = poseFrom(piece.X);
  return ownFaces(piece).map((face) => face.map((point) => placed(X, point)));
}

/** @param {ArrayLike<number>} X pose @param {Point} point @returns {Point} */
export function placed(X, [x, y, z]) {
  return [X[0] * x + X[4] * y + X[8] * z + X[12], X[1] * x + X[5] * y + X[9] * z + X[13], X[2] * x + X[6] * y + X[10] * z + X[14]];
}

/** Return the way out of a face, of length 1. @param {Face} face @returns {Point} */
export function normalOf([a, b, c]) {
  const [ux, uy, uz, vx, vy, vz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2], c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

/** Return the corners of the box around faces, in their frame. @param {Face[]} faces @returns {Point[]} */
export function cornersOf(faces) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const point of faces.flat()) {
    for (const axis of [0, 1, 2]) {
      low[axis] = Math.min(low[axis], point[axis]);
      high[axis] = Math.max(high[axis], point[axis]);
    }
  }
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? high : low)[axis]));
}

/** @param {PieceData} piece @returns {Face[]} */
function ownFaces({ shape, half = [0, 0, 0], radius = 0, halfLength = 0, vertices = [], triangles = [] }) {
  if (shape === "box") return box(half);
  if (shape === "cylinder") return cylinder(radius, halfLength);
  const corner = (/** @type {number} */ k) => vertices.slice(3 * k, 3 * k + 3);
  const found = [];
  for (let k = 0; k + 2 < triangles.length; k += 3) found.push([corner(triangles[k]), corner(triangles[k + 1]), corner(triangles[k + 2])]);
  return found;
}

/** @param {number[]} half half extents [m] @returns {Face[]} */
function box(half) {
  return [0, 1, 2].flatMap((axis) => [1, -1].map((side) => {
    const [u, v] = SIDES[axis];
    return [[-1, -1], [side, -side], [1, 1], [-side, side]].map(([a, b]) => {
      const point = [0, 0, 0];
      point[axis] = side * half[axis];
      point[u] = a * half[u];
      point[v] = b * half[v];
      return point;
    });
  }));
}

/** @param {number} radius @param {number} half half the length along z [m] @returns {Face[]} */
function cylinder(radius, half) {
  const rim = (/** @type {number} */ z) => Array.from({ length: CORNERS }, (_, k) => {
    const angle = (2 * Math.PI * k) / CORNERS;
    return [radius * Math.cos(angle), radius * Math.sin(angle), z];
  });
  const [bottom, top] = [rim(-half), rim(half)];
  const sides = bottom.map((point, k) => {
    const next = (k + 1) % CORNERS;
    return [point, bottom[next], top[next], top[k]];
  });
  return [...sides, top, bottom.toReversed()];
}
