// The panel of the editor. What it needs is loaded when it is opened for the first time.

import { byId, make } from "../dom.js";

/** @param {import("../pages/room.js").App} app */
export function mountEditor(app) {
  const panel = byId("panel-editor");
  const waiting = make("p", { class: "soft", role: "status", text: "The editor is being loaded …" });
  panel.append(waiting);
  /** @type {Promise<void> | null} */
  let loading = null;

  async function load() {
    const { openWorkbench } = await import("./workbench.js");
    openWorkbench(app, panel);
    waiting.remove();
  }

  function open() {
    loading ??= load().catch((error) => {
      loading = null; // the next time may be better
      waiting.textContent = "The editor could not be loaded. Choose another panel, then this one again. If that does not help, load the page again.";
      app.toasts.warn(/** @type {Error} */ (error).message);
    });
  }
  document.addEventListener("panel", (event) => {
    if (/** @type {CustomEvent} */ (event).detail === panel.id) open();
  });
  if (!panel.hidden) open();
}
