// The virtual pointer in its tab: a new one for every scene.

import { COMMANDING, whyNoCommand } from "../allowed.js";
import { byId } from "../dom.js";
import { VirtualPointer } from "../pointer.js";

/** @param {import("../pages/room.js").App} app */
export function mountPointing({ store, connection, world, command }) {
  const panel = byId("panel-pointer");
  const place = byId("pointer");
  /** @type {VirtualPointer | null} */
  let pointer = null;
  let before = ""; // mode of the session
  world.sceneWatchers.push((viewer) => {
    pointer?.dispose();
    pointer = null;
    place.replaceChildren();
    if (!viewer) return;
    pointer = new VirtualPointer({
      viewer, panel: place, state: () => world.state,
      ask: (question) => connection.ask("reach", { ...question }),
      go: (action) => command(action),
    });
    may();
  });
  document.addEventListener("panel", (event) => {
    if (/** @type {CustomEvent} */ (event).detail === "panel-pointer") appear();
    else pointer?.show(false);
  });
  world.watchers.push(appear);

  /** It is there as long as its tab is open, from the first pose on. */
  function appear() {
    if (world.state && pointer?.wanted && !pointer.visible && !panel.hidden) pointer.show(true);
  }
  store.on(COMMANDING, may);
  store.on(["status"], ({ status }) => {
    if (status?.mode === "idle" && pointer?.visible && before !== status.mode) pointer.askAgain();
    before = status?.mode ?? "";
  });

  function may() {
    const why = whyNoCommand(store.now);
    pointer?.enable(!why, why);
  }
}
