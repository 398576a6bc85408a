// The supervisor's panel: control right, order, scene, rooms, logs.

import { byId, button, choice, download, make, onSubmit, write } from "../dom.js";
import { settle } from "../focus.js";
import { waysIn } from "./ways_in.js";

const ELSEWHERE = { target: "_blank", rel: "noopener" };

/**
 * @param {import("../pages/room.js").App} app @param {ReturnType<import("./entrance.js").mountEntrance>} entrance
 * @param {import("../account.js").Me} me an assistant leads some rooms, and nothing that is for all of them
 */
export function mountLead({ store, connection, toasts }, entrance, me) {
  const whole = me.supervisor;
  const panel = byId("panel-lead");
  const told = (/** @type {string} */ type, /** @type {Record<string, unknown>} */ fields = {}) =>
    connection.send(type, fields) || toasts.warn("there is no connection at the moment");

  // --- the control right
  const lock = button("Lock", () => told("lock", { on: !store.now.control.locked }), { id: "lead-lock", title: "Nobody gets control, and whoever has it cannot move anything" });
  const freeze = button("Freeze", () => told("freeze", { on: !store.now.control.frozen }), { id: "lead-freeze", title: "Stop the arm, and refuse all commands" });
  const chat = button("Chat off", () => told("set_chat", { on: !store.now.control.chat }), { id: "lead-chat", title: "Students still write to you privately" });
  const turn = make("input", { type: "number", id: "turn-s", title: "Longest turn while others wait; 0: no limit", min: "0", max: "86400", step: "10", required: true });
  const idle = make("input", { type: "number", id: "idle-s", title: "Longest time without a command; 0: no limit", min: "0", max: "86400", step: "10", required: true });
  const times = make("form", { class: "row" }, make("label", { text: "Turn [s] " }, turn), make("label", { text: "Idle [s] " }, idle), make("button", { text: "Set" }),
    make("span", { class: "soft", text: "0: no limit" }));
  onSubmit(times, () => told("set_turn", { turn_s: Number(turn.value), idle_s: Number(idle.value) }));
  store.on(["control"], ({ control }) => {
    for (const [element, on, yes, no] of /** @type {const} */ ([[lock, control.locked, "Unlock", "Lock"], [freeze, control.frozen, "Unfreeze", "Freeze"], [chat, !control.chat, "Chat on", "Chat off"]])) {
      write(element, on ? yes : no);
      element.classList.toggle("engaged", on);
    }
    if (document.activeElement !== turn) turn.value = String(control.turn_s);
    if (document.activeElement !== idle) idle.value = String(control.idle_s);
  });

  // --- the scene
  const scene = choice([], { id: "lead-scene", "aria-label": "Scene" });
  const begin = button("Begin again in this scene", () => window.confirm("End what is going on, and begin again?") && told("set_scene", { scene: scene.value }));

  const everywhere = choice([["", "no new scene"]], { id: "broadcast-scene", "aria-label": "Scene for all rooms" });

  // --- rooms
  const names = make("textarea", { id: "new-rooms", rows: 4, placeholder: "Group 1\nGroup 2", spellcheck: "false" });
  const roomScene = choice([], { id: "new-scene", "aria-label": "Scene of the new rooms" });
  const build = button("Make rooms", () => {
    const wanted = names.value.split("\n").map((name) => name.trim()).filter(Boolean);
    if (!wanted.length) return;
    if (told("make_rooms", { rooms: wanted.map((name) => ({ name: name.slice(0, 64), scene: roomScene.value })) })) names.value = "";
  });
  const rooms = make("ul", { class: "rooms", "aria-label": "Rooms" });
  store.on(["rooms", "projector", "room", "people"], ({ rooms: all, projector, room, people }) => {
    const crowd = (/** @type {import("../protocol.js").RoomEntry} */ one) => (one.id === room?.id ? new Set(people.map(({ name }) => name)).size : one.people);
    settle(rooms, all.map((one) => make("li", { "data-key": one.id },
      make("span", { class: "person", text: one.name }),
      make("span", { class: "soft", text: ` ${crowd(one) === 1 ? "1 person" : `${crowd(one)} people`}, ${one.task || one.scene}` }),
      ...(one.id === room?.id ? [make("span", { class: "tag", text: "you are here" })] : []),
      ...(one.id === projector ? [make("span", { class: "tag review", text: "projector" })] : []),
      make("div", { class: "row small" },
        make("a", { class: "button", href: `/?room=${encodeURIComponent(one.id)}`, text: "Open", "aria-label": `Open ${one.name}` }),
        ...(whole ? [button("Project", () => told("project", { room: one.id }), { "aria-label": `Project ${one.name}` }),
          button("Link", () => void entrance.showLink(one), { "aria-label": `Link into ${one.name}`, title: "A link that lets into this room only" })] : []),
        button("Replay", () => void replay(one), { "aria-label": `Replay of ${one.name}`, title: "A page that shows all that was done, forward and backward" }),
        button("Log", () => log(one.id), { "aria-label": `Log of ${one.name}`, title: "To be replayed, marked or kept" }),
        button("Close", () => window.confirm(`Close ${one.name} for good?`) && told("close_room", { room: one.id }), { "aria-label": `Close ${one.name}` })))));
  });
  store.on(["scenes", "room"], ({ scenes, room }) => {
    for (const select of [scene, roomScene]) {
      const before = select.value || room?.scene;
      select.replaceChildren(...scenes.map(({ id, task }) => make("option", { value: id, text: task ? `${id} (task)` : id, selected: id === before })));
    }
    everywhere.replaceChildren(make("option", { value: "", text: "no new scene" }), ...scenes.map(({ id }) => make("option", { value: id, text: id })));
  });

  /** Let a page be made of what was done in a room, and keep it. @param {import("../protocol.js").RoomEntry} room */
  async function replay(room) {
    toasts.tell(`the replay of ${room.name} is being made …`);
    const answer = await fetch(`/replay/${encodeURIComponent(room.id)}`);
    if (answer.ok) download(`${room.name}.html`, await answer.text());
    else toasts.warn((await answer.json()).text);
  }

  /** @param {string} room */
  async function log(room) {
    try {
      const { url } = await connection.ask("export_log", { room });
      make("a", { href: new URL(url, location.href).pathname + new URL(url, location.href).search, download: "" }).click();
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
  }

  // --- everybody
  const text = make("input", { id: "broadcast-text", maxlength: 1000, placeholder: "Message to all rooms", "aria-label": "Message to all rooms" });
  const broadcast = make("form", { class: "row" }, text, everywhere, make("button", { text: "Send to all" }));
  onSubmit(broadcast, () => {
    if (!text.value.trim() && !everywhere.value) return;
    if (everywhere.value && !window.confirm("Begin again in all rooms?")) return;
    if (told("broadcast", { text: text.value.trim(), scene: everywhere.value })) text.value = everywhere.value = "";
  });

  panel.append(
    make("div", { class: "block first" }, make("h2", { text: "This room" }),
      make("div", { class: "row" }, button("Take control", () => told("hand_over", { person: store.now.you }), { title: "At once, before the queue" }),
        button("Free control", () => told("hand_over", { person: "" }), { title: "Take it from the person who has it; the first in the queue is next" })), make("div", { class: "row" }, lock, freeze, chat), times,
      make("div", { class: "row" }, scene, begin)),
    ...(me.teaches ? [make("div", { class: "block" }, make("h2", { text: "Course" }), make("div", { class: "row" },
      make("a", { class: "button", href: "/course/board", text: "Board" }), ...(whole ? [make("a", { class: "button", href: "/course/people", text: "People" })] : [])))] : []),
    ...(whole ? [] : [make("div", { class: "block" }, make("h2", { text: "Rooms" }), rooms)]),
  );
  if (!whole) return;
  panel.append(
    make("div", { class: "block" }, make("h2", { text: "All rooms" }),
      make("div", { class: "row" }, button("Class code", () => void entrance.showCode()),
        make("a", { class: "button", href: "/?wall", text: "Wall", ...ELSEWHERE }), make("a", { class: "button", href: "/?projector", text: "Projector", ...ELSEWHERE })),
      make("div", { class: "row" }, button("Freeze all", () => told("freeze", { on: true, everywhere: true })), button("Unfreeze all", () => told("freeze", { on: false, everywhere: true }))),
      broadcast, rooms),
    waysIn(store, toasts, entrance),
    make("div", { class: "block" }, make("h2", { text: "New rooms" }), make("label", { for: "new-rooms", class: "soft", text: "One name on each line" }), names,
      make("div", { class: "row" }, roomScene, build)),
  );
}
