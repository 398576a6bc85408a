// The table: a row for each student, a cell for each assignment.

import { button, byId, choice, make, write } from "../../live/dom.js";
import { STUCK } from "./types.js";
import { counted, points, when } from "./words.js";

const FIRST = 40; // rows that are made at once: more than fit on a screen
const MORE = 60; // rows that are made together after that

/** @typedef {import("./types.js").Student} Student @typedef {import("./types.js").Cell} Cell @typedef {import("./types.js").Column} Column */

/** @type {[string, string, (one: Student) => boolean][]} */
const ONLY = [
  ["", "Everybody", () => true],
  ["here", "Here now", ({ room }) => room !== ""],
  ["stuck", "Stuck on the same", ({ cells }) => cells.some(isStuck)],
  ["waiting", "Waiting for a mark", ({ cells }) => cells.some(({ state }) => state === "waiting")],
  ["late", "Late", ({ cells }) => cells.some(({ late }) => late)],
  ["nothing", "Nothing handed in", ({ cells }) => cells.every(({ tries }) => !tries)],
];

export class Marks {
  /** @param {{student: (id: number) => void}} tell */
  constructor(tell) {
    this.tell = tell;
    this.table = /** @type {HTMLTableElement} */ (byId("marks"));
    /** @type {import("./types.js").Board | null} */
    this.board = null;
    /** @type {Set<number> | null} students of a cause; null: everybody */
    this.of = null;
    /** @type {Map<number, {row: HTMLTableRowElement, told: string}>} */
    this.rows = new Map();
    this.head = "";
    this.waits = 0; // timer of the rows that are still to be made
    this.search = /** @type {HTMLInputElement} */ (byId("search"));
    this.only = /** @type {HTMLSelectElement} */ (byId("only"));
    this.order = /** @type {HTMLSelectElement} */ (byId("order"));
    this.only.append(...choice(ONLY.map(([value, text]) => [value, text])).children);
    this.only.value = ""; // options that are moved into a select are chosen one after another
    this.search.addEventListener("input", () => this.arrange());
    for (const one of [this.only, this.order]) one.addEventListener("change", () => this.arrange());
    byId("everybody").addEventListener("click", () => this.everybody());
  }

  /** Show a board; rows that are as they were stay untouched. @param {import("./types.js").Board} board */
  show(board) {
    this.board = board;
    this.showHead(board.columns);
    for (const [id, { row }] of this.rows) {
      if (board.students.some((one) => one.id === id)) continue;
      row.remove();
      this.rows.delete(id);
    }
    this.arrange();
  }

  /** Show only some, or everybody. @param {Set<number> | null} of */
  narrow(of) {
    this.of = of;
    this.arrange();
  }

  everybody() {
    this.search.value = this.only.value = "";
    this.of = null;
    this.table.dispatchEvent(new CustomEvent("everybody"));
    this.arrange();
  }

  /** @param {Column[]} columns */
  showHead(columns) {
    const told = JSON.stringify(columns);
    if (told === this.head) return;
    this.head = told;
    const count = this.board?.students.length ?? 0;
    const titles = columns.map(({ title, due, begun, full, mean, total }) => make("th", { scope: "col" },
      make("b", { text: title }),
      make("small", { text: due ? `due ${when(due)}` : "no deadline" }),
      make("small", { text: `${begun} of ${count} · ${mean === null ? "no mark" : `mean ${points(mean)} of ${points(total)}`}${full ? ` · ${full} full` : ""}` })));
    this.table.tHead?.replaceChildren(make("tr", {}, make("th", { scope: "col" }, make("b", { text: "Student" })), ...titles));
    const wanted = this.order.value;
    this.order.replaceChildren(...choice([["name", "by name"], ["team", "by team"], ...columns.map(({ id, title }) => /** @type {[string, string]} */ ([id, `by ${title}`]))]).children);
    this.order.value = wanted || "name";
  }

