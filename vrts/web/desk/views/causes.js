// All who lost the same by the same cause: one decision for all of them, with a look at what it changes.

import { button, byId, choice, make, onSubmit, prose, write } from "../../live/dom.js";
import { amount, counted, exact, identifier, lost, mark, points, typed } from "../words.js";
import { ask } from "../ask.js";
import { isolated } from "../../live/names.js";
import { missing, POINTS, tooLong } from "../missing.js";
import { apart, gives, guess } from "../work/giving.js";
import { preview } from "../work/preview.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Cause} Cause */
/** @typedef {import("../types.js").Row} Row */
/** @typedef {import("../types.js").Item} Item */
/** @typedef {import("../types.js").Said} Said */

const NEW = " new"; // no identifier begins with a blank
const CHANGE = " change";

/** The view. */
export class Causes {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.chosen = "";
    /** Who is left out, by hand. @type {Set<string>} */
    this.without = new Set();
    this.list = make("ul", { class: "cause-list" });
    this.title = make("h2", {});
    this.about = make("p", { class: "soft" });
    this.students = make("table", { class: "listing" });
    this.what = choice([], { "aria-label": "What they are given" });
    this.what.addEventListener("change", () => this.fields());
    this.item = make("input", { placeholder: "Title of the new item", "aria-label": "Title of the new item", dir: "auto" });
    this.points = make("input", { placeholder: "−0.5", "aria-label": "Points", class: "short" });
    this.text = make("textarea", { placeholder: "Comment for all of them", "aria-label": "Comment for all of them", rows: 3, dir: "auto" });
    this.go = make("button", { class: "main", text: "See what changes" });
    this.form = make("form", { class: "bulk-form", novalidate: true }, make("label", {}, "Give them ", this.what), this.item, this.points, this.text, this.go);
    onSubmit(this.form, () => void this.give());
    byId("view-causes").append(make("div", { class: "causes" },
      make("section", { "aria-label": "Causes" }, make("h2", { text: "Causes" }), this.list),
      make("section", { "aria-label": "Who lost this" }, this.title, this.about, this.form, make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Students" }, this.students))));
    desk.on(["class"], () => this.fill());
    desk.on(["view"], () => this.fill());
  }

  /** Show those who lost by a cause. @param {string} key */
  open(key) {
    this.choose(key);
    this.desk.show("causes");
  }

  /** @param {string} key */
  choose(key) {
    if (key !== this.chosen) this.without.clear();
    this.chosen = key;
    this.fill();
  }

  /** @returns {Cause | undefined} */
  get cause() {
    return this.desk.data?.causes.find((one) => one.key === this.chosen) ?? this.desk.data?.causes[0];
  }

  /** @returns {Row[]} */
  get all() {
    return (this.cause?.students ?? []).flatMap((id) => this.desk.rows.get(id) ?? []);
  }

  fill() {
    if (this.desk.view !== "causes") return;
    const { cause } = this;
    const had = this.list.contains(document.activeElement);
    this.list.replaceChildren(...(this.desk.data?.causes ?? []).map((one) => {
      const open = button("", () => this.choose(one.key), one === cause ? { class: "cause", "aria-current": "true" } : { class: "cause" });
      open.append(make("b", { class: "points", text: lost(one.points) }), make("span", {}, ...prose(one.sentence)), make("span", { class: "soft count", text: String(one.count) }));
      return make("li", {}, open);
    }));
    if (had) /** @type {HTMLElement | null} */ (this.list.querySelector("[aria-current]"))?.focus({ preventScroll: true });
    this.form.hidden = this.students.hidden = !cause;
    if (!cause) {
      write(this.title, "Nobody lost anything");
      return;
    }
    this.title.replaceChildren(`All who lost ${lost(cause.points).replace("−", "")}: `, ...prose(cause.sentence));
    const kept = this.what.options.length ? this.what.value : null;
    this.what.replaceChildren(
      ...this.desk.items.map((item) => make("option", { value: item.id, text: `${item.title} (${points(item.points)})` })),
      make("option", { value: NEW, text: "a new item" }), make("option", { value: CHANGE, text: "points, with a reason" }), make("option", { value: "", text: "a comment only" }));
    if (kept !== null && [...this.what.options].some((one) => one.value === kept)) this.what.value = kept;
    this.fields();
    this.rows();
  }

  fields() {
    const what = this.what.value;
    this.item.hidden = what !== NEW;
    this.points.hidden = what !== NEW && what !== CHANGE;
    this.text.placeholder = what === CHANGE ? "Reason: all of them read it" : what ? "Comment for all of them (may stay empty)" : "Comment for all of them";
  }

  rows() {
    const { all } = this;
    const tick = () => write(this.about, `${counted(all.filter((row) => !this.without.has(row.id)).length, "student")} of ${all.length} chosen`);
    this.students.replaceChildren(
      make("thead", {}, make("tr", {}, ...["Student", "Mark", "Items"].map((head, k) => make("th", { scope: "col", class: k === 1 ? "number" : "", text: head })))),
      make("tbody", {}, ...all.map((row) => {
        const box = make("input", { type: "checkbox", checked: !this.without.has(row.id) });
        box.addEventListener("change", () => {
          if (box.checked) this.without.delete(row.id);
          else this.without.add(row.id);
          tick();
        });
        const titles = row.items.map((id) => this.desk.data?.items.find((item) => item.id === id)?.title ?? id);
        return make("tr", {}, make("th", { scope: "row" }, make("label", { class: "check" }, box, isolated(row.name))),
          make("td", { class: "number", text: mark(row.final) }), make("td", { class: "soft", dir: "auto", text: titles.join(", ") }));
      })));
    tick();
  }

  async give() {
    const { desk } = this;
    const rows = this.all.filter((row) => !this.without.has(row.id));
    const text = this.text.value.trim();
    if (!rows.length) return missing(this.what, "Choose at least one student below.");
    if (tooLong(this.text) || (this.what.value === NEW && tooLong(this.item))) return;
    if (this.what.value === CHANGE) return this.change(rows, text);
    /** @type {Said[]} */
    const records = [];
    /** @type {Item | null} */
    let item = desk.items.find((one) => one.id === this.what.value) ?? null;
    if (this.what.value === NEW) {
      const [title, value] = [this.item.value.trim(), typed(this.points.value)];
      if (!title) return missing(this.item, "Say what the item is about.");
      if (value === null) return missing(this.points, POINTS);
      const id = identifier(title, new Set((desk.data?.items ?? []).map((one) => one.id)));
      item = { id, title, points: value, version: "", students: [], withdrawn: false, versions: [] };
      records.push({ does: "item", id, title, points: exact(value) });
    } else if (!item && !text) {
      return missing(this.text, "Write the comment.");
    }
    const given = item;
    const lacking = given ? rows.filter((row) => !row.items.includes(given.id)) : [];
    const { getting, why } = apart(lacking, desk.me);
    if (given) records.push(...gives(given, getting.map((row) => row.id)));
    if (text) records.push(...rows.map((row) => ({ does: "comment", student: row.id, text })));
    const body = [
      make("p", {}, given ? `“${given.title}” goes to ${counted(getting.length, "student")}${lacking.length < rows.length ? `; ${rows.length - lacking.length} have it already` : ""}. ` : "",
        text ? `${counted(rows.length, "student")} get the comment.` : ""),
      ...why.map((words) => make("p", { text: words })),
      ...(given && getting.length ? [preview(getting, amount(given.points) ?? 0)] : []),
    ];
    if (given && !getting.length && !text) return missing(this.what, why.join(" ") || "All of them have it already.");
    if (!records.length || !(await ask(given ? `Changes ${counted(getting.length, "student")}` : `Comments on ${counted(rows.length, "program")}`, body, "Give"))) return;
    const words = given ? `Gave “${given.title}” to ${counted(getting.length, "student")}` : `Commented on ${counted(rows.length, "program")}`;
    if (!(await desk.act(records, words, given ? getting.map((row) => guess(row, given, true)) : []))) return;
    this.text.value = this.item.value = this.points.value = "";
  }

  /** Add points to the marks of all. @param {Row[]} rows @param {string} reason */
  async change(rows, reason) {
    const value = typed(this.points.value);
    if (value === null) return missing(this.points, POINTS);
    if (!reason) return missing(this.text, "Give a reason: it is kept, and they read it.");
    const total = this.desk.data?.total ?? Infinity;
    if (Math.abs(value) > total) return missing(this.points, `Marks are out of ${total}: ${points(value)} cannot be meant.`);
    const { getting, why } = apart(rows, this.desk.me);
    if (!getting.length) return missing(this.what, why.join(" "));
    const all = counted(getting.length, "student");
    const body = [make("p", { text: "Points are added to what was decided before." }), ...why.map((words) => make("p", { text: words })), preview(getting, value)];
    if (!(await ask(`Changes ${all}`, body, "Change"))) return;
    const records = getting.map((row) => ({ does: "change", students: [row.id], delta: exact(value), reason }));
    if (await this.desk.act(records, `${points(value)} for ${all}`)) this.text.value = this.points.value = "";
  }
}
