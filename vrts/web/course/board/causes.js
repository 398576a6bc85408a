// What costs points in the last attempts at an assignment: by how many, how much, and who is stuck on it.

import { button, byId, choice, make, prose, write } from "../../live/dom.js";
import { counted, points } from "./words.js";

const SHOWN = 40; // causes: what is behind them concerns hardly anybody

export class Causes {
  /** @param {(students: Set<number> | null) => void} narrow */
  constructor(narrow) {
    this.narrow = narrow;
    this.list = byId("causes");
    this.assignment = /** @type {HTMLSelectElement} */ (byId("assignment"));
    this.assignment.addEventListener("change", () => {
      this.choose("");
      this.draw();
      const column = this.board?.columns.findIndex(({ id }) => id === this.assignment.value) ?? -1;
      byId("marks").tHead?.rows[0]?.cells[column + 1]?.scrollIntoView({ inline: "nearest", block: "nearest" });
    });
    byId("marks").addEventListener("everybody", () => {
      this.chosen = "";
      this.draw();
    });
    /** @type {import("./types.js").Board | null} */
    this.board = null;
    this.chosen = "";
    this.told = "";
  }

  /** @param {import("./types.js").Board} board */
  show(board) {
    this.board = board;
    const wanted = this.assignment.value || mostAtWork(board);
    const options = board.columns.map(({ id, title }) => /** @type {[string, string]} */ ([id, title]));
    if (JSON.stringify(options) !== this.told) {
      this.told = JSON.stringify(options);
      this.assignment.replaceChildren(...choice(options).children);
      this.assignment.value = wanted;
    }
    this.draw();
  }

  /** @param {string} key of a cause; empty: none */
  choose(key) {
    this.chosen = key;
    const cause = this.board?.causes.find((one) => one.key === key);
    this.narrow(cause ? new Set(cause.students) : null);
  }

  draw() {
    const { board } = this;
    if (!board) return;
    const id = this.assignment.value;
    const own = board.causes.filter(({ assignment }) => assignment === id);
    const begun = board.columns.find((one) => one.id === id)?.begun ?? 0;
    const focused = document.activeElement?.getAttribute("data-cause");
    this.list.replaceChildren(...own.slice(0, SHOWN).map((cause) => {
      const share = make("i");
      share.style.width = `${begun ? (100 * cause.students.length) / begun : 0}%`;
      const stuck = cause.stuck ? `, ${cause.stuck} stuck on it` : "";
      const one = button("", () => {
        this.choose(this.chosen === cause.key ? "" : cause.key);
        this.draw();
      }, { "aria-pressed": String(this.chosen === cause.key), "data-cause": cause.key });
      one.append(
        make("span", { class: "words" }, ...prose(cause.words)),
        make("span", { class: "many", "aria-hidden": "true" }, share),
        make("span", { class: "soft", text: `${counted(cause.students.length, "student")} of ${begun}${stuck} · ${points(cause.points)} points in all` }));
      return make("li", {}, one);
    }));
    if (focused) /** @type {HTMLElement | null} */ (this.list.querySelector(`[data-cause="${focused}"]`))?.focus();
    const none = byId("no-causes");
    none.hidden = own.length > 0 && own.length <= SHOWN;
    write(none, own.length ? `${own.length - SHOWN} more, each of fewer students` : begun ? "Nobody has lost a point." : "Nobody has handed in yet.");
  }
}

/** @param {import("./types.js").Board} board @returns {string} the assignment that was handed in for last */
function mostAtWork({ columns, students }) {
  let [id, latest] = [columns[0]?.id ?? "", 0];
  columns.forEach((column, k) => {
    for (const { cells } of students) {
      const at = cells[k].at ?? 0;
      if (at > latest) [id, latest] = [column.id, at];
    }
  });
  return id;
}
