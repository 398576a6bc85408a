// Two programs that are alike, side by side: both replays at the same time of their runs, both sources.

import { get } from "../api.js";
import { button, byId, make, write } from "../../live/dom.js";
import { inText } from "../../live/names.js";
import { mark, moment } from "../words.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Detail} Detail */

export const ALIKE = "/files/staff/similarity.html"; // the groups of the class
const LEAST = 3; // characters of a line that is worth being called the same

/** Show two programs in a dialog. @param {Desk} desk @param {string} first @param {string} second ids */
export async function compare(desk, first, second) {
  /** @type {Detail[]} */
  let both;
  try {
    both = await Promise.all([first, second].map((id) => /** @type {Promise<Detail>} */ (get(`/api/row/${encodeURIComponent(id)}`))));
  } catch (problem) {
    desk.failed(problem, () => void compare(desk, first, second));
    return;
  }
  const dialog = /** @type {HTMLDialogElement} */ (byId("compare"));
  const frames = both.map((one) => (one.report
    ? make("iframe", { src: `${one.report}#framed=picture&t=0`, title: `Replay of ${nameOf(one)}`, sandbox: "allow-scripts" })
    : make("p", { class: "soft no-frame", text: "There is no report of this one." })));
  const time = make("input", { type: "range", min: 0, max: 0, step: 0.01, value: 0, "aria-label": "Time of both replays" });
  const told = make("output", { text: moment(0) });
  const ends = [-1, -1]; // -1: its replay is not there yet
  const show = (/** @type {number} */ at) => {
    write(told, moment(at));
    for (const frame of frames) if (frame instanceof HTMLIFrameElement) frame.contentWindow?.postMessage({ vrts: "show", time_s: at }, "*");
  };
  time.addEventListener("input", () => show(Number(time.value)));
  const hear = (/** @type {MessageEvent} */ event) => {
    const k = frames.findIndex((frame) => frame instanceof HTMLIFrameElement && frame.contentWindow === event.source);
    if (k < 0 || event.data?.vrts !== "shown" || !Number.isFinite(event.data.end_s) || ends[k] >= 0) return;
    ends[k] = Math.max(event.data.end_s, 0);
    time.max = String(Math.max(...ends));
    show(Number(time.value)); // who was not there yet
  };
  window.addEventListener("message", hear);
  const close = button("Close", () => dialog.close(), { class: "main" });
  dialog.addEventListener("close", () => {
    window.removeEventListener("message", hear);
    dialog.replaceChildren(); // the replays end
  }, { once: true });
  const [mine, theirs] = both.map((one) => new Set((one.source?.lines ?? []).map(plain)));
  dialog.replaceChildren(
    make("div", { class: "row" }, make("h2", { id: "compare-title", text: `${nameOf(both[0])} and ${nameOf(both[1])}` }), make("span", { class: "fill" }),
      make("a", { class: "button", href: ALIKE, target: "_blank", rel: "noopener", text: "All that are alike" }), close),
    make("div", { class: "row both" }, make("span", { class: "soft", text: "Time of both" }), time, told),
    make("div", { class: "pair" }, ...both.map((one, k) => make("section", { "aria-label": nameOf(one) },
      make("h3", { text: `${nameOf(one)}, ${mark(one.row.final)}` }), make("div", { class: "frame" }, frames[k]), lines(one, k ? mine : theirs)))),
    make("p", { class: "soft", text: "Lines that both have are marked. Look and decide: likeness never changes a mark." }));
  dialog.showModal();
  close.focus();
}

/** @param {Detail} one */
function nameOf(one) {
  return inText(one.row.name || one.row.id);
}

/** Return a program; lines that the other one has too are marked. @param {Detail} one @param {Set<string>} other */
function lines(one, other) {
  const text = one.source?.lines ?? [];
  return make("ol", { class: "code", tabindex: "0", "aria-label": `Program of ${nameOf(one)}` },
    ...(text.length ? text.map((line, k) => {
      const same = plain(line).length > LEAST && other.has(plain(line));
      return make("li", same ? { class: "same" } : {}, make("span", { class: "n", text: String(k + 1) }), make("code", { text: line }), make("span", { class: "unseen", text: same ? " (both have it)" : "" }));
    }) : [make("li", { class: "soft nothing", text: one.source_problem || "There is no program to show." })]));
}

/** Return a line without what layout and capitals make different. @param {string} line */
function plain(line) {
  return line.trim().replace(/\s+/g, " ").toLowerCase();
}
