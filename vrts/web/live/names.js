// Names of people: each isolated, since one may be written from right to left, and roles as badges.
// A name has letters only, so no name looks like a badge.

import { make } from "./dom.js";

const LEFTWARD = /[\u0590-\u08FF\uFB1D-\uFDFF\uFE70-\uFEFF\u{10800}-\u{10FFF}\u{1E800}-\u{1EFFF}]/u;
const BADGES = { supervisor: "supervisor", operator: "operator" };

/** Return a name as a part of a page that changes nothing around it. @param {string} name */
export function isolated(name) {
  return make("bdi", { class: "name", text: name });
}

/** Return a name as a part of a plain text, such as a notice or a label. @param {string} name */
export function inText(name) {
  return LEFTWARD.test(name) ? `\u2068${name}\u2069` : name;
}

/**
 * Return the badges of somebody; none of a viewer.
 * @param {string | null | undefined} role @returns {HTMLElement[]}
 */
export function badges(role) {
  const text = BADGES[/** @type {keyof typeof BADGES} */ (role ?? "")];
  return text ? [make("span", { class: `badge ${role}`, text })] : [];
}
