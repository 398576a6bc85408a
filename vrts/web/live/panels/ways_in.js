// The supervisor's list of ways in: the class code and links, who came by them, and their end.

import { button, make, write } from "../dom.js";
import { settle } from "../focus.js";

const MINUTE = 60_000; // [ms]

/**
 * @typedef {{id: string, kind: "code"|"link"|"supervisor", room: string, made: number, ends: number, used: number, inside: number}} Way
 * @typedef {{code: string, url: string, wrong: number, left: number, ways: Way[], hour: number, day: number,
 *   most: {address: string, hour: number, day: number}[], guests: number, unused: number, idle: number}} Ways
 */

/**
 * @param {import("../store.js").Store} store @param {import("../toasts.js").Toasts} toasts
 * @param {ReturnType<import("./entrance.js").mountEntrance>} entrance
 * @returns {HTMLElement} the block of a panel
 */
export function waysIn(store, toasts, entrance) {
  const list = make("ul", { class: "rooms", "aria-label": "Ways in" });
  const counts = make("p", { class: "soft" });
  const from = make("ul", { class: "soft", "aria-label": "Entries by address" });
  const fresh = button("New class code", () => void change({ do: "renew" }), { hidden: true });
  const more = make("details", { class: "block", id: "ways-in" }, make("summary", { text: "Ways in" }), list, counts, from,
    make("div", { class: "row" }, fresh, button("Refresh", () => void look())));
  more.addEventListener("toggle", () => more.open && void look());
  window.setInterval(() => more.open && !document.hidden && void look(), MINUTE);
  store.on(["code"], () => more.open && void look());

  async function look() {
    const answer = await fetch("/ways");
    if (answer.ok) show(await answer.json());
  }

  /** @param {Ways} ways */
  function show(ways) {
    fresh.hidden = Boolean(ways.code);
    settle(list, ways.ways.map((way) => row(way, ways)));
    write(counts, `${entries(ways.hour)} in the last hour, ${ways.day} in a day. Guests: ${ways.guests}; ${ways.unused} never came into a room, ${ways.idle} were not here for a week.`);
    settle(from, ways.most.map(({ address, hour, day }) => make("li", { text: `${address}: ${entries(hour)} in the last hour, ${day} in a day` })));
  }

  /** @param {Way} way @param {Ways} ways */
  function row(way, ways) {
    const name = way.kind === "code" ? `Class code ${ways.code}` : way.kind === "link" ? `Link into ${way.room || "a room that was closed"}` : "Supervisor's link (works once)";
    const it = way.kind === "code" ? `class code ${ways.code}` : way.kind === "link" ? `the link into ${way.room || "a room that was closed"}` : "the supervisor's link";
    const since = way.made ? `since ${new Date(way.made * 1000).toLocaleString([], { dateStyle: "medium", timeStyle: "short" })}` : "";
    const wrong = way.kind === "code" ? ways.wrong ? `up to ${ways.wrong} wrong guesses` : "no wrong guesses" : "";
    const act = (/** @type {string} */ text, /** @type {() => void} */ click) =>
      button(text, click, { "data-do": `${text} ${way.id}`, "aria-label": `${text}: ${name}` });
    const renew = way.kind === "code" || (way.kind === "link" && way.room)
      ? [act("Renew", () => window.confirm(`Replace ${it}? The old ${way.kind} stops working. People who are in stay.`) && void change({ do: "renew", id: way.id }, way.room))] : [];
    return make("li", {}, make("span", { class: "person", text: name }),
      make("span", { class: "soft", text: ` ${[since, way.used === 1 ? "1 entry" : `${way.used} entries`, wrong].filter(Boolean).join(", ")}` }),
      make("div", { class: "row small" }, ...renew,
        act("End", () => window.confirm(`End ${it}? Nobody can enter with it. People who are in stay.`) && void change({ do: "end", id: way.id })),
        ...(way.inside ? [act("End and send away", () => window.confirm(`End ${it}? Nobody can enter with it, and all who came in by it (${way.inside}) are sent away.`) && void change({ do: "end", id: way.id, away: true }))] : [])));
  }

  /** @param {{do: "renew"|"end", id?: string, away?: boolean}} what @param {string} [room] */
  async function change(what, room = "") {
    const answer = await fetch("/ways", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(what) });
    const told = await answer.json();
    if (!answer.ok) toasts.warn(told.text);
    else if (told.picture) entrance.showMade(told, room);
    await look();
  }

  return more;
}

/** @param {number} count */
function entries(count) {
  return count === 1 ? "1 entry" : `${count} entries`;
}
