// The wall: every room at a glance, with a still of its robot.

import { Bodies } from "../bodies.js";
import { Connection, Refusal } from "../connection.js";
import { byId, button, figure, make, write } from "../dom.js";
import { Intake } from "../intake.js";
import { isolated } from "../names.js";
import { barOf, mountNotices } from "../notices.js";
import { mountEntrance } from "../panels/entrance.js";
import { Store } from "../store.js";
import { Toasts } from "../toasts.js";
import { Stills } from "../stills.js";

const NONE = "There are no rooms yet.";

/** @param {import("../account.js").Me} me */
export function showWall(me) {
  byId("wall").hidden = false;
  document.title = "Wall · vrts";
  const none = byId("wall-none");
  if (!me.supervisor) {
    none.hidden = false;
    none.textContent = "Only a supervisor sees the wall.";
    return;
  }
  const store = new Store();
  const toasts = new Toasts(byId("toasts"));
  mountEntrance(toasts, store);
  store.on(["code"], ({ code }) => write(byId("wall-code"), code.code ? `Class code ${code.code}` : "Class code"));
  const intake = new Intake(store, new Bodies(), {
    refused: (message) => toasts.warn(new Refusal(/** @type {any} */ (message)).message),
    jumped: () => undefined,
    left: () => undefined,
    now: () => 0,
  });
  const connection = new Connection({
    message: (message) => {
      intake.take(message);
      if (message.type === "snapshot") connection.send("watch_wall", { on: true });
    },
    frame: () => undefined,
    state: (state, why) => store.set({ connection: state, ended: why ?? "" }),
  });
  connection.rate = 1;
  store.set({ supervisor: true });
  mountNotices(barOf("wall"), { store, connection }, { stops: false });
  const stills = new Stills();
  /** @type {Map<string, Card>} */
  const cards = new Map();
  store.on(["wall", "projector"], ({ wall, projector }) => {
    for (const [id, card] of cards) {
      if (wall.some((row) => row.id === id)) continue;
      card.element.remove();
      cards.delete(id);
    }
    for (const row of wall) {
      const card = cards.get(row.id) ?? new Card(row.id, connection);
      cards.set(row.id, card);
      if (!card.element.isConnected) byId("wall-cards").append(card.element);
      card.show(row, row.id === projector);
      void stills.draw(card.canvas, row).catch((error) => toasts.warn(error.message));
    }
    none.hidden = wall.length > 0;
    write(none, NONE);
  });
  connection.enter("");
  Object.assign(window, { vrts: { store, connection } }); // for tests and for the curious
}

/** One room on the wall. */
class Card {
  /** @param {string} id @param {Connection} connection */
  constructor(id, connection) {
    this.canvas = make("canvas", { width: 480, height: 300, role: "img", "aria-label": "The robot now" });
    this.title = make("h2", { class: "card-name" });
    this.task = make("p", { class: "soft" });
    this.line = make("code", { class: "card-line" });
    this.facts = make("dl", { class: "facts" });
    this.tags = make("p", { class: "tags" });
    this.project = button("Project", () => connection.send("project", { room: id }));
    this.open = make("a", { class: "button", href: `/?room=${encodeURIComponent(id)}`, text: "Open" });
    this.element = make("article", { class: "room-card", "data-room": id }, this.canvas, this.title, this.task, this.line, this.facts, this.tags,
      make("div", { class: "row" }, this.open, this.project));
  }

  /** @param {import("../protocol.js").WallRow} row @param {boolean} projected */
  show(row, projected) {
    write(this.title, row.name);
    write(this.task, row.task || row.scene);
    write(this.line, row.line);
    this.line.hidden = !row.line;
    this.project.setAttribute("aria-label", `Project ${row.name}`);
    this.open.setAttribute("aria-label", `Open ${row.name}`);
    const facts = [
      ["Operator", row.operator ? isolated(row.operator) : "nobody"], ["People", row.queue ? `${row.people}, ${row.queue} waiting` : String(row.people)],
      ["Time", `${figure(row.time_s, 0)} s`], ["Contacts", String(row.contacts)], ["Mark", row.mark === null ? "–" : figure(row.mark, 1)],
    ];
    this.facts.replaceChildren(...facts.map(([name, text]) => make("div", {}, make("dt", { text: String(name) }), make("dd", {}, text))));
    this.element.classList.toggle("touched", row.contacts > 0);
    this.tags.replaceChildren(
      ...row.hands.map((name) => make("span", { class: "tag review" }, isolated(name), " raises a hand")),
      ...(projected ? [make("span", { class: "tag", text: "on the projector" })] : []),
      ...(row.stopped ? [make("span", { class: "tag review" }, "stopped by ", isolated(row.stopped))] : []),
      ...(row.alive ? [] : [make("span", { class: "tag quiet", text: "does not run" })]),
    );
  }
}
