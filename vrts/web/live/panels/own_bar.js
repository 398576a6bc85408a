// Over a robot of one's own: who looks in, what they point at; and for who looks in, control and the way back.

import { byId, button, make } from "../dom.js";
import { inText, isolated } from "../names.js";
import { onSelect, select } from "../selection.js";

const TONE = 660; // [Hz]
const TONE_S = 0.18; // [s]

/** @typedef {import("../store.js").Known} Known */

let before = ""; // the room that who looks in came from

/** Whether one is in a robot of one's own. @param {Known} now */
export function isMine({ room, supervisor, name }) {
  return Boolean(room?.own) && (!supervisor || room?.own === name);
}

/** Enter another room. @param {import("../pages/room.js").App} app @param {string} room */
export function goTo({ store, connection }, room) {
  if (!store.now.room?.own) before = store.now.room?.id ?? "";
  const url = new URL(location.href);
  url.searchParams.set("room", room);
  history.replaceState(null, "", url);
  connection.enter(room);
}

/** @param {import("../pages/room.js").App} app */
export function mountOwnBar(app) {
  const { store, connection, toasts } = app;
  const who = make("p", { class: "own-who", role: "alert" });
  const points = make("p", { class: "own-points", role: "status" });
  const buttons = make("div", { class: "row small" });
  const bar = make("section", { class: "own-bar", "aria-label": "Who looks in", hidden: true }, who, points, buttons);
  byId("view").before(bar);

  /** @type {Set<string>} */
  let inside = new Set();
  let place = "";

  store.on(["room", "people", "control", "you", "supervisor", "hands", "connection"], (now) => {
    const { room, people, control, you, name } = now;
    const mine = isMine(now);
    if (room?.id !== place) {
      place = room?.id ?? "";
      inside = new Set();
      points.textContent = "";
    }
    const lookers = [...new Map(people.filter((one) => one.role === "supervisor" && !one.away && one.name !== name && one.name !== room?.own).map((one) => [one.name, one])).values()];
    const looksIn = Boolean(room?.own) && !mine;
    bar.hidden = !(looksIn || (mine && lookers.length));
    bar.classList.toggle("looked-at", mine);
    const told = mine ? lookers : [];
    for (const one of told.filter((one) => !inside.has(one.name))) {
      toasts.tell(`${inText(one.name)} looks in`);
      sound();
    }
    const names = new Set(told.map((one) => one.name));
    for (const gone of inside) if (!names.has(gone)) toasts.tell(`${inText(gone)} has gone`);
    inside = names;
    if (bar.hidden) return;
    const holder = people.find(({ id }) => id === control.holder);
    if (mine) {
      const parts = lookers.flatMap((one, index) => [...(index ? [", "] : []), isolated(one.name)]);
      const leads = lookers.find((one) => one.name === holder?.name);
      set(who, ...parts, leads ? (lookers.length > 1 ? ` look in; ${inText(leads.name)} has control` : " looks in and has control") : lookers.length > 1 ? " look in" : " looks in");
      buttons.replaceChildren();
      return;
    }
    const owner = people.find((one) => one.role !== "supervisor" && !one.away) ?? null;
    set(who, "You look into the robot of ", isolated(room?.own ?? ""), owner ? ", who sees that you are here" : "; nobody of theirs is here");
    const up = now.hands?.hands.some((one) => one.room === room?.id);
    const wanted = [
      ...(control.holder === you ? [] : [button("Take control", () => connection.send("hand_over", { person: store.now.you }), { class: "main" })]),
      ...(control.holder === you && owner ? [button(`Give control to ${inText(owner.name)}`, () => connection.send("hand_over", { person: owner.id }), { class: "main" })] : []),
      ...(up ? [button("Helped: hand down", () => connection.send("lower_hand", { room: store.now.room?.id ?? "" }))] : []),
      button("Leave", () => goTo(app, before)),
    ];
    if (wanted.map((one) => one.textContent).join() !== [...buttons.children].map((one) => one.textContent).join() || buttons.dataset.owner !== owner?.id) buttons.replaceChildren(...wanted);
    buttons.dataset.owner = owner?.id ?? "";
  });

  // --- pointing: what is selected here is shown to the others
  let shown = "";
  onSelect((body) => {
    const others = store.now.people.some((one) => !one.away && one.name !== store.now.name);
    if (body === shown || !store.now.room?.own || !others) return;
    shown = body;
    points.textContent = "";
    connection.send("point", { body });
  });
  store.on(["pointed"], ({ pointed, people }) => {
    if (!pointed) return;
    const name = people.find(({ id }) => id === pointed.person)?.name ?? "somebody";
    shown = pointed.body;
    select(pointed.body);
    points.textContent = pointed.body ? `${inText(name)} points at ${pointed.body}` : "";
  });
}

/** @param {HTMLElement} place @param {(string | Node)[]} parts */
function set(place, ...parts) {
  const text = parts.map((part) => (typeof part === "string" ? part : part.textContent)).join("");
  if (place.textContent !== text) place.replaceChildren(...parts);
}

/** A short tone, where the browser lets the page make one. */
function sound() {
  const audio = new AudioContext();
  const tone = new OscillatorNode(audio, { frequency: TONE });
  const level = new GainNode(audio, { gain: 0.08 });
  tone.connect(level).connect(audio.destination);
  tone.start();
  tone.stop(audio.currentTime + TONE_S);
  tone.addEventListener("ended", () => void audio.close());
}