  /** @param {Student} student @param {Column[]} columns @returns {HTMLTableRowElement} its row, as it is now */
  rowOf(student, columns) {
    const told = JSON.stringify(student) + columns.map(({ total }) => total).join();
    const known = this.rows.get(student.id);
    if (known?.told === told) return known.row;
    const name = button(student.name, () => this.tell.student(student.id));
    const beside = [student.team, student.room && `in ${student.room}`, student.listed ? "" : "left the course"].filter(Boolean).join(" · ");
    const head = make("th", { scope: "row" }, name, ...(beside ? [make("small", { text: beside })] : []));
    const row = make("tr", {}, head, ...student.cells.map((cell, k) => cellOf(cell, columns[k])));
    const held = known?.row.contains(document.activeElement);
    known?.row.replaceWith(row);
    if (held) name.focus();
    this.rows.set(student.id, { row, told });
    return row;
  }

  /** Put the rows that are wanted in order. */
  arrange() {
    const { board } = this;
    if (!board) return;
    const words = this.search.value.trim().toLocaleLowerCase();
    const fits = ONLY.find(([value]) => value === this.only.value)?.[2] ?? (() => true);
    const listed = board.students.filter((one) => (this.of?.has(one.id) ?? true) && fits(one)
      && (!words || `${one.name}\n${one.key}\n${one.team}`.toLocaleLowerCase().includes(words)));
    const column = board.columns.findIndex(({ id }) => id === this.order.value);
    const names = new Intl.Collator().compare;
    /** @param {Student} one */
    const mark = (one) => one.cells[column]?.mark ?? -1;
    if (column >= 0) listed.sort((a, b) => mark(a) - mark(b) || names(a.name, b.name));
    else if (this.order.value === "team") listed.sort((a, b) => names(a.team, b.team) || names(a.name, b.name));
    this.place(listed, board.columns, 0);
    const narrowed = listed.length < board.students.length;
    write(byId("listed"), narrowed ? `${listed.length} of ${counted(board.students.length, "student")}` : counted(listed.length, "student"));
    byId("everybody").hidden = !narrowed;
  }

  /**
   * Put rows in their places; those that nobody sees yet come a moment later.
   * @param {Student[]} listed @param {Column[]} columns @param {number} from
   */
  place(listed, columns, from) {
    window.clearTimeout(this.waits);
    const body = this.table.tBodies[0];
    const focused = document.activeElement;
    const until = Math.min(listed.length, from + (from ? MORE : FIRST));
    for (let k = from; k < until; k++) {
      const row = this.rowOf(listed[k], columns);
      if (body.rows[k] !== row) body.insertBefore(row, body.rows[k] ?? null);
    }
    if (focused instanceof HTMLElement && body.contains(focused)) focused.focus();
    if (until < listed.length) {
      this.waits = window.setTimeout(() => this.place(listed, columns, until));
      return;
    }
    while (body.rows.length > listed.length) body.rows[body.rows.length - 1].remove();
  }
}

/** @param {Cell} cell */
export function isStuck({ same }) {
  return (same ?? 0) >= STUCK;
}

/** @param {Cell} cell @param {Column} column */
function cellOf(cell, { total }) {
  if (!cell.tries) return make("td", { class: "none", text: "–" });
  const has = cell.mark !== undefined;
  const share = has && total ? Math.max(0, Math.min(1, Number(cell.mark) / total)) : 0;
  const full = has && share >= 1;
  const gauge = make("span", { class: `gauge ${full ? "full" : share < 0.4 ? "low" : ""}`, "aria-hidden": "true" });
  gauge.style.setProperty("--share", `${100 * share}%`);
  const signs = [
    cell.state === "waiting" ? make("span", { class: "sign", text: "marking" }) : "",
    cell.state === "failed" ? make("span", { class: "sign stuck", text: "failed" }) : "",
    cell.late ? make("span", { class: "sign late", text: "late", title: cell.late }) : "",
    isStuck(cell) ? make("span", { class: "sign stuck", text: `stuck ×${cell.same}`, title: `the last ${cell.same} attempts lost by the same` }) : "",
  ].filter((one) => one !== "");
  return make("td", {},
    make("span", { class: "mark", text: has ? points(Number(cell.mark)) : "?" }),
    gauge,
    make("span", { class: "tries", text: `${cell.tries}×`, title: counted(cell.tries, "attempt") }), ...signs);
}
