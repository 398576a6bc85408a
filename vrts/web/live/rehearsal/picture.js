// The picture while it shows a rehearsal: which moment, playing on, and the sign that says so.

import { components } from "../../viewer/poses.js";
import { byId, make, write } from "../dom.js";
import { MOVING, RUNNING } from "../frame.js";
import { backToLive, lookAtOther, tellThen } from "../looking.js";
import { BLOCK } from "../past/blocks.js";
import { RehearsedBlocks } from "./link.js";

const LONGEST_GLIDE = 1.2; // of a step, however long it takes [s]
const AHEAD = 10; // of what is played the next block is fetched so early [s]
const ROUNDED = 0.0005; // by which times of contacts are off [s]
const STILL = window.matchMedia("(prefers-reduced-motion: reduce)");

/** @typedef {{begin: number, end: number}} Range [s] */

/** Shows one rehearsal in the world. */
export class Picture {
  /**
   * @param {import("../world.js").World} world @param {import("./link.js").Link} link
   * @param {{moment: (t: number) => void, left: () => void}} told
   */
  constructor(world, link, told) {
    this.world = world;
    this.told = told;
    this.blocks = new RehearsedBlocks(link, () => world.viewer?.data.robot.arm);
    this.t = 0; // [s]
    /** @type {Range} */
    this.range = { begin: 0, end: 0 };
    /** @type {{to: number, rate: number, plays: boolean} | null} where it goes by itself */
    this.way = null;
    this.before = 0; // the page's clock at the last picture [ms]
    /** @type {ReturnType<import("../past/blocks.js").Block["at"]> | null} */
    this.seen = null;
    /** @type {{time_s: number, program: string, line: number, text: string, over: boolean} | null} where it stands */
    this.place = null;
    /** @type {import("../protocol.js").Contact[]} */
    this.contacts = [];
    /** @type {import("../protocol.js").Contact[]} */
    this.near = [];
    this.speed = 1;
    this.shown = false;
    this.sign = make("div", { class: "past-sign rehearsal-sign", id: "rehearsal-sign", hidden: true },
      make("span", {}, "Rehearsal", make("span", { class: "rehearsal-alone", text: ": nobody else sees this" })),
      make("button", { type: "button", class: "main", id: "rehearsal-leave", text: "Back to live", title: "Alt+L", click: backToLive }));
    this.said = make("span", { class: "unseen", role: "status" });
    byId("view").append(this.sign, this.said);
  }

  /** Where it stands, if that is what the picture shows. */
  get stands() {
    return this.place && Math.abs(this.place.time_s - this.t) < 1e-6 ? this.place : null;
  }

  get playing() {
    return Boolean(this.way?.plays);
  }

  /** Another rehearsal: nothing of the one before counts. @param {Range} range @param {import("./phase.js").Ready} ready */
  begin(range, { contacts, near }) {
    this.blocks.forget();
    const wider = (/** @type {import("../protocol.js").Contact} */ one) => ({ ...one, start: one.start - ROUNDED, end: one.end + ROUNDED });
    Object.assign(this, { range, contacts: contacts.map(wider), near: near.map(wider), way: null, seen: null, place: null, t: range.begin });
  }

  /** Show the rehearsal instead of the room. @param {() => boolean} wanted whether it still is @returns {Promise<boolean>} whether it is shown */
  async show(wanted) {
    if (this.shown) return true;
    const block = this.blocks.of(this.t) ?? await this.blocks.fetched(Math.floor(this.t / BLOCK));
    if (!block || !wanted()) return false;
    if (this.shown) return true;
    this.seen = block.at(this.t);
    lookAtOther(() => this.leave());
    this.shown = true;
    this.mark(true);
    this.world.instead = { seen: () => this.tick(), contacts: this.contacts, near: this.near };
    return true;
  }

  leave() {
    this.shown = false;
    this.way = null;
    this.world.instead = null;
    this.mark(false);
    tellThen(null);
    this.told.left();
  }

  /** @param {boolean} shown */
  mark(shown) {
    document.body.classList.toggle("rehearses", shown);
    this.sign.hidden = !shown;
    write(this.said, shown ? "The picture shows a rehearsal: nobody else sees this" : "The picture shows the room");
  }

  /** Show a moment at once. @param {number} t [s] */
  seek(t) {
    this.way = null;
    this.put(t);
  }

  /** Go to a moment so that one sees the way, where motion is welcome. @param {number} t [s] */
  glide(t) {
    const far = Math.abs(t - this.t);
    if (STILL.matches || !this.shown || far < 1e-6) return this.seek(t);
    this.start(t, Math.max(far / LONGEST_GLIDE, 1), false);
  }

  /** Play on from here, or stand still. */
  toggle() {
    if (this.playing) this.way = null;
    else {
      if (this.t >= this.range.end - 1e-6) this.put(this.range.begin);
      this.start(this.range.end, 1, true);
    }
    this.told.moment(this.t);
  }

  /** @param {number} to [s] @param {number} rate @param {boolean} plays */
  start(to, rate, plays) {
    this.way = { to, rate, plays };
    this.before = performance.now();
  }

  /** @param {number} t [s] */
  put(t) {
    this.t = Math.min(Math.max(t, this.range.begin), this.range.end);
    const block = this.blocks.kept.get(Math.floor(this.t / BLOCK));
    if (block) this.seen = block.at(this.t);
    this.told.moment(this.t);
  }

  /** Return what the picture shows now. */
  tick() {
    const at = performance.now();
    if (this.way) {
      const { to, rate, plays } = this.way;
      const way = (rate * (plays ? this.speed : 1) * (at - this.before)) / 1000;
      const t = Math.abs(to - this.t) <= way ? to : this.t + Math.sign(to - this.t) * way;
      if (t === to) this.way = null;
      this.put(t);
    }
    this.before = at;
    const block = this.blocks.of(this.t);
    if (block) {
      this.seen = block.at(this.t);
      if (this.playing && this.t + AHEAD > block.data.until && block.data.until < this.range.end) this.blocks.want(Math.floor(this.t / BLOCK) + 1);
      tellThen(this.then(this.seen));
    }
    const { seen } = this;
    if (!seen) return null;
    return { state: { ...seen.state, t: this.t }, outputs: seen.outputs, flags: (seen.running && !this.stands?.over ? RUNNING : 0) | (seen.moving ? MOVING : 0) };
  }

  /** Return what is then as a status shows it. @param {NonNullable<Picture["seen"]>} one @returns {import("../looking.js").Then} */
  then({ state, step, running, moving, X_VT }) {
    const { program, line, text } = this.stands ?? { program: step?.program ?? "", line: step?.at ?? 0, text: step?.text ?? "" };
    return {
      location: components(X_VT), mode: running && !this.stands?.over ? "running" : moving ? "moving" : "idle", program, line, text, held: state.held[0] ?? "", contacts: this.contacts.filter(({ start }) => start <= state.t).length,
    };
  }
}
