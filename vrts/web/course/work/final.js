// What the teacher has published about an assignment: the final mark, and what graders say.

import { make } from "../../live/dom.js";

/** @typedef {import("../../live/panels/assignments.js").Work} Work */
/** @typedef {import("../../live/panels/assignments.js").Comment} Comment */

/** Return the section with the final mark; nothing where none is published. @param {Work} work @returns {HTMLElement[]} */
export function finalOf(work) {
  const { final } = work;
  if (!final) return [];
  const list = (/** @type {string} */ label, /** @type {Node[]} */ items) => (items.length ? [make("h4", { text: label }), make("ul", { class: "told", "aria-label": label }, ...items)] : []);
  const lines = (/** @type {string[]} */ texts) => texts.map((text) => make("li", { text }));
  return [make("section", { class: "final", "aria-labelledby": "work-final" },
    make("h3", { id: "work-final", text: final.mark }),
    ...list("How the mark came to be", lines(final.made_of)),
    ...list("From your graders", final.comments.map(comment)),
    ...list("Remarks", lines(final.remarks)),
    ...(final.page ? [make("p", { class: "row" }, make("a", { class: "button", href: `/course/work/final/${work.id}`, target: "_blank", rel: "noopener", text: "Report with comments" }))] : []))];
}

/** @param {Comment} said */
function comment({ who, text, line, time_s: at, points }) {
  const place = [line && `line ${line}`, at !== undefined && `${at.toFixed(2)} s`].filter(Boolean).join(", ");
  return make("li", {}, ...(place ? [make("b", { text: `${place}: ` })] : []), text, ...(points ? [` (${points})`] : []), ...(who ? [make("span", { class: "soft", text: ` — ${who}` })] : []));
}
