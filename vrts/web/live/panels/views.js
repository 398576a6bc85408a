// Preset view points, the camera's buttons, and the keys of the picture.

import { MOVES, moveOf } from "../camera.js";
import { beside, byId, button, make } from "../dom.js";

const KEYS = { 1: "overview", 2: "table", 3: "front", 4: "side", 5: "top", 6: "hand" };

/**
 * @param {import("../pages/room.js").App} app
 * @param {{look: string, keepLook: (name: string) => void} | null} kept which view point to begin with; null: the overview
 */
export function mountViews({ world }, kept = null) {
  byId("views").addEventListener("click", (/** @type {MouseEvent} */ event) => {
    const pressed = /** @type {HTMLElement} */ (event.target).closest("button");
    if (!pressed || !world.viewer) return;
    const { look: wanted, turn, zoom } = pressed.dataset;
    if (wanted) world.look(wanted);
    if (turn) world.viewer.turn(-0.3 * Number(turn));
    if (zoom) world.viewer.zoom(Number(zoom));
  });
  byId("view").addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    const { viewer } = world;
    if (!viewer || event.altKey || event.ctrlKey || event.metaKey) return;
    const wanted = KEYS[/** @type {keyof typeof KEYS} */ (/** @type {unknown} */ (event.key))];
    const move = moveOf(event);
    if (wanted) world.look(wanted);
    else if (move) move(viewer);
    else return;
    event.preventDefault();
  });
  byId("views").after(...menu(world));
  if (kept) world.beginning = kept.look;
  world.lookWatchers.push((name, chosen) => {
    show(name);
    if (chosen) kept?.keepLook(name);
  });
  world.sceneWatchers.push((viewer) => {
    viewer?.canvas.addEventListener("pointerdown", () => {
      if (!viewer.following) show("");
    });
  });

  /** @param {string} name of the view point that is shown; empty: another one */
  function show(name) {
    for (const button of byId("views").querySelectorAll("[data-look]")) {
      button.setAttribute("aria-pressed", String(/** @type {HTMLElement} */ (button).dataset.look === name));
    }
  }
}

/**
 * Return a button and what it opens: all that dragging in the picture does, and the view points that a narrow bar leaves out.
 * @param {import("../world.js").World} world
 */
function menu(world) {
  const opener = make("button", { type: "button", id: "camera-button", popovertarget: "camera", title: "Turn, tilt and shift the picture without dragging" }, "Camera");
  const moves = Object.entries(MOVES).map(([title, keys]) => make("div", { class: "moves", role: "group", "aria-label": title }, make("span", { "aria-hidden": "true", text: title }),
    ...Object.entries(keys).map(([key, [sign, text, move]]) => button(sign, () => world.viewer && move(world.viewer), { "data-move": key, "aria-label": text, title: `${text} (${key.replace(" ", "+")} in the picture)` }))));
  const looks = ["front", "side"].map((name) => button(name === "front" ? "Front" : "Side", () => world.look(name)));
  const box = make("div", { class: "menu camera", id: "camera", popover: "", role: "dialog", "aria-label": "Camera" },
    ...moves, make("div", { class: "row only-narrow" }, ...looks));
  beside(opener, box);
  return [opener, box];
}
