// The supervisor's panel: control right, order, scene, rooms, logs.

import { byId, button, choice, make, onSubmit, write } from "../dom.js";

/** @param {import("../pages/room.js").App} app */
export function mountLead({ store, connection, toasts }) {
  const panel = byId("panel-lead");
  const told = (/** @type {string} */ type, /** @type {Record<string, unknown>} */ fields = {}) =>
    connection.send(type, fields) || toasts.warn("there is no connection at the moment");

  // --- the control right
  const lock = button("Lock", () => told("lock", { on: !store.now.control.locked }), { id: "lead-lock" });
  const freeze = button("Freeze", () => told("freeze", { on: !store.now.control.frozen }), { id: "lead-freeze" });
  const chat = button("Chat off", () => told("set_chat", { on: !store.now.control.chat }), { id: "lead-chat" });
  const turn = make("input", { type: "number", id: "turn-s", min: "0", max: "86400", step: "10", required: true });
  const idle = make("input", { type: "number", id: "idle-s", min: "0", max: "86400", step: "10", required: true });
  const times = make("form", { class: "row" }, make("label", { text: "Turn [s] " }, turn), make("label", { text: "Idle [s] " }, idle), make("button", { text: "Set" }));
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
  const begin = button("Begin anew in this scene", () => window.confirm("End what is going on, and begin anew?") && told("set_scene", { scene: scene.value }));

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
    const crowd = (/** @type {import("../protocol.js").RoomEntry} */ one) => (one.id === room?.id ? people.length : one.people);
    rooms.replaceChildren(...all.map((one) => make("li", {},
      make("span", { class: "person", text: one.name }),
      make("span", { class: "soft", text: ` ${crowd(one) === 1 ? "1 person" : `${crowd(one)} people`}, ${one.task || one.scene}` }),
      ...(one.id === room?.id ? [make("span", { class: "tag", text: "you are here" })] : []),
      ...(one.id === projector ? [make("span", { class: "tag review", text: "projector" })] : []),
      make("div", { class: "row small" },
        make("a", { class: "button", href: `/?room=${encodeURIComponent(one.id)}`, text: "Open", "aria-label": `Open ${one.name}` }),
        button("Project", () => told("project", { room: one.id }), { "aria-label": `Project ${one.name}` }),
        button("Log", () => log(one.id), { "aria-label": `Log of ${one.name}` }),
        button("Close", () => window.confirm(`Close ${one.name} for good?`) && told("close_room", { room: one.id }), { "aria-label": `Close ${one.name}` })))));
  });
  store.on(["scenes", "room"], ({ scenes, room }) => {
    for (const select of [scene, roomScene]) {
      const before = select.value || room?.scene;
      select.replaceChildren(...scenes.map(({ id, task }) => make("option", { value: id, text: task ? `${id} (task)` : id, selected: id === before })));
    }
    everywhere.replaceChildren(make("option", { value: "", text: "no new scene" }), ...scenes.map(({ id }) => make("option", { value: id, text: id })));
  });

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
    if (everywhere.value && !window.confirm("Begin anew in all rooms?")) return;
    if (told("broadcast", { text: text.value.trim(), scene: everywhere.value })) text.value = everywhere.value = "";
  });

  // --- the class code
  const code = make("p", { class: "code" });
  const picture = make("img", { class: "qr", alt: "QR code of the link to this class", hidden: true });
  const shown = make("details", { class: "block", toggle: () => shown.open && showCode() }, make("summary", { text: "Class code" }), code, picture);
  async function showCode() {
    const answer = await fetch("/code");
    const known = answer.ok ? await answer.json() : { code: "", url: "" };
    write(code, known.code ? `${known.code} at ${new URL(known.url).host}` : "There is no class code.");
    picture.hidden = !known.code;
    if (known.code) picture.src = "/code.svg";
  }

  panel.append(
    make("div", { class: "block first" }, make("h2", { text: "This room" }),
      make("div", { class: "row" }, button("Take control", () => told("hand_over", { person: store.now.you })),
        button("Free control", () => told("hand_over", { person: "" }))), make("div", { class: "row" }, lock, freeze, chat), times,
      make("div", { class: "row" }, scene, begin)),
    make("div", { class: "block" }, make("h2", { text: "All rooms" }),
      make("div", { class: "row" }, make("a", { class: "button", href: "/?wall", text: "Wall" }), make("a", { class: "button", href: "/?projector", text: "Projector" }),
        button("Freeze all", () => told("freeze", { on: true, everywhere: true })), button("Unfreeze all", () => told("freeze", { on: false, everywhere: true }))),
      broadcast, rooms),
    make("div", { class: "block" }, make("h2", { text: "New rooms" }), make("label", { for: "new-rooms", class: "soft", text: "One name a line" }), names,
      make("div", { class: "row" }, roomScene, build)),
    shown,
  );
}
