// Pictures of contacts, drawn by the page's own viewer where the file has no still.

/** @typedef {import("../viewer/viewer.js").Viewer} Viewer */
/** @typedef {import("../viewer/replay.js").Replay} Replay */
/** @typedef {import("./page.js").Contact} Contact */

/**
 * Draw every canvas that stands for a contact, then show the replay as it was.
 * @param {Viewer} viewer @param {Replay} replay @param {Contact[]} contacts
 * @param {(contacts: Contact[]) => import("../viewer/viewer.js").Mark | null} mark
 */
export function drawSnapshots(viewer, replay, contacts, mark) {
  const canvases = /** @type {NodeListOf<HTMLCanvasElement>} */ (document.querySelectorAll("canvas[data-contact]"));
  for (const canvas of canvases) {
    const contact = contacts[Number(canvas.dataset.contact)];
    canvas.hidden = false;
    viewer.snapshot(canvas, replay.at(contact.deepest), mark([contact]));
  }
}
