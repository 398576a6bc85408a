// The futures of the debugger: which other one stands beside the present one, and how they differ.

import { Ghost } from "./ghost.js";

/** @typedef {{number: number, name: string, words: string, current: boolean}} Future */

const byId = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** The choice of another future, and its ghost. */
export class Futures {
  /** @param {(number: number) => void} choose tells the editor which one is wanted; 0: none */
  constructor(choose) {
    this.choose = choose;
    this.ghost = new Ghost();
    this.select = /** @type {HTMLSelectElement} */ (byId("other"));
    this.select.addEventListener("change", () => this.chosen());
    this.apart = "";
  }

  /** The reader has chosen. */
  chosen() {
    const number = Number(this.select.value);
    if (!number) void this.take(null);
    this.choose(number);
  }

  /** Take the list of all futures; the one beside the present one stays, as long as it is there. @param {Future[]} rows */
  list(rows) {
    const before = Number(this.select.value);
    const others = rows.filter((row) => !row.current);
    const options = others.map(({ number, name, words }) => new Option(`${name || number}: ${words}`, String(number)));
    this.select.replaceChildren(new Option("no other future", "0"), ...options);
    byId("futures").hidden = !others.length;
    const kept = others.some((row) => row.number === before) ? before : 0;
    this.select.value = String(kept);
    if (kept || before) this.chosen();
  }

  /** Draw a future beside the present one. @param {import("./ghost.js").Other | null} other */
  async take(other) {
    await this.ghost.take(other);
    byId("compared").hidden = true;
    this.say(null);
  }

  /** @param {string[]} rows both futures side by side */
  compared(rows) {
    const box = byId("compared");
    box.hidden = !this.ghost.other || !rows.length;
    /** @type {HTMLElement} */ (box.querySelector("pre")).textContent = rows.join("\n");
  }

  /** Show both at a time. @param {number} t [s] @param {import("../viewer/replay.js").State} present */
  show(t, present) {
    this.say(this.ghost.show(t, present));
  }

  /** @param {number | null} apart of the tools [m] */
  say(apart) {
    const { other } = this.ghost;
    let text = "";
    if (other) {
      const longer = other.took - other.present;
      const than = Math.abs(longer) < 5e-4 ? "as long as this one" : `${Math.abs(longer).toFixed(3)} s ${longer > 0 ? "longer" : "less"} than this one`;
      text = `takes ${other.took.toFixed(3)} s, ${than}`;
      if (apart !== null) text += apart < 5e-5 ? "; the tools are at one place now" : `; the tools are ${(apart * 1000).toFixed(1)} mm apart now`;
    }
    byId("apart").textContent = text;
  }
}
