// A mark by hand, a later deadline, an excuse, and who is to look at whom.

import { choice, make, onSubmit } from "../../live/dom.js";
import { ask } from "../ask.js";
import { inText, isolated } from "../../live/names.js";
import { missing, POINTS, tooLong } from "../missing.js";
import { after, amount, counted, exact, mark, points, typed, withOffset } from "../words.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Said} Said */

/** These a change does not settle: graders decide them again. */
const OF_GRADERS = new Set(["conflict", "lapsed"]);

/** Points added, or a mark in place of the computed one. */
export class ByHand {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.kind = choice([["delta", "Add points"], ["mark", "Set the mark"]], { "aria-label": "What is changed" });
    this.value = make("input", { "aria-label": "Points or mark", placeholder: "−0.5", class: "short", id: "hand-value" });
    this.reason = make("textarea", { "aria-label": "Reason of the change", placeholder: "Reason: the student reads it", rows: 2, dir: "auto" });
    this.settles = make("fieldset", { class: "settles" });
    this.now = make("ul", { class: "past" });
    this.form = make("form", { novalidate: true }, make("div", { class: "row" }, this.kind, this.value), this.reason, this.settles, make("div", { class: "row end" }, make("button", { class: "main", text: "Change the mark" })));
    onSubmit(this.form, () => void this.send());
    this.panel = make("div", {}, this.now, this.form);
    desk.on(["chosen"], () => this.begin());
    desk.on(["detail"], () => this.fill());
  }

  begin() {
    this.value.value = this.reason.value = "";
    this.fill();
  }

  fill() {
    const doubts = [...new Set((this.desk.row?.unsafe ?? []).map((doubt) => doubt.reason))].filter((reason) => !OF_GRADERS.has(reason));
    const kept = new Set(this.chosen());
    this.settles.replaceChildren(make("legend", { text: "This also settles" }), ...doubts.map((reason) =>
      make("label", { class: "check" }, make("input", { type: "checkbox", value: reason, checked: kept.has(reason) }), reason)));
    this.settles.hidden = !doubts.length;
    this.now.replaceChildren(...(this.desk.detail?.changes ?? []).map((one) => make("li", {},
      make("p", {}, `${one.mark !== null && one.mark !== undefined ? `mark ${mark(one.mark)}` : points(one.delta)}: `, make("bdi", { text: one.reason })),
      make("p", { class: "soft" }, isolated(this.desk.nameOf(one.who))))));
  }

  /** @returns {string[]} */
  chosen() {
    return [...this.settles.querySelectorAll("input")].filter((one) => one.checked).map((one) => one.value);
  }

  async send() {
    const { row } = this.desk;
    if (!row) return;
    const settles = this.chosen();
    const value = typed(this.value.value);
    if (value === null && !(settles.length && !this.value.value.trim())) return missing(this.value, POINTS);
    const reason = this.reason.value.trim();
    if (!reason) return missing(this.reason, "Give a reason: it is kept, and the student reads it.");
    if (tooLong(this.reason)) return;
    /** @type {Said} */
    const said = { does: "change", students: [row.id], reason };
    const adds = this.kind.value === "delta";
    if (Math.abs(value ?? 0) > row.total) return missing(this.value, `Marks are out of ${row.total}: ${value} cannot be meant.`);
    if (adds) said.delta = exact(value ?? 0);
    else said.mark = exact(value ?? 0);
    if (settles.length) said.settles = settles;
    const final = adds ? after(row.final, value ?? 0, row.total) : value;
    const words = `${inText(row.name)}: ${adds ? points(value ?? 0) : `mark ${mark(value)}`}`;
    if (await this.desk.act([said], words, [{ ...row, final }])) this.begin();
  }
}

