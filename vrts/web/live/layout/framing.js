// Where the eye has to stand so that everything that matters fills the picture.

import { VIEWS, stoodBack } from "../../viewer/views.js";

/** @typedef {number[]} Point x, y and z [m] */

const MARGIN = 0.94; // share of the picture that may be filled, each way
const FARTHER = 1.42; // times
const RAISED = 0.42; // by which the overview looks higher than the reports' [m]
const NEAR = 1.1; // from the hand that is followed to the eye [m]

/**
 * Return the eye and what it looks at of a preset view point. The overview stands far enough away for an
 * arm that points up; the table is seen from as near as arm and table fill the picture.
 * @param {string} name of it, or "hand" to follow the hand
 * @param {number} fov height of the picture as an angle [rad] @param {number} aspect of the picture, width by height
 * @param {() => Point[]} points what the picture is to show @param {Point} hand where the tool is
 * @returns {{eye: Point, target: Point}} [m]
 */
export function aimed(name, fov, aspect, points, hand) {
  if (name === "table") {
    const { eye, target } = VIEWS.table;
    return framed(points(), scaled(minus(target, eye), 1), fov, aspect);
  }
  const known = VIEWS[/** @type {keyof typeof VIEWS} */ (name)];
  const { eye, target } = stoodBack(known ?? VIEWS.overview, aspect);
  const away = minus(eye, target);
  if (!known) return { eye: plus(hand, scaled(away, NEAR)), target: hand };
  if (name !== "overview") return { eye, target };
  const raised = plus(target, [0, 0, RAISED]);
  return { eye: plus(raised, away.map((x) => x * FARTHER)), target: raised };
}

/**
 * Return the nearest place from which all points are seen, and what lies in the middle.
 * @param {Point[]} points [m]
 * @param {Point} ahead direction in which the eye looks, of length 1
 * @param {number} fov height of the picture as an angle [rad]
 * @param {number} aspect of the picture, width by height
 * @returns {{eye: Point, target: Point}} [m]
 */
function framed(points, ahead, fov, aspect) {
  const right = scaled([ahead[1], -ahead[0], 0], 1);
  const up = [right[1] * ahead[2], -right[0] * ahead[2], right[0] * ahead[1] - right[1] * ahead[0]];
  const high = MARGIN * Math.tan(fov / 2);
  const [x, y] = [fitted(points, right, ahead, high * aspect), fitted(points, up, ahead, high)];
  const depth = Math.min(x.depth, y.depth);
  const [across, along] = [x.middle(depth), y.middle(depth)];
  const eye = ahead.map((part, axis) => right[axis] * across + up[axis] * along + part * depth);
  const depths = points.map((point) => dot(point, ahead));
  const away = (Math.min(...depths) + Math.max(...depths)) / 2 - depth;
  return { eye, target: plus(eye, ahead.map((part) => part * away)) };
}

/**
 * Return how far ahead the eye may stand to see all points within a slope on both sides, and where then.
 * @param {Point[]} points @param {Point} across @param {Point} ahead @param {number} slope
 */
function fitted(points, across, ahead, slope) {
  const high = Math.min(...points.map((p) => dot(p, across) + slope * dot(p, ahead)));
  const low = Math.max(...points.map((p) => dot(p, across) - slope * dot(p, ahead)));
  return { depth: (high - low) / (2 * slope), middle: (/** @type {number} */ depth) => (high - slope * depth + low + slope * depth) / 2 };
}

/**
 * Return what the picture is to show of a scene: the arm as it stands, and the top of the table with what is on it.
 * @param {Point[]} arm its corners
 * @param {{table: {x0: number, x1: number, y0: number, y1: number, z: number} | null, floor: number}} scene
 */
export function worthSeeing(arm, { table, floor }) {
  if (!table) return arm;
  const foot = floor + (table.z - floor) / 2; // the arm's foot says nothing
  const { x0, x1, y0, y1, z } = table;
  return [...arm.filter((point) => point[2] > foot), [x0, y0, z], [x0, y1, z], [x1, y0, z], [x1, y1, z]];
}

/** @param {Point} a @param {Point} b */
function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** @param {Point} a @param {Point} b */
function plus(a, b) {
  return a.map((x, axis) => x + b[axis]);
}

/** @param {Point} a @param {Point} b */
function minus(a, b) {
  return a.map((x, axis) => x - b[axis]);
}

/** Return a direction with another length. @param {Point} a @param {number} length */
function scaled(a, length) {
  const factor = length / Math.hypot(...a);
  return a.map((x) => x * factor);
}
