// Where the eye has to stand so that everything that matters fills the picture.

import { Box3, Mesh, Vector3 } from "three";

/** @typedef {import("three").Vector3} Point */

const MARGIN = 0.94; // share of the picture that may be filled, each way

/**
 * Return the nearest place from which all points are seen, and what lies in the middle.
 * @param {Point[]} points [m]
 * @param {Point} ahead direction in which the eye looks, of length 1
 * @param {number} fov height of the picture as an angle [rad]
 * @param {number} aspect of the picture, width by height
 * @returns {{eye: Point, target: Point}} [m]
 */
export function framed(points, ahead, fov, aspect) {
  const right = new Vector3().crossVectors(ahead, new Vector3(0, 0, 1)).normalize();
  const up = new Vector3().crossVectors(right, ahead);
  const high = MARGIN * Math.tan(fov / 2);
  const [x, y] = [fitted(points, right, ahead, high * aspect), fitted(points, up, ahead, high)];
  const depth = Math.min(x.depth, y.depth);
  const eye = new Vector3().addScaledVector(right, x.middle(depth)).addScaledVector(up, y.middle(depth)).addScaledVector(ahead, depth);
  const depths = points.map((point) => point.dot(ahead));
  const away = (Math.min(...depths) + Math.max(...depths)) / 2 - depth;
  return { eye, target: eye.clone().addScaledVector(ahead, away) };
}

/**
 * Return how far ahead the eye may stand to see all points within a slope on both sides, and where then.
 * @param {Point[]} points @param {Point} across @param {Point} ahead @param {number} slope
 */
function fitted(points, across, ahead, slope) {
  const high = Math.min(...points.map((p) => p.dot(across) + slope * p.dot(ahead)));
  const low = Math.max(...points.map((p) => p.dot(across) - slope * p.dot(ahead)));
  return { depth: (high - low) / (2 * slope), middle: (/** @type {number} */ depth) => (high - slope * depth + low + slope * depth) / 2 };
}

/**
 * Return the corners of all meshes of something, in the world [m].
 * @param {import("three").Object3D} whole
 */
export function cornersOf(whole) {
  whole.updateMatrixWorld(true);
  /** @type {Point[]} */
  const found = [];
  whole.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.geometry.boundingBox ?? part.geometry.computeBoundingBox();
    const { min, max } = /** @type {Box3} */ (part.geometry.boundingBox);
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
      found.push(new Vector3(x, y, z).applyMatrix4(part.matrixWorld));
    }
  });
  return found;
}

/**
 * Return what the picture is to show of a scene: the arm as it stands, and the top of the table with what is on it.
 * @param {import("../../viewer/viewer.js").Viewer} viewer
 */
export function worked(viewer) {
  const { table, floor } = viewer.data;
  const points = cornersOf(viewer.robot.group);
  if (!table) return points;
  const foot = floor + (table.z - floor) / 2; // the arm's foot says nothing
  const seen = points.filter((point) => point.z > foot);
  const { x0, x1, y0, y1, z } = table;
  return [...seen, ...[[x0, y0], [x0, y1], [x1, y0], [x1, y1]].map(([x, y]) => new Vector3(x, y, z))];
}
