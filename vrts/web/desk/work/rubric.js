// The rubric: items with points, given and taken by one key, changed for all at once.

import { button, make, onSubmit } from "../../live/dom.js";
import { ask } from "../ask.js";
import { inText } from "../../live/names.js";
import { missing, POINTS, tooLong } from "../missing.js";
import { amount, counted, exact, identifier, points, typed } from "../words.js";
import { preview } from "./preview.js";
import { Versions } from "./versions.js";
import { changing, gives, guess } from "./giving.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Item} Item */

const KEYS = "1234567890";

/** The items, and the form of a new or changed one. */
export class Rubric {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.list = make("ul", { class: "items" });
    this.about = make("p", { class: "soft about" });
    /** The item that is changed; null: a new one. @type {Item | null} */
    this.changed = null;
    this.sending = false;
    this.title = make("input", { "aria-label": "Title of the item", placeholder: "New item, such as: grip not checked", dir: "auto", id: "item-title" });
    this.points = make("input", { "aria-label": "Points: negative takes off", placeholder: "−0.5", inputmode: "text", class: "short" });
    this.save = make("button", { text: "Add and give" });
    this.cancel = button("Cancel", () => this.edit(null), { hidden: true });
    this.withdraw = button("Withdraw", () => void this.write(true), { hidden: true, title: "Nobody has it any more" });
    this.form = make("form", { class: "item-form", novalidate: true }, this.title, make("div", { class: "row" }, this.points, this.save, this.withdraw, this.cancel));
    onSubmit(this.form, () => void this.write(false));
    this.versions = new Versions(desk, (undo) => void this.around(undo));
    this.panel = make("div", {}, this.list, this.about, this.form, this.versions.ofOne, this.versions.withdrawn);
    desk.on(["class", "chosen", "detail"], () => this.fill());
    desk.on(["moment"], () => this.where());
  }

  fill() {
    const row = this.desk.row;
    this.keepUp();
    const had = this.list.contains(document.activeElement) ? document.activeElement?.getAttribute("data-key") : null;
    this.list.replaceChildren(...this.desk.items.map((item, k) => {
      const has = row?.items.includes(item.id) ?? false;
      const give = button("", () => this.toggle(item), { class: "give", "aria-pressed": String(has), "data-key": `give ${item.id}`, disabled: !row });
      give.append(
        make("kbd", { text: KEYS[k] ?? "", "aria-hidden": "true" }),
        make("span", { class: "item-title", dir: "auto", text: item.title }),
        make("span", { class: "points", text: points(item.points) }));
      return make("li", {}, give, make("span", { class: "soft count", text: String(item.students.length), title: `${counted(item.students.length, "student")} have it` }),
        button("Edit", () => this.edit(item), { class: "jump", "data-key": `edit ${item.id}`, "aria-label": `Edit for all: ${item.title}` }));
    }));
    this.versions.fill(this.changed);
    if (had) [...this.list.querySelectorAll("button")].find((one) => one.dataset.key === had)?.focus({ preventScroll: true });
    this.where();
  }

  /** Somebody else changed the item that is being changed here: say so, and go on from what it is now. */
  keepUp() {
    const { changed } = this;
    const now = this.desk.data?.items.find((item) => item.id === changed?.id);
    if (this.sending || !changed || !now || now.version === changed.version) return;
    this.changed = now;
    this.desk.notes.problem(`Meanwhile “${changed.title}” was changed to: ${now.title}, ${points(now.points)}${now.withdrawn ? ", withdrawn" : ""}.`, ["What you typed is kept, and would take its place."]);
  }

  /** Undo a version of an item: the form that was opened for that is done with. @param {() => Promise<unknown>} undo */
  async around(undo) {
    this.sending = true;
    await undo();
    this.sending = false;
    const now = this.desk.data?.items.find((item) => item.id === this.changed?.id);
    if (this.changed && now?.version !== this.changed.version) this.edit(null);
  }

  /** Say where a given item would stand. */
  where() {
    const { line } = this.desk;
    const text = !this.desk.items.length ? "No items yet: write the first one below."
      : line ? `What you give now stands at line ${line}.` : "Keys 1 to 9 and 0 give an item, or take it.";
    if (this.about.textContent !== text) this.about.textContent = text;
  }

  /** Give or take the item of a key. @param {string} key */
  press(key) {
    const item = this.desk.items[KEYS.indexOf(key)];
    if (item) this.toggle(item);
  }

  /** @param {Item} item */
  toggle(item) {
    const { row } = this.desk;
    if (!row) return;
    if (row.items.includes(item.id)) void this.take(item);
    else void this.desk.act(gives(item, [row.id], { line: this.desk.line }), `Gave “${item.title}” to ${inText(row.name)}`, [guess(row, item, true)]);
  }

  /** Take an item away: whoever gave it. @param {Item} item */
  async take(item) {
    const { row, detail } = this.desk;
    if (!row) return;
    if (detail?.row.id !== row.id || !detail.given.some((one) => one.item === item.id)) {
      await this.desk.queue; // it was given a moment ago: the record has its name only now
      await this.desk.fetchDetail();
    }
    const given = this.desk.detail?.row.id === row.id ? this.desk.detail.given.filter((one) => one.item === item.id) : [];
    if (!given.length) return;
    // what was given to several at once stays with the others
    const others = [...new Set(given.flatMap((one) => one.students))].filter((id) => id !== row.id && this.desk.rows.get(id)?.items.includes(item.id));
    const records = [{ does: "undo", records: given.map((one) => one.record) }, ...(others.length ? [{ does: "give", item: item.id, students: others }] : [])];
    void this.desk.act(records, `Took “${item.title}” from ${inText(row.name)}`, [guess(row, item, false)]);
  }

  /** Fill the form with an item, or with a new one. @param {Item | null} item */
  edit(item) {
    this.changed = item;
    this.title.value = item?.title ?? "";
    this.points.value = item ? points(item.points).replace("±", "") : "";
    this.save.textContent = item ? "Change for all" : "Add and give";
    this.cancel.hidden = this.withdraw.hidden = !item;
    this.versions.fill(item);
    if (item) this.title.focus();
  }

  /** @param {boolean} withdrawn */
  async write(withdrawn) {
    const [title, value, item] = [this.title.value.trim(), typed(this.points.value), this.changed];
    if (!title) return missing(this.title, "Say what the item is about.");
    if (tooLong(this.title)) return;
    if (value === null) return missing(this.points, POINTS);
    const { row } = this.desk;
    const taken = new Set((this.desk.data?.items ?? []).map((one) => one.id));
    /** @type {import("../types.js").Said} */
    const said = { does: "item", id: item?.id ?? identifier(title, taken), title, points: exact(value) };
    if (item) {
      said.after = [item.version];
      if (withdrawn) said.withdrawn = true;
      const by = withdrawn ? -(amount(item.points) ?? 0) : value - (amount(item.points) ?? 0);
      const having = item.students.flatMap((id) => this.desk.rows.get(id) ?? []);
      const { open, fixed } = changing(having);
      const body = [...(open.length || !fixed.length ? [preview(open, by)] : []), ...(fixed.length ? [make("p", { text: `${counted(fixed.length, "student")} with a mark by hand, or excused: that stays, unless the item was given after it.` })] : [])];
      if (!(await ask(`Changes ${counted(open.length, "student")}`, body, withdrawn ? "Withdraw" : "Change for all"))) return;
    }
    /** @type {import("../types.js").Item} */
    const made = { id: said.id, title, points: value, version: "", students: [], withdrawn: false, versions: [] };
    const records = !item && row ? [said, ...gives(made, [row.id], { line: this.desk.line })] : [said];
    const words = item ? `${withdrawn ? "Withdrew" : "Changed"} “${title}” for ${counted(item.students.length, "student")}` : `Added “${title}”${row ? ` and gave it to ${inText(row.name)}` : ""}`;
    this.sending = true;
    const done = await this.desk.act(records, words);
    this.sending = false;
    if (done) this.edit(null);
    else this.keepUp(); // what was typed stays, and goes on from the item as it is now
  }
}
