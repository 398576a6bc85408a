// The rehearsal's own time line: a slider over the whole run, what happens in it, and playing.

import { button, make, write } from "../dom.js";
import { goByKey, slideByKey, speeds } from "../past/line.js";
import { seconds } from "./phase.js";

const TINY = 1e-3; // by which the next mark is later [s]

/** @typedef {import("./phase.js").Moment} Moment */
/** @typedef {{seek: (t: number) => void, play: () => void, speed: (speed: number) => void, live: () => void}} Wishes */

/** Return the next of some marks, or the one before. @param {Moment[]} marks in time order @param {number} t [s] @param {1 | -1} direction */
export function nextMark(marks, t, direction) {
  return direction > 0 ? marks.find((one) => one.time_s > t + TINY) : marks.findLast((one) => one.time_s < t - TINY);
}

/** The time line's elements. */
export class Track {
  /** @param {HTMLElement} after element under which it stands @param {Wishes} wishes */
  constructor(after, wishes) {
    this.wishes = wishes;
    this.range = { begin: 0, end: 1 };
    /** @type {Moment[]} */
    this.marks = [];
    this.slider = make("input", {
      type: "range", id: "rehearsal-time", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time of the rehearsal",
      input: () => wishes.seek(Number(this.slider.value)), keydown: (/** @type {KeyboardEvent} */ event) => slideByKey(event, Number(this.slider.value), 1,
        { seek: wishes.seek, home: () => wishes.seek(this.range.begin), end: () => wishes.seek(this.range.end) }),
    });
    this.lane = make("div", { class: "past-marks", "aria-hidden": "true" });
    this.clock = make("output", { class: "past-clock", id: "rehearsal-clock", for: "rehearsal-time", "aria-live": "off" });
    this.play = button("Play", wishes.play, { id: "rehearsal-play", class: "rehearsal-play", title: "Play from here, or stand still (space)" });
    const speed = speeds({ "aria-label": "Speed of the picture", title: "Speed of the picture", class: "rehearsal-speed", change: () => wishes.speed(Number(speed.value)) });
    this.place = make("div", { class: "past rehearsal-track", id: "rehearsal-track", role: "group", "aria-label": "Time line of the rehearsal" },
      make("span", { class: "tag rehearsal-tag", text: "Rehearsal" }), this.play,
      make("div", { class: "past-track" }, this.slider, this.lane), this.clock, speed,
      button("Live", wishes.live, { id: "rehearsal-live", class: "past-live", title: "Back to what is now (Alt+L)", "aria-label": "Back to live" }));
    this.place.addEventListener("keydown", (event) => goByKey(event, { jump: (direction) => this.jump(direction), play: wishes.play }));
    after.after(this.place);
  }

  /** Go to the next mark, or to the one before. @param {1 | -1} direction */
  jump(direction) {
    const mark = nextMark(this.marks, Number(this.slider.value), direction);
    if (mark) this.wishes.seek(mark.time_s);
  }

  /** Another run. @param {import("./picture.js").Range} range @param {Moment[]} marks */
  begin(range, marks) {
    this.range = range;
    this.marks = [...marks].sort((a, b) => a.time_s - b.time_s);
    const length = Math.max(range.end - range.begin, 1e-3);
    Object.assign(this.slider, { min: String(range.begin), max: String(range.begin + length) });
    this.lane.replaceChildren(...this.marks.map(({ time_s, kind, text }) => {
      const sign = make("i", { class: `past-mark is-${kind}`, title: text });
      sign.style.left = `${(100 * (time_s - range.begin)) / length}%`;
      return sign;
    }));
  }

  /** @param {number} t [s] @param {boolean} playing @param {string} where in words */
  show(t, playing, where) {
    const { begin, end } = this.range;
    const value = String(t);
    if (this.slider.value !== value) this.slider.value = value;
    const told = `${seconds(t - begin)} of ${seconds(end - begin)}`;
    write(this.clock, told);
    const said = where ? `${told}, ${where}` : told;
    if (!playing && this.slider.getAttribute("aria-valuetext") !== said) this.slider.setAttribute("aria-valuetext", said);
    write(this.play, playing ? "Pause" : "Play");
  }
}
