// What graders say: marks along the time bar, notes while their moments pass, words at their lines.

import { inGroups, readComments, shortly } from "./comments_read.js";

const SHORTEST = 2.5; // a note stays so long at least [s]
const LONGEST = 8; // and so long at most [s]
const READ = 18; // characters that are read in a second
const BEFORE = 0.05; // a note comes this much before its moment [s]
const MOST = 2; // notes at once
const SAME = 1e-3; // times that are nearer are the same [s]
const WIDE = 26; // [px] of a mark with its gap
const PICTURE = "M2.5 1h11A1.5 1.5 0 0 1 15 2.5v7a1.5 1.5 0 0 1-1.5 1.5H9.2L6 14.6V11H2.5A1.5 1.5 0 0 1 1 9.5v-7A1.5 1.5 0 0 1 2.5 1z";
const SVG = "http://www.w3.org/2000/svg";

/** @typedef {import("./comments_read.js").Comment} Comment */
/** @typedef {import("./comments_read.js").Timed} Timed */
/** @typedef {{jump: (t: number) => void, watch: (t: number) => void, end: number}} Acts */

/** Shows comments on the replay and in the program; which ones may change at any time. */
export class Comments {
  /** @param {Acts} acts */
  constructor(acts) {
    this.acts = acts;
    /** @type {Timed[]} */
    this.timed = [];
    /** @type {{button: HTMLElement, comments: Timed[]}[]} */
    this.marks = [];
    /** @type {HTMLElement[]} */
    this.atLines = [];
    this.t = 0; // that is shown [s]
    this.noted = "";
    this.notes = make("div", "noted");
    this.notes.setAttribute("role", "status");
    const overlay = document.getElementById("overlay");
    const below = make("div", "below");
    overlay?.replaceWith(below);
    if (overlay) below.append(overlay, this.notes);
    this.row = make("div", "lane told");
    this.row.setAttribute("role", "group");
    this.row.setAttribute("aria-label", "Comments of graders on the replay");
    this.band = make("div", "band");
    const name = make("span", "name", "Comments");
    name.setAttribute("aria-hidden", "true");
    this.row.append(name, this.band);
    this.row.hidden = true;
    document.getElementById("lanes")?.before(this.row);
    new ResizeObserver(() => this.arrange()).observe(this.row);
  }

  /** Show these comments and no others. @param {Comment[]} comments */
  set(comments) {
    this.timed = /** @type {Timed[]} */ (comments.filter((one) => one.t !== null && one.t <= this.acts.end + 1))
      .map((one) => ({ ...one, t: Math.min(one.t, this.acts.end) })).sort((a, b) => a.t - b.t);
    this.row.hidden = !this.timed.length;
    this.arrange();
    for (const old of this.atLines) old.remove();
    this.atLines = comments.flatMap((one) => {
      const line = one.line === null ? null : document.querySelector(`#source > #L${one.line}`);
      const box = line && this.card(one, "said");
      line?.append(/** @type {HTMLElement} */ (box));
      return box ? [box] : [];
    });
    this.noted = "";
  }

  /** Put the marks where there is room for each: what is too near stands in one. */
  arrange() {
    const width = this.band.clientWidth;
    const held = this.marks.findIndex(({ button }) => button === document.activeElement);
    const groups = width ? inGroups(this.timed, (WIDE * this.acts.end) / width) : [];
    this.marks = groups.map((comments) => ({ comments, button: this.mark(comments) }));
    this.band.replaceChildren(...this.marks.map(({ button }) => button));
    if (held >= 0) this.marks[Math.min(held, this.marks.length - 1)]?.button.focus({ preventScroll: true });
  }

  /** @param {Timed[]} comments */
  mark(comments) {
    const button = document.createElement("button");
    button.type = "button";
    const words = comments.map((one) => `${one.t.toFixed(1)} s: ${shortly(one.text)}`);
    button.title = words.join("\n");
    button.setAttribute("aria-label", `Comment at ${words.join("; at ")}`);
    button.style.left = `${(100 * comments[0].t) / (this.acts.end || 1)}%`;
    const picture = document.createElementNS(SVG, "svg");
    picture.setAttribute("viewBox", "0 0 16 16");
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", PICTURE);
    picture.append(path);
    button.append(picture);
    if (comments.length > 1) button.append(make("b", "", String(comments.length)));
    button.addEventListener("click", () => this.acts.jump((comments.find(({ t }) => t > this.t + SAME && comments[0].t <= this.t + SAME) ?? comments[0]).t));
    return button;
  }

  /**
   * Show the notes of a time: each comes at its moment and stays until it can be read. Who goes to
   * a moment sees what is said of it alone.
   * @param {number} t [s] @param {{speed: number, direction: number, playing: boolean}} how it is played
   */
  show(t, { speed, direction, playing }) {
    this.t = t;
    if (!this.timed.length && !this.noted) return;
    const exactly = playing ? [] : this.timed.filter((one) => Math.abs(one.t - t) < SAME);
    const present = exactly.length ? exactly : this.timed.filter((one) => {
      const passed = direction > 0 ? t - one.t : one.t - t;
      return passed >= -BEFORE && passed <= Math.min(Math.max(one.text.length / READ, SHORTEST), LONGEST) * Math.max(speed, 1);
    });
    for (const { button, comments } of this.marks) {
      if (comments.some((one) => present.includes(one))) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    }
    const shown = exactly.length || direction < 0 ? present.slice(0, MOST) : present.slice(-MOST);
    const key = shown.map((one) => this.timed.indexOf(one)).join();
    if (key === this.noted) return;
    this.noted = key;
    this.notes.replaceChildren(...shown.map((one) => this.card(one, "note")));
  }

  /** @param {Comment} comment @param {"note" | "said"} kind */
  card(comment, kind) {
    const box = make("div", kind);
    const words = make("p", "", comment.points ? `${comment.points}  ${comment.text}` : comment.text);
    words.dir = "auto";
    const more = [kind === "note" && comment.line ? `line ${comment.line}` : "", comment.hidden ? "not for the student" : ""].filter(Boolean);
    const about = make("p", "who");
    if (comment.who) about.append(make("bdi", "", comment.who), more.length ? " · " : "");
    about.append(more.join(" · "));
    const { t } = comment;
    if (t !== null && kind === "said") {
      const seek = document.createElement("button");
      seek.type = "button";
      seek.className = "seek";
      seek.textContent = `${t.toFixed(1)} s`;
      seek.title = `Show the replay at ${t.toFixed(1)} s`;
      seek.addEventListener("click", () => this.acts.watch(t));
      about.append(" ", seek);
    } else if (t !== null) about.append(` · ${t.toFixed(1)} s`);
    box.append(words, about);
    return box;
  }
}

/** Return what the page itself says of comments. */
export function ofPage() {
  return readComments(document.querySelectorAll("#graders > ul > li"));
}

/** @param {string} tag @param {string} kind @param {string} text */
function make(tag, kind, text = "") {
  const made = document.createElement(tag);
  if (kind) made.className = kind;
  made.textContent = text;
  return made;
}
