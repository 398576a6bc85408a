// Comments: on the program, a line of it, or the moment that is shown.

import { button, byId, make, write } from "../../live/dom.js";
import { inText, isolated } from "../../live/names.js";
import { missing, tooLong } from "../missing.js";
import { moment, when } from "../words.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Comment} Comment */

/**
 * Return a comment as it is shown.
 * @param {Desk} desk @param {Comment} comment @param {(time_s: number) => void} jump @param {string} place what is to be said of its line
 */
export function spoken(desk, comment, jump, place = "") {
  const box = make("div", { class: `comment${comment.private ? " private" : ""}` });
  const about = make("p", { class: "soft" }, isolated(comment.name || comment.who), `, ${when(comment.at)}`);
  if (place) about.append(" · ", make("b", { text: place }));
  if (comment.private) about.append(" · ", make("b", { text: "not for the student" }));
  if (comment.stale) about.append(" · ", make("b", { text: "about an earlier program" }));
  const time = comment.time_s;
  if (time !== null && time !== undefined) about.append(" · ", button(`at ${moment(time)}`, () => jump(time), { class: "jump" }));
  about.append(" ", button("Undo", () => void desk.undo([comment.record], "the comment"), { class: "jump", "aria-label": `Undo the comment of ${inText(comment.name || comment.who)}` }));
  box.append(make("p", { class: "said", dir: "auto", text: comment.text }), about);
  return box;
}

/** The comments that stand at no line, and where one writes. */
export class Comments {
  /** @param {Desk} desk @param {import("../frame.js").Replay} replay */
  constructor(desk, replay) {
    this.desk = desk;
    this.replay = replay;
    /** What was typed and not yet written, by student. @type {Map<string, string>} */
    this.drafts = new Map();
    this.of = "";
    /** @type {number | null} */
    this.picked = null;
    this.list = make("div", { class: "loose" });
    this.text = make("textarea", { id: "comment", rows: 2, dir: "auto", "aria-label": "Comment", placeholder: "Comment (C)" });
    this.line = place("line");
    this.time = place("moment");
    this.all = place("program");
    this.private = make("input", { type: "checkbox", id: "comment-private" });
    this.save = make("button", { class: "main", text: "Comment", title: "Comment (Ctrl+Enter)" });
    const form = make("form", { class: "write", novalidate: true },
      this.text,
      make("div", { class: "where", role: "radiogroup", "aria-label": "The comment is about" }, this.all.label, this.time.label, this.line.label),
      make("div", { class: "row" },
        make("label", { class: "check", title: "Only those who mark see it" }, this.private, "private"),
        make("span", { class: "fill" }), this.save));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.send();
    });
    this.text.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
        event.preventDefault();
        void this.send();
      }
    });
    this.text.addEventListener("input", () => this.drafts.set(this.of, this.text.value));
    byId("comments").append(this.list, form);
    desk.on(["chosen"], () => this.begin());
    desk.on(["detail"], () => this.fill());
    desk.on(["moment"], () => this.places());
  }

  /** Another program: what was typed for it before is there again. */
  begin() {
    this.of = this.desk.chosen;
    this.text.value = this.drafts.get(this.of) ?? "";
    this.all.input.checked = true;
    this.private.checked = false;
    this.list.replaceChildren();
    this.places();
  }

  fill() {
    const lines = this.desk.detail?.source?.lines.length ?? 0;
    const loose = (this.desk.detail?.comments ?? []).filter((comment) => !comment.line || comment.line > lines);
    const had = this.list.contains(document.activeElement);
    this.list.replaceChildren(...loose.map((comment) => spoken(this.desk, comment, (time) => this.replay.show(time), comment.line ? `on line ${comment.line}, which this program does not have` : "")));
    if (had) this.text.focus({ preventScroll: true }); // the comment that was undone is gone
  }

  /** Say where a comment would stand. */
  places() {
    const { line, moment: now } = this.desk;
    write(this.line.text, line ? `line ${line}` : "line –");
    write(this.time.text, now.time_s === null ? "moment" : moment(now.time_s));
    this.line.input.disabled = !line;
    this.time.input.disabled = now.time_s === null;
    if (line && line !== this.picked) this.line.input.checked = true;
    if (!line && this.line.input.checked) this.all.input.checked = true;
    this.picked = line;
  }

  /** Begin to write: at the line that was chosen, else at the moment that is shown. */
  write() {
    if (!this.desk.line && this.desk.moment.time_s) this.time.input.checked = true;
    this.text.focus();
  }

  async send() {
    const [student, text] = [this.of, this.text.value.trim()];
    if (!student || !text) {
      missing(this.text, "Write the comment.");
      return;
    }
    if (tooLong(this.text)) return;
    /** @type {import("../types.js").Said} */
    const said = { does: "comment", student, text };
    if (this.line.input.checked && this.desk.line) said.line = this.desk.line;
    if (this.time.input.checked && this.desk.moment.time_s !== null) {
      said.time_s = Math.round(this.desk.moment.time_s * 1000) / 1000;
      if (this.desk.moment.line) said.line = this.desk.moment.line;
    }
    if (this.private.checked) said.private = true;
    this.save.disabled = true;
    const done = await this.desk.act([said], `Commented on ${inText(this.desk.rows.get(student)?.name ?? student)}`);
    this.save.disabled = false;
    if (!done) return; // what was typed is still there
    if (this.drafts.get(student)?.trim() === text || this.of === student) this.drafts.delete(student);
    if (this.of === student) this.text.value = "";
  }
}

/** @param {string} name */
function place(name) {
  const input = make("input", { type: "radio", name: "comment-place", value: name });
  const text = make("span", { text: name === "program" ? "program" : name });
  return { input, text, label: make("label", { class: "check" }, input, text) };
}
