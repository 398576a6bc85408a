// The past of the session in blocks of a minute, fetched as they are looked at and evaluated here.

import { compose, poseFrom } from "../../viewer/poses.js";
import { Replay, latest } from "../../viewer/replay.js";
import { Timeline } from "../../viewer/timeline.js";

export const BLOCK = 60; // [s], as the session cuts its past
const KEPT = 40; // blocks
const AT_ONCE = 2; // questions under way
const FRESH = 1_000; // how long a block that still grows is not asked for again [ms]
const PAUSE = 2_000; // after a question that failed [ms]

/**
 * @typedef {{t: number, kind: string, text: string, program: string, line: number}} Mark
 * @typedef {object} BlockData what the server sends
 * @property {number} begin from here on it answers [s]
 * @property {number} until up to here [s]
 * @property {boolean} whole it will not grow any more
 * @property {number} reaches the earliest time of which anything is known [s]
 * @property {number} gravity [m/s^2]
 * @property {import("../../viewer/timeline.js").SegmentData} segments
 * @property {Record<string, import("../../viewer/replay.js").PlacementData[]>} placements
 * @property {{start: number, X: number[]}[]} tools in force, in the flange frame
 * @property {{start: number, X: number[]}[]} bases how BASE says that the robot is displaced
 * @property {{program: string, line: number, text: string, at?: number}[]} steps `at`: line of the text that is rehearsed
 * @property {[number, number, boolean][]} lines from when [s], which step (-1: none), whether a program runs
 * @property {[number, number][]} outputs from when [s], bits
 * @property {Mark[]} marks
 * @property {number} leftOut rows of marks that are not told
 */

/** A stretch of the past that is here. */
export class Block {
  /** @param {import("../../viewer/kinematics.js").Arm} arm @param {BlockData} data */
  static async unpack(arm, data) {
    return new Block(arm, data, await Timeline.unpack(data.segments));
  }

  /** @param {import("../../viewer/kinematics.js").Arm} arm @param {BlockData} data @param {Timeline} timeline */
  constructor(arm, data, timeline) {
    this.data = data;
    this.came = performance.now();
    const { gravity, segments, placements, tools } = data;
    this.replay = new Replay(arm, {
      horizon: data.until, gravity, segments, placements, tools, motions: [], lines: [], processLines: [], signals: [],
    }, timeline);
    this.bases = data.bases.map(({ start, X }) => ({ start, X: poseFrom(X) }));
  }

  /** Return what was at a time, the nearest that is known. @param {number} t [s] */
  at(t) {
    const inside = Math.min(Math.max(t, this.data.begin), this.data.until);
    const state = this.replay.at(inside);
    const [, number, running] = latest(this.data.lines, ([start]) => start, inside);
    return {
      state,
      outputs: latest(this.data.outputs, ([start]) => start, inside)[1],
      step: number < 0 ? null : this.data.steps[number],
      running,
      moving: state.v.some((rate) => Math.abs(rate) > 1e-9),
      X_VT: compose(latest(this.bases, ({ start }) => start, inside).X, state.X_WT),
    };
  }
}

/** Fetches blocks and keeps the last ones. */
export class Blocks {
  /**
   * @param {() => string} where address of the session's past, to which the number is added; empty: none
   * @param {() => import("../../viewer/kinematics.js").Arm | undefined} arm
   * @param {() => void} changed called whenever a block has come, or does not come
   */
  constructor(where, arm, changed) {
    this.where = where;
    this.arm = arm;
    this.changed = changed;
    /** @type {Map<number, Block>} */
    this.kept = new Map();
    /** @type {Map<number, Promise<Block | null>>} */
    this.coming = new Map();
    /** @type {Map<number, number>} by block: until when it is not asked for again [ms] */
    this.failed = new Map();
    this.reaches = 0; // the earliest time of which anything is known [s]
    this.problem = ""; // why the last question had no answer
    this.wanted = -1;
    this.era = 0;
  }

  /** Session time has jumped: what was known is of another past. */
  forget() {
    this.era++;
    this.kept.clear();
    this.coming.clear();
    this.failed.clear();
    this.reaches = 0;
    this.wanted = -1;
  }

  /**
   * Return the block of a time if it is here; ask for it where it is not, or has grown.
   * @param {number} t [s]
   * @returns {Block | null}
   */
  of(t) {
    const number = Math.floor(t / BLOCK);
    const block = this.kept.get(number) ?? null;
    if (block) {
      this.kept.delete(number);
      this.kept.set(number, block); // the last one is the one that was looked at last
    }
    const stale = block && !block.data.whole && t > block.data.until && performance.now() - block.came > FRESH;
    if (!block || stale) this.want(number);
    return block;
  }

  /** Ask for a block when there is room; of those that wait the last one counts. @param {number} number */
  want(number) {
    if (this.coming.has(number) || performance.now() < (this.failed.get(number) ?? 0)) return;
    if (this.coming.size >= AT_ONCE) this.wanted = number;
    else void this.fetched(number);
  }

  /**
   * Return a block once it is here; null when it cannot be had.
   * @param {number} number
   * @returns {Promise<Block | null>}
   */
  fetched(number) {
    const known = this.kept.get(number);
    if (known?.data.whole) return Promise.resolve(known);
    const under = this.coming.get(number);
    if (under) return under;
    const era = this.era;
    const promise = this.ask(number).catch((error) => {
      if (era === this.era) {
        this.problem = error.message;
        this.failed.set(number, performance.now() + PAUSE);
      }
      return null;
    }).then((block) => {
      if (era !== this.era) return null;
      this.coming.delete(number);
      if (block) this.keep(number, block);
      const next = this.wanted;
      this.wanted = -1;
      if (next >= 0 && !this.kept.get(next)?.data.whole) this.want(next);
      this.changed();
      return block;
    });
    this.coming.set(number, promise);
    return promise;
  }

  /** @param {number} number @returns {Promise<Block>} */
  async ask(number) {
    const [where, arm] = [this.where(), this.arm()];
    if (!where || !arm) throw new Error("there is no session to look at");
    const answer = await fetch(`${where}/${number}`);
    const data = await answer.json();
    if (!answer.ok) throw new Error(data.text);
    return Block.unpack(arm, data);
  }

  /** @param {number} number @param {Block} block */
  keep(number, block) {
    this.kept.delete(number);
    this.kept.set(number, block);
    this.failed.delete(number);
    this.problem = "";
    this.reaches = Math.max(this.reaches, block.data.reaches);
    for (const old of this.kept.keys()) if (this.kept.size > KEPT) this.kept.delete(old);
  }
}
