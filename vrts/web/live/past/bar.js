// The time line under the picture: a slider over the past, jumps, play, and the way back to live.

import { beside, drawing, make, write } from "../dom.js";
import { enable } from "../focus.js";
import { goByKey, slideByKey, speeds } from "./line.js";
import { JUMPS } from "./marks.js";

const MOST_DRAWN = 240; // marks
const SPANS = /** @type {[string, string][]} */ ([["60", "1 min"], ["600", "10 min"], ["3600", "1 h"], ["all", "All"]]);
const ICONS = {
  before: "M3 3h2v10H3zM13 3v10L6 8z", after: "M11 3h2v10h-2zM3 3v10l7-5z", play: "M4 2.5v11L13 8z", pause: "M4 3h3v10H4zM9 3h3v10H9z",
  menu: "M7 2h2v2.6H7zM7 6.7h2v2.6H7zM7 11.4h2V14H7z",
};

/** @typedef {{seek: (t: number) => void, live: () => void, jump: (direction: 1 | -1) => void, play: () => void, branch: () => void, redraw: () => void}} Wishes */
/** @typedef {{now: number, t: number | null, reaches: number, loading: boolean, playing: boolean, problem: string}} Shown */

/** Return how long ago something was, in words. @param {number} seconds */
export function ago(seconds) {
  if (seconds < 100) return `${Math.max(seconds, 0).toFixed(1)} s ago`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 100) return `${minutes} min ${Math.floor(seconds % 60)} s ago`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min ago`;
}

/** Return a session time as people read it. @param {number} t [s] */
export function clock(t) {
  const two = (/** @type {number} */ n) => String(Math.floor(n)).padStart(2, "0");
  return `${two(t / 3600)}:${two((t / 60) % 60)}:${two(t % 60)}`;
}

/** The bar's elements; it knows no session. */
export class Bar {
  /** @param {HTMLElement} place @param {Wishes} wishes */
  constructor(place, wishes) {
    this.wishes = wishes;
    this.dragged = false;
    this.range = { min: 0, max: 1 };
    this.slider = make("input", {
      type: "range", id: "past-time", min: 0, max: 1, step: 0.01, value: 1, "aria-label": "Time of the session",
      input: () => this.slid(),
      pointerdown: () => (this.dragged = true), pointerup: () => (this.dragged = false), pointercancel: () => (this.dragged = false),
      keydown: (/** @type {KeyboardEvent} */ event) => slideByKey(event, Number(this.slider.value), 10, { seek: wishes.seek, home: () => wishes.seek(this.range.min), end: wishes.live }),
    });
    this.lane = make("div", { class: "past-marks", "aria-hidden": "true" });
    this.kept = make("span", { class: "past-kept", hidden: true });
    this.hour = make("span");
    this.ago = make("span");
    this.clock = make("output", { class: "past-clock", id: "past-clock", for: "past-time", "aria-live": "off" }, this.hour, " ", this.ago);
    this.playing = icon("play", "Play the past (space)", wishes.play, "past-play");
    this.jumps = make("select", { id: "past-jump", "aria-label": "What to jump to" }, ...Object.entries(JUMPS)
      .map(([value, [text]]) => make("option", { value, text })));
    this.spans = make("select", { id: "past-span", "aria-label": "How much of the past the slider shows", title: "How much the slider shows", change: wishes.redraw },
      ...SPANS.map(([value, text]) => make("option", { value, text, selected: value === "600" })));
    this.speeds = speeds({ id: "past-speed", "aria-label": "Speed of the replay", title: "Speed of the replay" });
    this.branches = ["past-branch", "past-branch-2"].map((id) => make("button", { type: "button", id, class: "past-branch", text: "Go on from here", title: "Go on from this moment in a room of your own", click: wishes.branch }));
    this.live = make("button", { type: "button", id: "past-live", class: "past-live", text: "Live", title: "Back to what is now (Alt+L)", "aria-label": "Back to live", click: wishes.live });
    const named = (/** @type {string} */ text, /** @type {HTMLElement} */ what) => make("span", { class: "past-choice" }, make("span", { "aria-hidden": "true", text }), what);
    const more = make("div", { class: "menu past-more", id: "past-more", popover: "", role: "group", "aria-label": "Choices of the time line" },
      named("Jump to", this.jumps), named("Slider shows", this.spans), named("Speed", this.speeds), this.branches[1]);
    const menu = make("button", { type: "button", id: "past-menu", class: "past-icon", popovertarget: more.id, title: "Choices of the time line", "aria-label": "Choices of the time line" });
    menu.append(drawing(ICONS.menu));
    beside(menu, more);
    place.classList.add("past");
    place.setAttribute("role", "group");
    place.setAttribute("aria-label", "Time line");
    place.replaceChildren(
      icon("before", "One before (comma)", () => wishes.jump(-1), "past-before"), this.playing, icon("after", "Next one (full stop)", () => wishes.jump(1), "past-after"),
      make("div", { class: "past-track" }, this.slider, this.lane, this.kept),
      this.clock, menu, more, this.branches[0], this.live,
    );
    place.addEventListener("keydown", (event) => goByKey(/** @type {KeyboardEvent} */ (event), wishes));
  }

  get speed() {
    return Number(this.speeds.value);
  }

  slid() {
    const t = Number(this.slider.value);
    if (t >= this.range.max - 1e-9) this.wishes.live();
    else this.wishes.seek(t);
  }

  /** Show where on the time line one is. @param {Shown} shown */
  show({ now, t, reaches, loading, playing, problem }) {
    const span = this.spans.value === "all" ? Infinity : Number(this.spans.value);
    if (!this.dragged) {
      const min = Math.max(reaches, now - span, 0);
      this.range = { min: t === null ? min : Math.min(min, Math.max(t, reaches)), max: Math.max(now, min + 0.1) };
    }
    const { min, max } = this.range;
    Object.assign(this.slider, { min: String(min), max: String(max) });
    const value = String(t ?? max);
    if (!this.dragged && this.slider.value !== value) this.slider.value = value;
    const words = t === null ? "live" : ago(now - t);
    const said = t === null ? "live" : clock(t); // how long ago changes all the time
    if (this.slider.getAttribute("aria-valuetext") !== said) this.slider.setAttribute("aria-valuetext", said);
    write(this.hour, clock(t ?? now));
    write(this.ago, words);
    this.slider.setAttribute("aria-busy", String(loading));
    for (const one of [this.live, ...this.branches]) enable(one, t !== null);
    write(this.kept, problem || `kept from ${clock(reaches)} on`);
    this.kept.hidden = !problem && (reaches === 0 || min > reaches);
    if (this.playing.dataset.shows !== String(playing)) {
      this.playing.dataset.shows = String(playing);
      this.playing.replaceChildren(drawing(playing ? ICONS.pause : ICONS.play));
      this.playing.setAttribute("aria-label", playing ? "Pause" : "Play the past");
    }
  }

  /** Draw marks; of those at the same place one. @param {import("./marks.js").Mark[]} marks */
  mark(marks) {
    const { min, max } = this.range;
    /** @type {Map<string, import("./marks.js").Mark>} */
    const places = new Map();
    for (const mark of marks) {
      const rank = mark.kind === "contact" || mark.kind === "panic" || mark.kind === "said" ? mark.kind : "";
      places.set(`${Math.round((400 * (mark.t - min)) / (max - min))} ${rank}`, mark);
    }
    this.lane.replaceChildren(...[...places.values()].slice(-MOST_DRAWN).map((mark) => {
      const sign = make("i", { class: `past-mark is-${mark.kind}` });
      sign.style.left = `${(100 * (mark.t - min)) / (max - min)}%`;
      return sign;
    }));
  }
}

/** @param {keyof typeof ICONS} name @param {string} title @param {() => void} click @param {string} id */
function icon(name, title, click, id) {
  const made = make("button", { type: "button", id, class: "past-icon", title, "aria-label": title.replace(/ \(.*/, ""), click });
  made.append(drawing(ICONS[name]));
  return made;
}
