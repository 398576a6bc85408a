// Between frames: what to show at any instant of the screen, one frame behind what has come.

const KEPT = 40; // frames
const DRIFT = 0.002; // by which a clock may run slow against the other [s/s]
const LONGEST_DELAY = 0.25; // [s]
const JUMP = 1; // a frame further off than this begins again [s]

/** @typedef {import("./frame.js").PoseFrame} PoseFrame */
/** @typedef {{t: number, joints: Float64Array, hand: number, outputs: number, flags: number}} Shown */

/** Remembers the last frames and the offset between the session's clock and the page's. */
export class Motion {
  constructor() {
    /** @type {PoseFrame[]} */
    this.frames = [];
    this.offset = Infinity; // page's clock minus session time, least delay seen [s]
    this.period = 0.02; // between frames [s]
    this.jitter = 0; // [s]
    this.heard = 0;
    this.shown = -Infinity;
  }

  /** Forget all, as when session time jumps. */
  clear() {
    Object.assign(this, new Motion());
  }

  /**
   * Take a frame; one that is older than the last does not count.
   * @param {PoseFrame} frame @param {number} now of the page's clock [s]
   */
  add(frame, now) {
    const last = this.frames.at(-1);
    if (last && (frame.session !== last.session || Math.abs(frame.time - last.time) > JUMP)) this.clear();
    else if (last && frame.time <= last.time) return;
    else if (last) {
      const gap = frame.time - last.time; // at rest frames are seldom; from one beat to the next they are not
      this.period = gap < this.period / 2 ? gap : this.period + 0.1 * (gap - this.period);
    }
    const offset = now - frame.time;
    this.offset = Math.min(offset, this.offset + DRIFT * Math.max(now - this.heard, 0));
    this.jitter += 0.05 * (offset - this.offset - this.jitter);
    this.heard = now;
    this.frames.push(frame);
    if (this.frames.length > KEPT) this.frames.shift();
  }

  /**
   * Return what to show; null before the first frame.
   * @param {number} now of the page's clock [s]
   * @returns {Shown | null}
   */
  at(now) {
    const last = this.frames.at(-1);
    if (!last) return null;
    const delay = Math.min(this.period + 2 * this.jitter, LONGEST_DELAY);
    const t = Math.min(Math.max(now - this.offset - delay, this.shown), last.time);
    this.shown = t;
    let index = this.frames.length - 1;
    while (index > 0 && this.frames[index].time > t) index--;
    const [a, b] = [this.frames[index], this.frames[Math.min(index + 1, this.frames.length - 1)]];
    const share = b.time > a.time ? Math.min(Math.max((t - a.time) / (b.time - a.time), 0), 1) : 0;
    const joints = Float64Array.from(a.joints, (q, joint) => q + share * (b.joints[joint] - q));
    return { t, joints, hand: a.hand + share * (b.hand - a.hand), outputs: a.outputs, flags: a.flags };
  }
}
