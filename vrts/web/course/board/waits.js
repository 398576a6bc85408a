// Who waits for help, and how many for a mark.

import { byId, make, write } from "../../live/dom.js";
import { ago, counted } from "./words.js";

/** @param {import("./types.js").Wait[]} waits @param {number} now Unix time [s] */
export function showWaits(waits, now) {
  const hands = waits.filter(({ why }) => why === "hand");
  const marks = waits.length - hands.length;
  byId("waits").classList.toggle("some", hands.length > 0);
  const told = JSON.stringify([hands, Math.floor(now / 60)]);
  const list = /** @type {HTMLElement} */ (byId("hands"));
  if (list.dataset.told !== told) {
    list.dataset.told = told;
    list.replaceChildren(...hands.map(({ name, since, room, text }) => make("li", {},
      make("span", {}, make("b", { text: name }), text ? `: ${text}` : "", since ? ` (${ago(since, now)})` : ""),
      make("a", { class: "button", href: `/?room=${encodeURIComponent(room)}`, text: "Go there", "aria-label": `Go to ${name}` }))));
  }
  const help = hands.length ? "" : "Nobody has raised a hand. ";
  write(byId("in-line"), help + (marks ? `${counted(marks, "attempt is", "attempts are")} being marked.` : ""));
}
