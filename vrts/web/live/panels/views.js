// Preset view points and the camera's buttons.

import { byId } from "../dom.js";

/** @param {import("../pages/room.js").App} app */
export function mountViews({ world }) {
  byId("views").addEventListener("click", (/** @type {MouseEvent} */ event) => {
    const pressed = /** @type {HTMLElement} */ (event.target).closest("button");
    if (!pressed || !world.viewer) return;
    const { look: wanted, turn, zoom } = pressed.dataset;
    if (wanted) world.look(wanted);
    if (turn) world.viewer.turn(-0.3 * Number(turn));
    if (zoom) world.viewer.zoom(Number(zoom));
    for (const other of byId("views").querySelectorAll("[data-look]")) {
      if (wanted) other.setAttribute("aria-pressed", String(other === pressed));
    }
  });
  world.sceneWatchers.push((viewer) => {
    if (!viewer) return;
    viewer.canvas.addEventListener("pointerdown", () => {
      for (const chosen of byId("views").querySelectorAll("[aria-pressed=true]:not([data-look=hand])")) chosen.setAttribute("aria-pressed", "false");
    });
  });
}
