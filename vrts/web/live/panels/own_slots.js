// Time slots of the shared robot: book, move and give back one's own; who leads changes all.

import { byId, button, make, write } from "../dom.js";
import { settle } from "../focus.js";
import { isolated } from "../names.js";

const MINUTE = 60_000; // [ms]

/** @typedef {{starts: number, ends: number, taken: boolean, mine: boolean, name: string}} Slot Unix times [s] */
/** @typedef {{room: string, zone: string, ahead: number, leads: boolean, slots: Slot[]}} Slots */

/** @param {import("../pages/room.js").App} app */
export function mountOwnSlots({ toasts }) {
  const title = make("h2", { text: "Time slots" });
  const how = make("p", { class: "soft" });
  const days = make("div", { class: "slots" });
  const stop = button("Do not move it", () => { moving = 0; draw(); }, { hidden: true });
  const block = make("div", { class: "block", hidden: true }, title, how, stop, days);
  byId("panel-own").append(block);
  /** @type {Slots | null} */
  let told = null;
  let moving = 0; // start of the slot that is being moved; 0: none
  /** @type {Set<string>} */
  const open = new Set();

  async function look() {
    const answer = await fetch("/course/slots");
    if (answer.ok) show(await answer.json());
  }

  /** @param {Slots} slots */
  function show(slots) {
    told = slots;
    draw();
  }

  /** @param {Record<string, unknown>} what */
  async function change(what) {
    const answer = await fetch("/course/slots", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(what) });
    const body = await answer.json();
    moving = 0;
    if (answer.ok) return show(body);
    toasts.warn([body.text, body.help].filter(Boolean).join("; "));
    await look();
  }

  function draw() {
    if (!told) return;
    const { zone, room, ahead, leads, slots } = told;
    block.hidden = !room;
    if (!room) return;
    write(title, `Time slots: ${room}`);
    write(how, `In your time you have control as soon as you are here or ask for it; others use the robot while you are away. You may have ${ahead} ahead. Times of ${zone}.`);
    stop.hidden = !moving;
    const clock = new Intl.DateTimeFormat([], { hour: "2-digit", minute: "2-digit", timeZone: zone });
    const date = new Intl.DateTimeFormat([], { weekday: "long", day: "numeric", month: "long", timeZone: zone });
    /** @type {Map<string, Slot[]>} */
    const byDay = new Map();
    for (const slot of slots) {
      const day = date.format(slot.starts * 1000);
      byDay.set(day, [...(byDay.get(day) ?? []), slot]);
    }
    const before = new Set([...days.children].map((one) => one.getAttribute("data-key")));
    settle(days, [...byDay].map(([day, all], index) => {
      const free = all.filter(({ taken }) => !taken).length;
      const yours = all.filter(({ mine }) => mine).length;
      if (!before.size && (index === 0 || yours)) open.add(day);
      const words = [`${free} free`, yours ? `${yours} yours` : ""].filter(Boolean).join(", ");
      const box = make("details", { "data-key": day, open: open.has(day) }, make("summary", { text: `${day}: ${words}` }),
        make("ul", { class: "rooms", "aria-label": day }, ...all.map((slot) => row(slot, `${clock.format(slot.starts * 1000)}–${clock.format(slot.ends * 1000)}`, day, leads))));
      box.addEventListener("toggle", () => (box.open ? open.add(day) : open.delete(day)));
      return box;
    }));
  }

  /** @param {Slot} slot @param {string} time @param {string} day @param {boolean} leads */
  function row(slot, time, day, leads) {
    const act = (/** @type {string} */ text, /** @type {() => void} */ click) => button(text, click, { "aria-label": `${text}: ${day}, ${time}` });
    const buttons = slot.taken
      ? slot.mine || leads
        ? [act("Give back", () => void change({ do: "cancel", starts: slot.starts })), ...(moving === slot.starts ? [] : [act("Move", () => { moving = slot.starts; draw(); })])]
        : []
      : moving
        ? [act("Move it here", () => void change({ do: "move", starts: moving, to: slot.starts }))]
        : [act("Book", () => void change({ do: "book", starts: slot.starts })), ...(leads ? [act("Book for …", () => book(slot))] : [])];
    const whose = slot.mine ? [make("span", { class: "tag", text: "yours" })] : slot.taken ? [make("span", { class: "tag quiet" }, ...(slot.name ? [isolated(slot.name)] : ["taken"]))] : [];
    return make("li", { "data-key": String(slot.starts) }, make("span", { class: "person", text: time }), ...whose, make("div", { class: "row small" }, ...buttons));
  }

  /** Book for somebody else. @param {Slot} slot */
  function book(slot) {
    const name = window.prompt("Name or e-mail address of the student")?.trim();
    if (name) void change({ do: "book", starts: slot.starts, name });
  }

  const panel = byId("panel-own");
  document.addEventListener("panel", (event) => /** @type {CustomEvent} */ (event).detail === "panel-own" && void look());
  window.setInterval(() => panel.hidden || document.hidden || block.hidden || void look(), MINUTE);
  if (!panel.hidden) void look();
}
