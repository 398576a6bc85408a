// What is in the editor, kept by the browser so that loading the page again loses nothing.

/** @typedef {{text: string, saved: string, opened: import("./workbench.js").Opened}} Draft */

/** @param {string} room @returns {Draft | null} */
export function keptDraft(room) {
  try {
    const found = JSON.parse(sessionStorage.getItem(`vrts draft ${room}`) ?? "null");
    return typeof found?.text === "string" && typeof found.saved === "string" && found.opened ? found : null;
  } catch {
    return null; // whatever lies there is no draft
  }
}

/** @param {string} room @param {Draft} draft */
export function keepDraft(room, draft) {
  try {
    sessionStorage.setItem(`vrts draft ${room}`, JSON.stringify(draft));
  } catch {
    sessionStorage.removeItem(`vrts draft ${room}`); // the browser has no room for it: saving still works
  }
}
