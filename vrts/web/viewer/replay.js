// The state of a recorded run at any time. No drawing here, no clock: time is an argument.

import { armFrames } from "./kinematics.js";
import { compose, poseFrom } from "./poses.js";
import { Timeline } from "./timeline.js";

/** @typedef {import("./poses.js").Pose} Pose */

/**
 * @typedef {object} State what the viewer draws; a live feed builds the same
 * @property {number} t [s]
 * @property {Float64Array} q six joint positions [rad], then the hand opening [m]
 * @property {Float64Array} v their rates
 * @property {Pose[]} X_WL links 0..6
 * @property {Pose} X_WF flange
 * @property {Pose} X_WT tool
 * @property {Map<string, Pose>} bodies movable bodies
 * @property {string[]} held names of the bodies in the hand
 */

/**
 * @typedef {object} PlacementData
 * @property {number} start [s]
 * @property {number} end [s]
 * @property {"resting"|"held"|"falling"|"toppled"} lie
 * @property {number[]} X twelve numbers: in the flange frame while held, else in the world
 */

/**
 * @typedef {object} RunData
 * @property {number} horizon [s]
 * @property {number} gravity [m/s^2]
 * @property {{start: number, end: number}[]} motions
 * @property {import("./timeline.js").SegmentData} segments
 * @property {Record<string, PlacementData[]>} placements by body
 * @property {{start: number, X: number[]}[]} tools the tool in force, by time
 * @property {[number, number][]} lines (time [s], source line), by time
 * @property {[number, number][]} processLines the same of the process control program
 * @property {{signal: number, on: [number, number][]}[]} signals when each was on [s]
 */

/**
 * Return the last entry whose start is not after a time; the first when there is none.
 * @template T
 * @param {T[]} entries in time order
 * @param {(entry: T) => number} start
 * @param {number} t
 * @returns {T}
 */
export function latest(entries, start, t) {
  let low = 0;
  let high = entries.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (start(entries[middle]) <= t) low = middle;
    else high = middle - 1;
  }
  return entries[low];
}

/** A run as data, to be asked for any time. */
export class Replay {
  /**
   * @param {import("./kinematics.js").Arm} arm
   * @param {RunData} run
   */
  static async unpack(arm, run) {
    return new Replay(arm, run, await Timeline.unpack(run.segments));
  }

  /**
   * @param {import("./kinematics.js").Arm} arm
   * @param {RunData} run
   * @param {Timeline} timeline
   */
  constructor(arm, run, timeline) {
    this.arm = arm;
    this.run = run;
    this.timeline = timeline;
    this.end = run.horizon;
    this.tools = run.tools.map(({ start, X }) => ({ start, X: poseFrom(X) }));
    this.placements = Object.entries(run.placements).map(([body, list]) => ({
      body,
      list: list.map((placement) => ({ ...placement, X: poseFrom(placement.X) })),
    }));
  }

  /**
   * Return the state at a time, forward or backward.
   * @param {number} t [s]
   * @returns {State}
   */
  at(t) {
    const { position, velocity } = this.timeline.at(t);
    const { X_BL, X_BF } = armFrames(this.arm, position);
    const bodies = new Map();
    /** @type {string[]} */
    const held = [];
    for (const { body, list } of this.placements) {
      const placement = latest(list, (entry) => entry.start, t);
      bodies.set(body, this.bodyPose(placement, X_BF, t));
      if (placement.lie === "held") held.push(body);
    }
    const X_FT = latest(this.tools, (tool) => tool.start, t).X;
    return {
      t, q: position, v: velocity, X_WL: X_BL, X_WF: X_BF, X_WT: compose(X_BF, X_FT), bodies, held,
    };
  }

  /**
   * @param {{start: number, lie: string, X: Pose}} placement
   * @param {Pose} X_WF
   * @param {number} t
   * @returns {Pose}
   */
  bodyPose(placement, X_WF, t) {
    if (placement.lie === "held") return compose(X_WF, placement.X);
    if (placement.lie !== "falling") return placement.X;
    const X = placement.X.slice();
    X[14] -= 0.5 * this.run.gravity * (t - placement.start) ** 2;
    return X;
  }

  /**
   * Return the source line at work at a time, or 0.
   * @param {number} t [s]
   */
  line(t, lines = this.run.lines) {
    if (!lines.length || t < lines[0][0]) return 0;
    return latest(lines, (entry) => entry[0], t)[1];
  }
}
