// Attempts at an assignment: each with its public mark, every lost point, and what led to it.

import { make, prose } from "../../live/dom.js";
import { when } from "./words.js";

const PRELIMINARY = "Public marks are preliminary: lateness, hidden checks and graders count when the class is marked.";

/** @typedef {import("../../live/panels/assignments.js").Attempt} Attempt */
/** @typedef {import("../../live/panels/assignments.js").Loss} Loss */

/** Return the list of attempts, the latest first. @param {string} id of the assignment @param {Attempt[]} attempts */
export function attemptList(id, attempts) {
  if (!attempts.length) return [make("p", { class: "soft", text: "You have handed in nothing yet." })];
  return [make("p", { class: "soft", text: PRELIMINARY }), ...attempts.map((attempt, index) => one(id, attempt, index === 0))];
}

/** @param {string} id @param {Attempt} attempt @param {boolean} latest */
function one(id, attempt, latest) {
  const head = make("header", {}, make("h4", { text: `Attempt ${attempt.number}` }), ...mark(attempt), make("span", { class: "soft", text: when(attempt.at) }));
  if (attempt.by) head.append(make("span", { class: "soft", text: `by ${attempt.by}` }));
  if (attempt.late) head.append(make("span", { class: "sign late", text: attempt.late }));
  const links = make("p", { class: "row" });
  if (attempt.page) links.append(make("a", { class: "button", href: `/course/work/page/${id}/${attempt.number}`, target: "_blank", rel: "noopener", text: "Report and replay", "aria-label": `Report and replay of attempt ${attempt.number}` }));
  links.append(make("a", { class: "button", href: `/course/work/program/${id}/${attempt.number}`, download: true, text: "Program", "aria-label": `Program of attempt ${attempt.number}` }));
  const losses = attempt.losses ?? [];
  const list = losses.length ? [make("ul", { class: "losses", "aria-label": "Points lost" }, ...losses.map(loss))]
    : attempt.state === "marked" && !attempt.said ? [make("p", { class: "said-here", text: "No points lost." })] : [];
  const said = attempt.said ? [make("p", { class: "said-here" }, ...prose(attempt.said))] : [];
  const body = [...said, ...list, links];
  if (latest) return make("article", { class: "attempt" }, head, ...body);
  return make("article", { class: "attempt" }, head, make("details", {}, make("summary", { text: "Show" }), ...body));
}

/** @param {Attempt} attempt @returns {Node[]} */
function mark(attempt) {
  if (attempt.state === "waiting") {
    const before = attempt.before ?? 0;
    return [make("span", { class: "sign", role: "status", text: before ? `waits for its mark, ${before} before it` : "is being marked" })];
  }
  if (attempt.state !== "marked") return [make("span", { class: "sign bad", text: "no public mark" })];
  return [make("span", { class: "mark" }, attempt.mark ?? "", make("small", { text: ` of ${attempt.total}` }))];
}

/** @param {Loss} loss */
function loss({ points, cause, line, time_s: at, hint, why }) {
  const words = make("div", { class: "cause" }, ...prose(cause));
  const place = [line && `line ${line}`, at !== undefined && `${at.toFixed(2)} s`].filter(Boolean).join(", ");
  if (place) words.append(" ", make("span", { class: "soft", text: `(${place})` }));
  if (hint) words.append(make("div", { class: "soft" }, ...prose(hint)));
  if (why?.length) words.append(make("details", {}, make("summary", { text: "Why" }), make("ol", {}, ...why.map((step) => make("li", {}, ...prose(step.replace(/^←\s*/, "")))))));
  return make("li", {}, make("span", { class: "points", text: `−${points}` }), words);
}