/** Deadlines, excuses, assignment. */
export class Student {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.key = "";
    this.due = make("input", { type: "datetime-local", "aria-label": "New deadline" });
    this.reason = make("input", { "aria-label": "Reason", placeholder: "Reason", dir: "auto" });
    this.who = make("div", { class: "graders", role: "group", "aria-label": "Graders" });
    this.whom = choice([["one", "this program"], ["all", "all in the list"]], { "aria-label": "Assign what" });
    const extend = make("form", { novalidate: true }, make("h3", { text: "Later deadline, or no mark" }), this.reason,
      make("div", { class: "row" }, this.due, make("button", { text: "Extend" })),
      make("div", { class: "row end" }, make("button", { type: "button", text: "Excuse", title: "No mark is expected", click: () => void this.excuse() })));
    onSubmit(extend, () => void this.extend());
    const assign = make("form", { novalidate: true }, make("h3", { text: "Who looks at this" }), this.who,
      make("div", { class: "row" }, this.whom, make("span", { class: "fill" }), make("button", { text: "Assign" })));
    onSubmit(assign, () => void this.assign());
    this.panel = make("div", {}, assign, extend);
    desk.on(["chosen"], () => {
      this.due.value = this.reason.value = "";
      this.fill();
    });
    desk.on(["class"], () => this.fill());
  }

  fill() {
    const assigned = this.desk.row?.assigned ?? [];
    const key = JSON.stringify([this.desk.chosen, assigned, this.desk.data?.graders]);
    if (key === this.key) return; // what is being ticked stays
    this.key = key;
    this.who.replaceChildren(...(this.desk.data?.graders ?? []).map((one) =>
      make("label", { class: "check" }, make("input", { type: "checkbox", value: one.id, checked: assigned.includes(one.id) }), isolated(one.name))));
  }

  /** Where the keyboard goes first. @returns {HTMLElement} */
  get first() {
    return this.who.querySelector("input") ?? this.reason;
  }

  async extend() {
    const { row } = this.desk;
    const [due, reason] = [withOffset(this.due.value), this.reason.value.trim()];
    if (!row) return;
    if (!due) return missing(this.due, "Give the new deadline.");
    if (!reason) return missing(this.reason, "Give a reason.");
    if (tooLong(this.reason)) return;
    if (await this.desk.act([{ does: "extend", students: [row.id], due, reason }], `${inText(row.name)} has until ${this.due.value.replace("T", " ")}`)) this.due.value = this.reason.value = "";
  }

  async excuse() {
    const { row } = this.desk;
    const reason = this.reason.value.trim();
    if (!row) return;
    if (!reason) return missing(this.reason, "Give a reason.");
    if (tooLong(this.reason)) return;
    if (await this.desk.act([{ does: "excuse", students: [row.id], reason }], `${inText(row.name)} is excused`, [{ ...row, excused: true }])) this.reason.value = "";
  }

  async assign() {
    const { row, listed } = this.desk;
    const students = this.whom.value === "all" ? listed.map((one) => one.id) : row ? [row.id] : [];
    const graders = [...this.who.querySelectorAll("input")].filter((one) => one.checked).map((one) => one.value);
    if (!students.length) return;
    const names = graders.map((id) => inText(this.desk.nameOf(id))).join(" and ") || "nobody";
    const who = students.length === 1 ? inText(this.desk.rows.get(students[0])?.name ?? students[0]) : counted(students.length, "program");
    if (students.length > 1 && !(await ask("Assign all of them?", [make("p", { text: `${who} of the list go to ${names}.` })], "Assign"))) return;
    await this.desk.act([{ does: "assign", students, graders }], `Assigned ${who} to ${names}`, students.flatMap((id) => {
      const one = this.desk.rows.get(id);
      return one ? [{ ...one, assigned: graders }] : [];
    }));
    this.whom.value = "one";
  }
}

/** Finish the program that is looked at, and go on. @param {Desk} desk */
export async function finish(desk) {
  const { row } = desk;
  if (!row) return;
  const mine = row.finished.find((one) => one.who === desk.me);
  if (mine && !mine.stale) {
    desk.notes.done(`You have finished ${inText(row.name)} already.`);
    return;
  }
  const value = amount(row.own === undefined ? row.final : row.own);
  const done = desk.act([{ does: "finish", student: row.id, mark: value === null ? null : exact(value) }], `Finished ${inText(row.name)} with ${mark(value)}`,
    [{ ...row, finished: [...row.finished.filter((one) => one.who !== desk.me), { who: desk.me, mark: value, stale: false }] }]);
  desk.next();
  await done;
}
