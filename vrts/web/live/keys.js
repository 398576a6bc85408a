// Keys that work everywhere on the page.

import { byId } from "./dom.js";

const TWICE = 700; // within which Escape counts as pressed twice [ms]
const ALT = { KeyO: "hand-open", KeyC: "hand-close", KeyR: "ready", KeyM: "terminal-line" };

/**
 * Return the code of a key that is pressed with Alt alone; "" where that types something, as Option does on a Mac.
 * @param {KeyboardEvent} event
 */
export function withAlt(event) {
  if (!event.altKey || event.ctrlKey || event.metaKey) return "";
  const own = event.code.replace(/^Key/, "").toLowerCase();
  const types = event.key === "Dead" || (event.key.length === 1 && event.key.toLowerCase() !== own);
  return types && takesText(event.composedPath()[0]) ? "" : event.code;
}

/** @param {EventTarget | undefined} place */
function takesText(place) {
  return place instanceof HTMLElement && (place.isContentEditable || place.matches("textarea, input:not([type=range], [type=checkbox], [type=radio])"));
}

/** @param {import("./pages/room.js").App} app */
export function bindKeys(app) {
  let escaped = -Infinity;
  document.addEventListener("keydown", (event) => { // after all others: an Escape that closes something is no alarm
    if (event.key !== "Escape" || event.repeat || event.defaultPrevented) return;
    if (/** @type {Element} */ (event.target).shadowRoot) return; // the editor: Escape leaves it
    if (document.querySelector("dialog[open], :popover-open")) return;
    if (event.timeStamp - escaped < TWICE && !byId("panic").hidden) app.panic();
    escaped = event.timeStamp;
  });
  document.addEventListener("keydown", (event) => {
    const id = ALT[/** @type {keyof typeof ALT} */ (withAlt(event))];
    if (!id) return;
    event.preventDefault();
    if (id === "terminal-line") byId(id).focus();
    else byId(id).click();
  }, true);
}
