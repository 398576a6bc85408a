// The buttons of a rehearsal, and its keys.

import { button, choice, drawing, make, write } from "../dom.js";

/** @typedef {import("./phase.js").Step} Step */
/** @typedef {"run"|"over"|"into"|"out"|"back"|"back_run"} Pressed */

/** What can be pressed: words, key and drawing. @type {[Pressed, string, string, string][]} */
const STEPS = [
  ["back_run", "Run back to the breakpoint before", "Shift+F2", "M11 2.5h2v11h-2zM9 2.5v11L2 8z"],
  ["back", "Step back", "Ctrl+F10", "M13.6 9.4h-2A4 4 0 0 0 4.6 7H8v2H1.5V2.5h2v2.8a6 6 0 0 1 10.1 4.1zM6.2 13a1.8 1.8 0 1 0 3.6 0 1.8 1.8 0 0 0-3.6 0z"],
  ["over", "Step over", "F10", "M2.4 9.4h2A4 4 0 0 1 11.4 7H8v2h6.5V2.5h-2v2.8a6 6 0 0 0-10.1 4.1zM6.2 13a1.8 1.8 0 1 0 3.6 0 1.8 1.8 0 0 0-3.6 0z"],
  ["into", "Step into", "F11", "M7 1h2v5h2.8L8 10 4.2 6H7zM6.2 13a1.8 1.8 0 1 0 3.6 0 1.8 1.8 0 0 0-3.6 0z"],
  ["out", "Step out", "Shift+F11", "M7 10h2V5h2.8L8 1 4.2 5H7zM6.2 13a1.8 1.8 0 1 0 3.6 0 1.8 1.8 0 0 0-3.6 0z"],
  ["run", "Run to the next breakpoint", "F2", "M3 2.5h2v11H3zM7 2.5v11L14 8z"],
];
const FROM = /** @type {[string, string][]} */ ([["start", "from the start"], ["now", "from now"]]);

/** Keys as the panel lists them. @type {[string, string][]} */
export const KEYS = [
  ["F9", "breakpoint here, or none"], ["Ctrl+Shift+Enter", "rehearse"], ...STEPS.map(([, text, key]) => /** @type {[string, string]} */ ([key, text.toLowerCase()])),
  ["Alt+L", "back to live"],
];

/**
 * Return the step that a key asks for; null: none. F5 stays the browser's.
 * @param {{key: string, shiftKey: boolean, ctrlKey: boolean, altKey: boolean, metaKey: boolean}} event
 * @returns {Pressed | null}
 */
export function stepOf({ key, shiftKey, ctrlKey, altKey, metaKey }) {
  if (altKey || metaKey) return null;
  const name = `${ctrlKey ? "Ctrl+" : ""}${shiftKey ? "Shift+" : ""}${key}`;
  return STEPS.find(([, , wanted]) => wanted === name)?.[0] ?? null;
}

/** The bar under the editor. */
export class Bar {
  /** @param {{rehearse: () => void, go: (step: Pressed) => void, stop: () => void}} wishes */
  constructor(wishes) {
    this.begin = button("Rehearse", wishes.rehearse, { id: "rehearse", title: "Run the text for you alone: nothing moves in the room (Ctrl+Shift+Enter)", "aria-describedby": "rehearsal-state" });
    this.from = choice(FROM, { "aria-label": "Where the rehearsal begins", title: "Where the rehearsal begins" });
    this.end = button("Stop", wishes.stop, { id: "rehearsal-stop", title: "End the rehearsal" });
    this.steps = new Map(STEPS.map(([step, text, key, path]) => [step, icon(text, key, path, () => wishes.go(step))]));
    this.state = make("p", { class: "rehearsal-state", id: "rehearsal-state" });
    this.said = make("span", { class: "unseen", role: "status" });
    this.element = make("div", { class: "rehearsal", role: "group", "aria-label": "Rehearsal" },
      make("div", { class: "row" }, this.begin, this.from, make("span", { class: "rehearsal-steps", role: "group", "aria-label": "Steps of the rehearsal" }, ...this.steps.values()), this.end),
      this.state, this.said);
  }

  /**
   * Show what may be pressed: a button that may not keeps the focus, and says why when it is pressed.
   * @param {(step: Step) => string} whyNot @param {boolean} goes whether there is a rehearsal to be ended
   * @param {string} words where it stands @param {string | null} said what is read out; null: nothing, while time passes or one writes
   */
  show(whyNot, goes, words, said) {
    for (const [step, element] of this.steps) element.setAttribute("aria-disabled", String(whyNot(step) !== ""));
    this.end.setAttribute("aria-disabled", String(!goes));
    write(this.state, words);
    if (said !== null) write(this.said, said);
    this.state.title = words;
  }
}

/** @param {string} text @param {string} key @param {string} path @param {() => void} click */
function icon(text, key, path, click) {
  const made = button("", click, { class: "rehearsal-icon", title: `${text} (${key})`, "aria-label": text });
  made.append(drawing(path));
  return made;
}
