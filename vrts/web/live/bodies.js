// Where movable bodies are at any recent time: carried, resting, or on their way down.

import { compose, poseFrom } from "../viewer/poses.js";

const GRAVITY = 9.81; // [m/s^2]
const KEPT = 5; // how long what is over is kept [s]

/** @typedef {import("./protocol.js").Placed} Placed */
/** @typedef {import("../viewer/poses.js").Pose} Pose */
/** @typedef {{start: number, lie: string, X: Pose}} Row */

/** The placements of every movable body, in time order. */
export class Bodies {
  constructor() {
    /** @type {Map<string, Row[]>} */
    this.tracks = new Map();
  }

  /** @param {Placed[]} rows everything that is known now */
  reset(rows) {
    this.tracks.clear();
    this.add(rows);
  }

  /** Take rows that are new; what had been expected after them does not happen. @param {Placed[]} rows */
  add(rows) {
    /** @type {Map<string, Row[]>} */
    const fresh = new Map();
    for (const { body, start, lie, X } of rows) fresh.set(body, [...(fresh.get(body) ?? []), { start, lie, X: poseFrom(X) }]);
    for (const [body, list] of fresh) {
      list.sort((a, b) => a.start - b.start);
      const before = (this.tracks.get(body) ?? []).filter((row) => row.start < list[0].start - 1e-9);
      this.tracks.set(body, [...before, ...list]);
    }
  }

  /**
   * Return the poses at a time, and the bodies in the hand.
   * @param {number} t [s] @param {Pose} X_WF flange
   * @returns {{poses: Map<string, Pose>, held: string[]}}
   */
  at(t, X_WF) {
    /** @type {Map<string, Pose>} */
    const poses = new Map();
    /** @type {string[]} */
    const held = [];
    for (const [body, track] of this.tracks) {
      while (track.length > 1 && track[1].start < t - KEPT) track.shift();
      const row = track.findLast((one) => one.start <= t) ?? track[0];
      if (!row) continue;
      poses.set(body, posed(row, X_WF, t));
      if (row.lie === "held") held.push(body);
    }
    return { poses, held };
  }
}

/** @param {Row} row @param {Pose} X_WF @param {number} t */
function posed(row, X_WF, t) {
  if (row.lie === "held") return compose(X_WF, row.X);
  if (row.lie !== "falling") return row.X;
  const X = row.X.slice();
  X[14] -= 0.5 * GRAVITY * Math.max(t - row.start, 0) ** 2;
  return X;
}
