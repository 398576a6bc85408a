// Keys of the desk. Single letters are silent while somebody types, and can be turned off.

import { button, byId, make } from "../live/dom.js";

const KEPT = "vrts desk keys";
const SMALL = 0.1; // of a step in the replay [s]
const LARGE = 1;

/** What each key does, for people: the manual has the same table (a test compares). @type {[string, string][]} */
export const TABLE = [
  ["J, K", "Next or previous program in the list"],
  ["N", "Next in the work list: what nobody has finished"],
  ["1 … 9, 0", "Give a rubric item, or take it"],
  ["I", "A new rubric item"],
  ["C", "Comment: on the chosen line, or at the moment that is shown"],
  ["L", "Lines of the program: arrows go on, Enter chooses one"],
  ["R", "Reasons, checks, history"],
  ["M", "Mark by hand"],
  ["D", "Later deadline, excuse, and who looks at it"],
  ["F", "Finish, and go to the next"],
  ["U", "Undo what you did last"],
  ["/", "Search"],
  ["← →", "Step the replay by 0.1 s, with Shift by 1 s"],
  ["A", "All who lost by the same cause"],
  ["W, X, S", "The work, conflicts, statistics"],
  ["Escape", "Leave a text field or the replay: back to the list"],
  ["?", "This list"],
];

export function keysOn() {
  return localStorage.getItem(KEPT) !== "off";
}

/** @param {boolean} on */
export function turnKeys(on) {
  localStorage.setItem(KEPT, on ? "on" : "off");
}

/** Show the keys. */
export function showKeys() {
  const dialog = /** @type {HTMLDialogElement} */ (byId("keys"));
  if (dialog.open) return;
  const close = button("Close", () => dialog.close(), { class: "main" });
  dialog.replaceChildren(make("h2", { id: "keys-title", text: "Keys" }),
    make("table", {}, make("thead", { class: "unseen" }, make("tr", {}, make("th", { scope: "col", text: "Key" }), make("th", { scope: "col", text: "What it does" }))),
      make("tbody", {}, ...TABLE.map(([key, does]) => make("tr", {}, make("th", { scope: "row" }, make("kbd", { text: key })), make("td", { text: does }))))),
    make("p", { class: "soft", text: keysOn() ? "The settings turn single keys off." : "Single keys are turned off in the settings." }),
    make("div", { class: "row end" }, close));
  dialog.showModal();
  close.focus();
}

/**
 * @typedef {{desk: import("./desk.js").Desk, replay: import("./frame.js").Replay, item: (key: string) => void, comment: () => void,
 *   hand: () => void, finish: () => void, search: () => void, newItem: () => void, lines: () => void, reasons: () => void, student: () => void, causes: () => void}} Acts
 */

/** @param {Acts} acts */
export function bindKeys(acts) {
  const { desk } = acts;
  /** @type {Record<string, () => void>} */
  const letters = {
    j: () => desk.step(1), k: () => desk.step(-1), n: () => desk.next(), c: acts.comment, m: acts.hand, f: acts.finish,
    u: () => void desk.undo(), "/": acts.search, i: acts.newItem, l: acts.lines, r: acts.reasons, d: acts.student,
  };
  /** Keys that every view has. @type {Record<string, () => void>} */
  const everywhere = {
    u: letters.u, a: acts.causes, w: () => view("work"), x: () => view("conflicts"), s: () => view("statistics"),
  };
  /** @param {import("./desk.js").View} name */
  function view(name) {
    desk.show(name);
    leave(desk);
  }
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector("dialog[open]") || document.querySelector(":popover-open")) return;
    const { target } = event;
    if (!(target instanceof Element)) return;
    if (event.key === "Escape") {
      leave(desk);
      return;
    }
    if (target.matches("textarea, select, input:not([type=checkbox], [type=radio])")) return;
    const sideways = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (sideways && desk.view === "work") {
      if (target.matches("[type=radio], [role=tab]")) return;
      event.preventDefault();
      acts.replay.scrub(sideways * (event.shiftKey ? LARGE : SMALL));
      return;
    }
    if (!keysOn()) return;
    if (event.key === "?") {
      event.preventDefault();
      showKeys();
      return;
    }
    const key = event.key.toLowerCase();
    const here = /^\d$/.test(key) ? () => acts.item(key) : letters[key];
    const act = everywhere[key] ?? (desk.view === "work" ? here : undefined);
    if (!act || event.repeat && !"jk".includes(key)) return;
    event.preventDefault();
    act();
  });
}

/** Go out of what has the keyboard: to the list, or to the view that is shown. @param {import("./desk.js").Desk} desk */
export function leave(desk) {
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  byId(desk.view === "work" ? "list" : `view-${desk.view}`).focus({ preventScroll: true });
}
