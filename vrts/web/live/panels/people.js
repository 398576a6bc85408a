// Who is here, in which role, and who waits; for supervisors, what can be done about them.

import { byId, button, make, write } from "../dom.js";
import { settle } from "../focus.js";
import { badges, inText, isolated } from "../names.js";
import { ordinal, persons } from "../persons.js";
import { count } from "./tabs.js";

/** @param {import("../pages/room.js").App} app */
export function mountPeople({ store, connection, toasts }) {
  const panel = byId("panel-people");
  const hand = button("Raise hand", () => {
    const { people, you } = store.now;
    connection.send("raise_hand", { up: !people.find(({ id }) => id === you)?.hand });
  }, { id: "raise-hand" });
  const list = make("ul", { class: "people", "aria-label": "People" });
  const sentAway = held("Sent away", "Let in again", "allow", connection);
  const silent = held("Muted (even under another name)", "Let speak again", "unmute", connection);
  const code = make("p", { class: "class-code", hidden: true });
  store.on(["code", "supervisor"], ({ code: { code: text }, supervisor }) => {
    code.hidden = !supervisor || !text;
    write(code, `Class code ${text}`);
  });
  panel.append(make("div", { class: "row" }, hand, code), list, sentAway.place, silent.place);
  store.on(["barred", "muted", "supervisor"], ({ barred, muted, supervisor }) => {
    sentAway.show(supervisor ? barred : []);
    silent.show(supervisor ? muted : []);
  });

  /** @type {Set<string>} */
  let raised = new Set();
  store.on(["people", "supervisor"], ({ people, you, supervisor }) => {
    const now = people.filter(({ id, hand: up }) => up && id !== you);
    for (const { name } of supervisor ? now.filter(({ id }) => !raised.has(id)) : []) {
      count("people");
      toasts.tell(`${inText(name)} raises a hand`);
    }
    raised = new Set(now.map(({ id }) => id));
  });

  store.on(["people", "control", "you", "supervisor"], ({ people, control, you, supervisor }) => {
    const mine = people.find(({ id }) => id === you);
    write(hand, mine?.hand ? "Lower hand" : "Raise hand");
    hand.setAttribute("aria-pressed", String(Boolean(mine?.hand)));
    const rank = (/** @type {import("../protocol.js").Person} */ person) => {
      const place = control.queue.indexOf(person.id);
      return person.id === control.holder ? 0 : place >= 0 ? 1 + place : person.hand ? 1000 : person.role === "supervisor" ? 2000 : 3000;
    };
    const rows = persons(people, control, you).sort((a, b) => rank(a) - rank(b) || a.name.localeCompare(b.name));
    settle(list, rows.map((person) => row(person, control, you, supervisor, connection)));
  });
}

/**
 * Return a list of names that a supervisor may undo something for.
 * @param {string} title @param {string} undo @param {string} message that undoes it @param {import("../connection.js").Connection} connection
 */
function held(title, undo, message, connection) {
  const list = make("ul", { class: "people", "aria-label": title });
  const place = make("div", { class: "block", hidden: true }, make("h2", { text: title }), list);
  const row = (/** @type {string} */ name) => make("li", {}, make("span", { class: "person" }, isolated(name)),
    make("div", { class: "row small" }, button(undo, () => connection.send(message, { name }), { "aria-label": `${undo}: ${inText(name)}` })));
  return {
    place,
    /** @param {string[]} names */
    show(names) {
      place.hidden = !names.length;
      settle(list, names.map(row));
    },
  };
}

/**
 * @param {import("../protocol.js").Person} person @param {import("../protocol.js").Control} control
 * @param {string} you @param {boolean} supervisor @param {import("../connection.js").Connection} connection
 */
function row(person, control, you, supervisor, connection) {
  const place = control.queue.indexOf(person.id);
  const tags = [
    place >= 0 && [`${ordinal(place + 1)} in the queue`, "tag"],
    person.hand && ["hand raised", "tag review"],
    person.muted && ["muted", "tag quiet"],
    person.away && ["away", "tag quiet"],
  ].filter(Boolean);
  const marks = /** @type {string[][]} */ (tags).map(([text, kind]) => make("span", { class: kind, text }));
  const holds = person.id === control.holder;
  const name = make("span", { class: "person" }, isolated(person.name), ...(person.id === you ? [" (you)"] : []));
  const roles = [...(person.role === "supervisor" ? badges("supervisor") : []), ...(holds ? badges("operator") : [])];
  const entry = make("li", { class: person.away ? "away" : "", "data-key": person.id }, name, ...roles, ...marks);
  if (supervisor) {
    const told = (/** @type {string} */ text, /** @type {string} */ type, /** @type {Record<string, unknown>} */ fields) =>
      button(text, () => connection.send(type, fields), { "data-do": `${type} ${person.id}`, "aria-label": `${text}: ${inText(person.name)}` });
    const buttons = [
      ...(person.id === control.holder ? [] : [told("Give control", "hand_over", { person: person.id })]),
      ...(person.id === you ? [] : [
        ...(person.role === "supervisor" ? [] : [
          told(person.muted ? "Unmute" : "Mute", "mute", { person: person.id, on: !person.muted }),
          button("Send away", () => window.confirm(`Send ${inText(person.name)} away? They cannot come back until you let them in again.`) && connection.send("kick", { person: person.id }), { "aria-label": `Send away: ${inText(person.name)}` }),
        ]),
      ]),
      ...(person.rate ? [make("span", { class: "soft", text: `${person.rate} fps` })] : []),
    ];
    entry.append(make("div", { class: "row small" }, ...buttons));
  }
  return entry;
}
