// The virtual pointer in its tab: a new one for every scene.

import { COMMANDING, whyNoCommand } from "../allowed.js";
import { byId } from "../dom.js";
import { isLive, onLive } from "../looking.js";

/** @param {import("../pages/room.js").App} app */
export function mountPointing({ store, connection, world, command, toasts }) {
  const panel = byId("panel-pointer");
  const place = byId("pointer");
  /** @type {import("../pointer.js").VirtualPointer | null} */
  let pointer = null;
  /** @type {{box: HTMLElement} | null} */
  let tools = null;
  /** @type {Promise<void> | null} */
  let coming = null; // its modules: a fifth of the page's own, and most who watch never need them
  let before = ""; // mode of the session
  world.sceneWatchers.push((viewer) => {
    pointer?.dispose();
    pointer = null;
    place.replaceChildren();
    if (!panel.hidden) fetched();
  });

  /** Make the pointer of the scene, once its modules are there. */
  function fetched() {
    coming ??= Promise.all([import("../pointer.js"), import("../pointing/tools.js")]).then(([{ VirtualPointer }, { mountTools }]) => {
      coming = null;
      if (pointer || !world.viewer) return;
      tools ??= mountTools({ store, world, pointer: () => pointer });
      pointer = new VirtualPointer({
        viewer: world.viewer, panel: place, state: () => world.state, past: () => !isLive(),
        ask: (question) => connection.ask("reach", { ...question }),
        go: (action) => command(action),
      });
      place.append(tools.box);
      may();
      appear();
    }, (problem) => {
      coming = null; // the next time that the tab is opened they are asked for again
      toasts.warn(`the pointer could not be loaded (${problem.message}): load the page again`);
    });
  }

  document.addEventListener("panel", (event) => {
    if (/** @type {CustomEvent} */ (event).detail !== "panel-pointer") pointer?.show(false);
    else if (pointer) appear();
    else fetched();
  });
  world.watchers.push(appear);

  /** It is there as long as its tab is open, from the first pose on. */
  function appear() {
    if (world.state && pointer?.wanted && !pointer.visible && !panel.hidden) pointer.show(true);
  }
  onLive(() => pointer?.visible && pointer.askAgain());
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
