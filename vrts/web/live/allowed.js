// What may be done here now, and why not: what the server would refuse is not offered.

import { enable } from "./focus.js";

/**
 * Return why no command can be given now; empty: it can.
 * @param {import("./store.js").Known} now
 */
export function whyNoCommand(now) {
  const { connection, control, you, alive } = now;
  if (connection !== "open") return "There is no connection at the moment.";
  if (!you || control.holder !== you) return "Only the person with control can do this: take control first.";
  if (control.frozen) return "The supervisor has frozen the room.";
  if (control.locked) return "The supervisor has locked control.";
  if (!alive) return "The room has no session now.";
  return "";
}

/**
 * Return why no program can be saved for the room now; empty: it can.
 * @param {import("./store.js").Known} now
 */
export function whyNotForRoom({ control, you, supervisor }) {
  return supervisor || (you && control.holder === you) ? "" : "Only the person with control saves programs for the room: take control, or save it for yourself.";
}

/** The values that these read. @type {(keyof import("./store.js").Known)[]} */
export const COMMANDING = ["connection", "control", "you", "alive"];

/**
 * Let something be pressed, or say why not: to who points at it, and to who has it read out.
 * @param {HTMLButtonElement | HTMLInputElement | HTMLSelectElement} element @param {string} why not; empty: it may
 */
export function allow(element, why) {
  enable(element, why === "");
  if (element.dataset.title === undefined) element.dataset.title = element.title;
  const title = why || element.dataset.title;
  if (element.title !== title) element.title = title;
  if (why) element.setAttribute("aria-description", why);
  else element.removeAttribute("aria-description");
}
