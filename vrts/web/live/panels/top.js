// The bar on top: room, connection, people, control right, panic.

import { clockOffset } from "../account.js";
import { byId, make, write } from "../dom.js";
import { isolated } from "../names.js";
import { ordinal, persons } from "../persons.js";

const JUST_NOW = 1_500; // [ms]

export const STATES = { connecting: "connecting …", open: "connected", waiting: "no connection, trying again …", ended: "ended" };

/** @param {import("../pages/room.js").App} app */
export function mountTop({ store, connection, toasts, panic }) {
  let asked = -Infinity; // when control was asked for or handed back here [ms]
  let had = false;
  let who = ""; // one is another in another room
  /** @type {(string | Node)[]} who has control, in words */
  let said = [];
  byId("panic").addEventListener("click", panic);
  byId("room-choice").addEventListener("change", () => {
    const url = new URL(location.href);
    url.searchParams.set("room", byId("room-choice").value);
    history.replaceState(null, "", url);
    connection.enter(byId("room-choice").value);
  });
  byId("control-button").addEventListener("click", () => {
    const { control, you } = store.now;
    asked = performance.now();
    connection.send(control.holder === you || control.queue.includes(you) ? "hand_back" : "request_control");
  });
  store.on(["room", "rooms"], ({ room, rooms: all }) => {
    const rooms = room?.own && !all.some(({ id }) => id === room.id) ? [...all, room] : all; // of others' own rooms only the one that is looked into
    write(byId("room-name"), room?.name ?? "Room");
    document.title = `${room?.name ?? "Room"} · vrts`;
    byId("room-pick").hidden = rooms.length < 2;
    byId("room-name").classList.toggle("unseen", rooms.length >= 2);
    byId("room-choice").replaceChildren(...rooms.map(({ id, name, offered }) => make("option", { value: id, text: offered ? name : `${name} (scene not offered)`, selected: id === room?.id })));
    byId("task-name").hidden = !room?.task;
    write(byId("task-name"), room?.task ?? "");
  });
  store.on(["connection", "ended"], ({ connection: state, ended }) => {
    const chip = byId("link-state");
    write(chip, ended || STATES[state]);
    chip.className = `chip ${state}`;
    byId("again").hidden = state !== "ended";
    byId("turn").hidden = state === "ended";
  });
  store.on(["people", "alone"], ({ people, control, you, alone }) => {
    const here = persons(people, control, you).filter((person) => !person.away).length;
    write(byId("crowd"), `${here} here`);
    byId("crowd").hidden = alone || !here;
  });
  store.on(["control", "you", "connection", "alone"], ({ control, you, connection: state, alone }) => {
    byId("control-button").hidden = state === "ended" || (alone && control.holder === you);
  });
  store.on(["control", "people", "you", "alone"], ({ control, people, you, supervisor, alone }) => {
    const mine = control.holder === you && you !== "";
    const place = control.queue.indexOf(you);
    const waits = place >= 0;
    write(byId("control-button"), mine ? "Hand back" : waits ? "Leave the queue" : control.holder || control.locked ? "Queue for control" : "Take control");
    byId("control-button").classList.toggle("main", !mine && !waits && !control.holder && !control.locked);
    if (mine !== had && you === who && performance.now() - asked > JUST_NOW && !alone) {
      if (mine) toasts.tell("you have control now");
      else toasts.warn("you no longer have control: you did nothing for too long, your turn is over, or the supervisor took it");
    }
    had = mine;
    who = you;
    byId("panic").hidden = !mine && !supervisor;
    document.body.classList.toggle("operates", mine);
    const holder = people.find((person) => person.id === control.holder)?.name;
    const words = mine ? [alone ? "" : "You have control"] : [waits ? `${ordinal(place + 1)} in the queue; ` : "", holder ? isolated(holder) : "nobody", " has control"];
    said = control.frozen ? ["Frozen by the supervisor"] : control.locked ? [...words, ", locked"] : words;
    byId("turn").classList.toggle("mine", mine && !control.frozen && !control.locked);
    byId("turn").classList.toggle("stopped", control.frozen || control.locked);
    tick();
  });

  /** Show what is left of a turn. */
  function tick() {
    const { ends } = store.now.control;
    const left = Math.max(Math.ceil(ends - (Date.now() / 1000 + clockOffset())), 0);
    const clock = ends ? `, ${Math.floor(left / 60)}:${String(left % 60).padStart(2, "0")} left` : "";
    const now = make("span", {}, ...said.map((part) => (typeof part === "string" ? part : part.cloneNode(true))), clock);
    if (byId("turn").textContent !== now.textContent) byId("turn").replaceChildren(now);
  }
  window.setInterval(tick, 500);
}
