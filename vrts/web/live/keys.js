// Keys that work everywhere on the page.

import { byId } from "./dom.js";

const TWICE = 700; // within which Escape counts as pressed twice [ms]
const ALT = { KeyO: "hand-open", KeyC: "hand-close", KeyR: "ready", KeyM: "terminal-line" };
const VIEWS = { 1: "overview", 2: "table", 3: "front", 4: "side", 5: "top", 6: "hand" };

/** @param {import("./pages/room.js").App} app */
export function bindKeys(app) {
  let escaped = -Infinity;
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.repeat) {
      if (event.timeStamp - escaped < TWICE && !byId("panic").hidden) app.panic();
      escaped = event.timeStamp;
      return;
    }
    const id = event.altKey && !event.ctrlKey ? ALT[/** @type {keyof typeof ALT} */ (event.code)] : undefined;
    if (!id) return;
    event.preventDefault();
    if (id === "terminal-line") byId(id).focus();
    else byId(id).click();
  }, true);
  byId("view").addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    const { viewer } = app.world;
    if (!viewer || event.altKey || event.ctrlKey || event.metaKey) return;
    const view = VIEWS[/** @type {keyof typeof VIEWS} */ (/** @type {unknown} */ (event.key))];
    if (view) app.world.look(view);
    else if (event.key === "ArrowLeft") viewer.turn(0.15);
    else if (event.key === "ArrowRight") viewer.turn(-0.15);
    else if (event.key === "+") viewer.zoom(0.85);
    else if (event.key === "-") viewer.zoom(1.18);
    else return;
    event.preventDefault();
  });
}
