// Robots of one's own: which ones there are to open, hands that are up, and for those who lead, all robots.

import { byId, button, make, onSubmit, write } from "../dom.js";
import { settle } from "../focus.js";
import { inText, isolated } from "../names.js";
import { ordinal } from "../persons.js";
import { goTo, isMine } from "./own_bar.js";
import { ago } from "./own_hands.js";

/** @typedef {{scene: string, title: string, assignment: boolean, team: string, room: string, asleep: boolean}} Choice */
/** @typedef {{room: string, name: string, whose: string, title: string, asleep: boolean, people: number, hand: boolean}} Found */

/** @param {import("../pages/room.js").App} app */
export function mountOwn(app) {
  const { store, connection, toasts } = app;
  const panel = byId("panel-own");

  // --- a raised hand
  const text = make("input", { id: "hand-text", maxlength: 200, placeholder: "What is it about? (may stay empty)", "aria-label": "What the question is about", autocomplete: "off" });
  const raise = make("button", { class: "main", text: "Raise hand" });
  const lower = button("Lower hand", () => connection.send("raise_hand", { up: false, text: "" }), { hidden: true });
  const stands = make("p", { class: "soft", role: "status" });
  const form = make("form", { class: "row" }, text, raise, lower);
  onSubmit(form, () => connection.send("raise_hand", { up: true, text: text.value.trim() }) || toasts.warn("there is no connection at the moment"));
  const hand = make("div", { class: "block first", hidden: true }, make("h2", { text: "Ask for help" }), form, stands);
  store.on(["hands", "room", "supervisor", "name"], (now) => {
    hand.hidden = !isMine(now);
    const up = now.hands?.hands.find(({ room }) => room === now.room?.id);
    const mine = isMine(now) ? up : undefined;
    write(raise, mine ? "Change the words" : "Raise hand");
    lower.hidden = !mine;
    write(stands, mine ? `${mine.name === now.name ? "Your hand is up" : `${mine.name} has raised a hand`}: ${ordinal(mine.place)} in the queue${mine.helping.length ? `; ${mine.helping.join(", ")} is here` : ""}.` : "Those who lead the course see your name, and one of them comes in.");
  });

  // --- one's own
  const mine = make("ul", { class: "rooms", "aria-label": "My robots" });
  const own = make("div", { class: "block" }, make("h2", { text: "My robots" }),
    make("p", { class: "soft", text: "Each stays as you leave it. Nobody else enters but those who lead the course, and you see who looks in." }), mine);

  async function look() {
    const answer = await fetch("/course/robots");
    if (answer.ok) show((await answer.json()).robots);
  }

  /** @param {Choice[]} robots */
  function show(robots) {
    own.hidden = !robots.length;
    settle(mine, robots.map((one) => make("li", { "data-key": one.scene },
      make("span", { class: "person", text: one.title }),
      make("span", { class: "soft", text: ` ${[one.team && `shared by ${one.team}`, one.room && one.room !== store.now.room?.id ? (one.asleep ? "asleep" : "awake") : ""].filter(Boolean).join(", ")}` }),
      ...(one.room && one.room === store.now.room?.id ? [make("span", { class: "tag", text: "you are here" })] : []),
      ...(one.room && one.room === store.now.room?.id ? [] : [make("div", { class: "row small" }, button(one.room ? "Enter" : "Open", () => void open(one), { "aria-label": `${one.room ? "Enter" : "Open"} my robot: ${one.title}` }))]))));
  }

  /** @param {Choice} one */
  async function open(one) {
    const answer = await fetch("/course/robots", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ scene: one.scene }) });
    const told = await answer.json();
    if (answer.ok) goTo(app, told.room);
    else toasts.warn([told.text, told.help].filter(Boolean).join("; "));
  }

  // --- for those who lead
  const hands = make("ul", { class: "rooms", "aria-label": "Raised hands" });
  const none = make("p", { class: "soft", text: "No hand is up." });
  const counts = make("p", { class: "soft" });
  const find = make("input", { type: "search", id: "find-robot", maxlength: 100, placeholder: "Name of a student, team or assignment", "aria-label": "Find a robot" });
  const found = make("ul", { class: "rooms", "aria-label": "Robots of students" });
  const many = make("p", { class: "soft", role: "status" });
  const search = make("form", { class: "row" }, find, make("button", { text: "Find" }));
  onSubmit(search, () => void seek());
  const lead = make("div", { class: "block", hidden: true }, make("h2", { text: "Raised hands" }), none, hands, make("h2", { text: "Robots of students" }), counts, search, many, found);

  async function seek() {
    const answer = await fetch(`/course/robots/all?find=${encodeURIComponent(find.value)}`);
    if (!answer.ok) return;
    /** @type {{robots: Found[], count: number}} */
    const { robots, count } = await answer.json();
    write(many, count > robots.length ? `${robots.length} of ${count}: type more of the name.` : count ? "" : "No robot has such a name.");
    settle(found, robots.map((one) => make("li", { "data-key": one.room },
      make("span", { class: "person", text: one.name }),
      make("span", { class: "soft", text: ` ${one.asleep ? "asleep" : one.people === 1 ? "1 person" : `${one.people} people`}` }),
      ...(one.hand ? [make("span", { class: "tag review", text: "hand raised" })] : []),
      make("div", { class: "row small" }, button("Look in", () => goTo(app, one.room), { "aria-label": `Look into ${one.name}` })))));
  }

  store.on(["hands", "room"], ({ hands: told, room }) => {
    const leads = told !== null && (store.now.supervisor || told.rooms > 0);
    lead.hidden = !leads;
    if (!told || !leads) return;
    none.hidden = told.hands.length > 0;
    write(counts, `${told.rooms} in all, ${told.awake} awake.`);
    settle(hands, told.hands.map((one) => make("li", { "data-key": one.room },
      make("span", { class: "person" }, isolated(one.name)),
      make("span", { class: "soft", text: ` ${one.where}, ${ago(one.since)}${one.here ? "" : ", away now"}` }),
      ...(one.helping.length ? [make("span", { class: "tag quiet", text: `${one.helping.join(", ")} helps` })] : []),
      ...(one.text ? [make("p", { class: "asks", dir: "auto", text: one.text })] : []),
      make("div", { class: "row small" },
        ...(one.room === room?.id ? [] : [button("Go there", () => goTo(app, one.room), { class: "main", "aria-label": `Go there: ${inText(one.name)}` })]),
        button("Hand down", () => connection.send("lower_hand", { room: one.room }), { "aria-label": `Hand down: ${inText(one.name)}` })))));
  });

  panel.append(hand, own, lead);
  document.addEventListener("panel", (event) => /** @type {CustomEvent} */ (event).detail === "panel-own" && void look());
  store.on(["room"], () => panel.hidden || void look());
}
