// Short notices that go by themselves: refusals and what the server says.

import { make } from "./dom.js";

const SHOWN = 6_000; // [ms]
const MOST = 4;

/** A stack of notices. */
export class Toasts {
  /** @param {HTMLElement} place */
  constructor(place) {
    this.place = place;
  }

  /** @param {string} text */
  warn(text) {
    this.add(text, "toast warn");
  }

  /** @param {string} text */
  tell(text) {
    this.add(text, "toast");
  }

  /** @param {string} text @param {string} kind */
  add(text, kind) {
    for (const old of Array.from(this.place.children)) if (old.textContent === text) old.remove();
    const toast = make("p", { class: kind, text, click: () => toast.remove() });
    this.place.append(toast);
    while (this.place.children.length > MOST) this.place.firstChild?.remove();
    window.setTimeout(() => toast.remove(), SHOWN);
  }
}
