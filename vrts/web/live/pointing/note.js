// Words beside the mouse while something is dragged. The panel's numbers say the same to screen readers.

import { make, write } from "../dom.js";

const BESIDE = 18; // [px]

/** One line that follows the mouse. */
export class DragNote {
  constructor() {
    this.box = make("div", { class: "drag-note", "aria-hidden": "true", hidden: true });
    document.body.append(this.box);
  }

  /** @param {string} text empty: nothing is dragged @param {import("./screen.js").Place} at on the page [px] */
  tell(text, { x, y }) {
    write(this.box, text);
    this.box.hidden = !text;
    if (!text) return;
    const { offsetWidth, offsetHeight } = this.box;
    this.box.style.left = `${Math.max(Math.min(x + BESIDE, window.innerWidth - offsetWidth - 4), 4)}px`;
    this.box.style.top = `${Math.max(y - BESIDE - offsetHeight, 4)}px`;
  }

  remove() {
    this.box.remove();
  }
}
