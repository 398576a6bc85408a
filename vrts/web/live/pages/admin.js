// The admin page: how the server is, for a supervisor with an account of their own.

import { byId, figure, make, write } from "../dom.js";
import { settle } from "../focus.js";
import { isolated } from "../names.js";
import { mountEntrance } from "../panels/entrance.js";
import { waysIn } from "../panels/ways_in.js";
import { Store } from "../store.js";
import { Toasts } from "../toasts.js";

const EVERY = 3_000; // [ms]
const UNITS = ["B", "kB", "MB", "GB", "TB"];

/**
 * @typedef {{status: string, problems: string[], up_s: number, rooms: number, sessions: number, waiting: number, people: number}} Health
 * @typedef {{id: string, name: string, scene: string, people: number, operator: string, state: string, log: number}} RoomNow
 * @typedef {{name: string, used: number, most: number, unit: string}} Quota
 * @typedef {{at: number, level: string, text: string}} LogEntry
 * @typedef {{version: string, health: Health, load: Record<string, number>, rooms: RoomNow[], quotas: Quota[],
 *   backup_at: number, backup_bytes: number, log: LogEntry[]}} Overview
 */

export function showAdmin() {
  document.head.append(make("link", { rel: "stylesheet", href: "/web/live/admin.css" })); // nobody else needs it
  const place = byId("admin");
  place.hidden = false;
  document.title = "Admin · vrts";
  const toasts = new Toasts(byId("toasts"));
  const state = make("span", { class: "chip", role: "status", text: "asking …" });
  byId("admin-state").append(state);
  const load = make("dl", { class: "admin-facts" });
  const quotas = make("dl", { class: "admin-facts" });
  const backup = make("p", { class: "soft" });
  const rooms = make("tbody");
  const log = make("ol", { class: "admin-log" });
  const nothing = make("p", { class: "soft", text: "Nothing was logged since the server was started." });
  const head = make("tr", {}, ...["Room", "State", "People", "Has control", "Scene", "Log"].map((text) => make("th", { scope: "col", text })));
  const store = new Store();
  const ways = waysIn(store, toasts, mountEntrance(toasts, store));
  ways.classList.add("first");
  byId("admin-blocks").replaceChildren(
    block("Load", load), block("Quotas", quotas), block("Backups", backup), block("Codes and links", ways),
    block("Rooms", scroll("Rooms", make("table", {}, make("thead", {}, head), rooms)), true),
    block("Server's log, newest first", scroll("Server's log", nothing, log), true));
  /** @type {HTMLDetailsElement} */ (/** @type {unknown} */ (ways)).open = true;

  /** @param {Overview} now */
  function show(now) {
    const { health } = now;
    write(state, health.status === "ok" ? "all is well" : health.problems.join("; "));
    state.className = `chip ${health.status === "ok" ? "open" : "ended"}`;
    const l = now.load;
    facts(load, [
      ["Processor", `load ${figure(l.load, 2)} on ${l.processors}; this server ${figure(100 * l.own_share, 0)} % of one`],
      ["Memory", `${size(l.memory - l.memory_free)} of ${size(l.memory)} used`],
      ["Server", size(l.server)], ["Sessions", `${health.sessions} of ${health.rooms} run, ${size(l.sessions)}`],
      ["People", `${health.people} connected`], ["Disk", `${size(l.disk_free)} free`],
      ["Started", `${lasted(health.up_s)} ago`], ["Version", now.version],
    ]);
    facts(quotas, now.quotas.map(({ name, used, most, unit }) => {
      const text = (/** @type {number} */ value) => (unit === "bytes" ? size(value) : String(value));
      return [name, most ? `${text(used)} of ${text(most)} (${figure((100 * used) / most, 0)} %)` : text(used)];
    }));
    write(backup, now.backup_at
      ? `The last copy of the database was made ${lasted(Math.max(Date.now() / 1000 - now.backup_at, 0))} ago: ${size(now.backup_bytes)}.`
      : "No copy of the database was made yet. vrts serve --folder FOLDER --backup FILE makes one while the server runs.");
    settle(rooms, now.rooms.map((room) => make("tr", { "data-key": room.id },
      make("td", {}, make("a", { href: `/?room=${encodeURIComponent(room.id)}`, text: room.name })),
      make("td", { class: room.state === "runs" ? "good" : room.state.includes("dying") ? "bad" : "", text: room.state }),
      make("td", { text: String(room.people) }), make("td", {}, room.operator ? isolated(room.operator) : "nobody"),
      make("td", { text: room.scene }), make("td", { text: size(room.log) }))));
    nothing.hidden = now.log.length > 0;
    settle(log, now.log.map(({ at, level, text }) => make("li", { class: level },
      make("time", { text: new Date(at * 1000).toLocaleString() }), make("span", { class: "level", text: level }), make("bdi", { text }))));
  }

  let shown = "";
  async function look() {
    try {
      const answer = await fetch("/admin/now");
      const text = await answer.text();
      if (!answer.ok) {
        const { text: why, help } = JSON.parse(text);
        refuse([why, help].filter(Boolean).join(": "));
        return;
      }
      if (text !== shown && !selecting(place)) show(JSON.parse(shown = text));
    } catch {
      write(state, "no connection, trying again …");
      state.className = "chip waiting";
      shown = "";
    }
    window.setTimeout(() => void ask(), EVERY);
  }

  /** A page that nobody looks at asks for nothing. */
  async function ask() {
    if (!document.hidden) await look();
    else document.addEventListener("visibilitychange", () => void ask(), { once: true });
  }

  /** @param {string} why */
  function refuse(why) {
    write(state, "");
    state.hidden = true;
    byId("admin-blocks").replaceChildren(make("p", { class: "alone", role: "alert", text: `${why.charAt(0).toUpperCase()}${why.slice(1)}.` }));
  }
  void ask();
}

/** Whether somebody is just selecting text, which a new text would take away. @param {HTMLElement} place */
function selecting(place) {
  const selection = document.getSelection();
  return Boolean(selection && !selection.isCollapsed && selection.anchorNode && place.contains(selection.anchorNode));
}

/** @param {string} title @param {HTMLElement} what @param {boolean} [wide] */
function block(title, what, wide = false) {
  return make("section", { class: wide ? "admin-block wide" : "admin-block" }, make("h2", { text: title }), what);
}

/** What is long scrolls by itself, by keyboard too. @param {string} name @param {HTMLElement[]} what */
function scroll(name, ...what) {
  return make("div", { class: "admin-scroll", tabindex: "0", role: "region", "aria-label": name }, ...what);
}

/** @param {HTMLElement} list @param {string[][]} rows */
function facts(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, text]) => [make("dt", { text: name }), make("dd", { text })]));
}

/** Return a size for people. @param {number} bytes */
function size(bytes) {
  let value = bytes;
  let unit = 0;
  while (value >= 1000 && unit < UNITS.length - 1) {
    value /= 1000;
    unit++;
  }
  return `${figure(value, value < 10 && unit ? 1 : 0)} ${UNITS[unit]}`;
}

/** Return a time span for people. @param {number} seconds */
function lasted(seconds) {
  if (seconds < 120) return `${Math.round(seconds)} s`;
  if (seconds < 7200) return `${Math.round(seconds / 60)} minutes`;
  return seconds < 172_800 ? `${Math.round(seconds / 3600)} hours` : `${Math.round(seconds / 86_400)} days`;
}
