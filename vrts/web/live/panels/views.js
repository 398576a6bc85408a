// Preset view points and the camera's buttons.

import { byId } from "../dom.js";

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
