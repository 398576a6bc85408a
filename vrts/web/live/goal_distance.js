// How far an object is from its goal, by the rules that its task is marked by.

import { compose, poseFrom } from "../viewer/poses.js";

/** @typedef {import("../viewer/poses.js").Pose} Pose */
/** @typedef {{turns: number[][], axis: number[] | null, foot: number[]}} Shape turns after which it looks the same */
/** @typedef {{body: string, X: number[], where: string}} Place */
/**
 * @typedef {object} Goal as `task_view` tells it
 * @property {Place[]} places
 * @property {Record<string, Shape>} shapes
 * @property {number} positionMm
 * @property {number} orientationDeg
 */
/** @typedef {{place: Place, positionMm: number, orientationDeg: number, share: number}} Missing */

/**
 * Return the place of a goal that counts and how far it is missed there; null where nothing is known of its objects.
 * @param {Goal} goal @param {number} zeroAt tolerances from which nothing is earned @param {(body: string) => Pose | undefined} poseOf
 * @returns {Missing | null}
 */
export function missing(goal, zeroAt, poseOf) {
  /** @type {Missing | null} */
  let best = null;
  for (const place of goal.places) {
    const X = poseOf(place.body);
    if (!X) continue;
    const found = { place, ...missedBy(goal.shapes[place.body], X, poseFrom(place.X), goal, zeroAt) };
    if (!best || before([found.share, -found.positionMm, -found.orientationDeg], [best.share, -best.positionMm, -best.orientationDeg])) best = found;
  }
  return best;
}

/**
 * Return by how much a pose misses another: over all turns after which the shape looks the same.
 * @param {Shape} shape @param {Pose} X_WO @param {Pose} X_WG @param {{positionMm: number, orientationDeg: number}} allowed @param {number} zeroAt
 */
export function missedBy(shape, X_WO, X_WG, allowed, zeroAt) {
  let best = { positionMm: Infinity, orientationDeg: Infinity, share: -1 };
  for (const turn of shape.turns) {
    const X = compose(X_WO, poseFrom(turn));
    const [p, q] = [applied(X, shape.foot), applied(X_WG, shape.foot)];
    const positionMm = rounded(1000 * Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    const orientationDeg = rounded((180 / Math.PI) * (shape.axis ? between(turned(X, shape.axis), turned(X_WG, shape.axis)) : turnBetween(X, X_WG)));
    const share = Math.min(shareOf(positionMm, allowed.positionMm, zeroAt), shareOf(orientationDeg, allowed.orientationDeg, zeroAt));
    if (before([share, -orientationDeg, -positionMm], [best.share, -best.orientationDeg, -best.positionMm])) best = { positionMm, orientationDeg, share };
  }
  return best;
}

/** Return whether a row is better than another, by its first number that differs. @param {number[]} row @param {number[]} other */
function before(row, other) {
  const index = row.findIndex((value, k) => value !== other[k]);
  return index >= 0 && row[index] > other[index];
}

/** @param {number} error @param {number} allowed @param {number} zeroAt */
function shareOf(error, allowed, zeroAt) {
  return Math.min(1, Math.max(0, (zeroAt * allowed - error) / ((zeroAt - 1) * allowed)));
}

/** @param {number} value */
function rounded(value) {
  return Math.round(100 * value) / 100;
}

/** @param {Pose} X @param {number[]} p */
function applied(X, p) {
  const [x, y, z] = turned(X, p);
  return [x + X[12], y + X[13], z + X[14]];
}

/** @param {Pose} X @param {number[]} v */
function turned(X, v) {
  return [0, 1, 2].map((row) => X[row] * v[0] + X[row + 4] * v[1] + X[row + 8] * v[2]);
}

/** @param {number[]} a @param {number[]} b both of length 1 */
function between(a, b) {
  return Math.acos(Math.min(1, Math.max(-1, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])));
}

/** Return the angle of the turn from one pose to another [rad]. @param {Pose} X @param {Pose} Y */
function turnBetween(X, Y) {
  let trace = 0;
  for (let column = 0; column < 3; column++) for (let row = 0; row < 3; row++) trace += X[row + 4 * column] * Y[row + 4 * column];
  return Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2)));
}
