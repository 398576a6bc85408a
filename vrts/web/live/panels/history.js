// What happened: contacts, near misses and events by time; back to an earlier moment.

import { COMMANDING, allow, whyNoCommand } from "../allowed.js";
import { byId, button, make, onSubmit } from "../dom.js";
import { settle } from "../focus.js";
import { look, lookedAt, onLook } from "../looking.js";
import { inText } from "../names.js";

const MOST = 200; // rows
const PAUSE = 400; // between drawings at least [ms]

/** @param {import("../pages/room.js").App} app */
export function mountHistory({ store, world, command, toasts }) {
  const panel = byId("panel-history");
  const lights = make("input", { type: "checkbox", id: "show-contacts", change: () => (world.showContacts = lights.checked) });
  lights.checked = true;
  const body = make("tbody", { click: (/** @type {MouseEvent} */ event) => {
    const row = /** @type {HTMLElement} */ (event.target).closest("tr");
    if (!row?.dataset.time) return;
    time.value = row.dataset.time;
    look(Number(row.dataset.at));
  } });
  const none = make("p", { class: "soft", text: "Nothing has happened yet." });
  const box = make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Events" },
    make("table", { class: "events" }, make("caption", { class: "unseen", text: "Events, the last ones first" }),
      make("thead", {}, make("tr", {}, ...["Time", "What", "Line"].map((text) => make("th", { scope: "col", text })))), body));
  const time = make("input", { type: "number", id: "rewind-time", min: "0", step: "0.1", value: "0", required: true });
  const back = make("button", { text: "Rewind" });
  const rewind = make("form", { class: "row" }, make("label", { text: "To second " }, time), back);
  const reset = button("Reset the scene", () => attempt({ type: "reset" }));
  panel.append(
    make("label", { class: "check" }, lights, "Light up and report contacts"), none, box,
    make("div", { class: "block" }, make("h2", { text: "Go back" }), make("p", { class: "soft", text: "Press an event to see that moment on your page only; its time goes into the field. Rewind takes everybody back." }), make("div", { class: "row" }, reset, rewind)),
  );
  onSubmit(rewind, () => attempt({ type: "rewind", time_s: Number(time.value) }));

  /** @param {import("../protocol.js").Message} action */
  function attempt(action) {
    command(action).catch((error) => toasts.warn(error.message));
  }

  let waiting = false;
  store.on(["events", "contacts", "near", "notes"], later);
  document.addEventListener("panel", later);
  onLook(later);
  function later() {
    if (waiting || panel.hidden) return;
    waiting = true;
    window.setTimeout(draw, PAUSE);
  }

  function draw() {
    waiting = false;
    const { events, contacts, near, notes } = store.now;
    const rows = [
      ...events.map((row) => ({ t: row.time_s, kind: row.kind, text: row.text, line: row.line ? `${row.program} ${row.line}` : "" })),
      ...contacts.map((row) => ({ t: row.start, kind: "contact", text: row.text, line: row.line ? String(row.line) : "" })),
      ...near.map((row) => ({ t: row.start, kind: "near", text: row.text, line: row.line ? String(row.line) : "" })),
      ...notes.map((row) => ({ t: row.at_s, kind: "noted", text: `${inText(row.name)}: ${row.text}`, line: "" })),
    ].sort((a, b) => b.t - a.t).slice(0, MOST);
    none.hidden = rows.length > 0;
    box.hidden = !rows.length;
    const at = lookedAt() ?? Infinity;
    settle(body, rows.map((row) => make("tr", { class: row.t > at ? `${row.kind} later` : row.kind, "data-time": row.t.toFixed(1), "data-at": row.t, "data-key": `${row.t} ${row.kind} ${row.text}` },
      make("td", { class: "time" }, make("button", { type: "button", class: "moment", text: `${row.t.toFixed(1)} s`, title: "Look at this moment" })), make("td", {}, ...breakable(row.text)), make("td", { class: "time", text: row.line }))));
  }
  store.on([...COMMANDING, "supervisor", "alone", "resets"], ({ supervisor, alone, resets }) => {
    const why = whyNoCommand(store.now) || (supervisor || alone || resets ? "" : "Only a supervisor may reset or rewind here.");
    for (const one of [reset, back]) allow(one, why);
  });
}

/** Return a text that may break after its commas, as long numbers should not. @param {string} text @returns {(Node | string)[]} */
function breakable(text) {
  return text.split(/(?<=,)/).flatMap((part) => [part, make("wbr")]);
}
