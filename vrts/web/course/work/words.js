// Times and points in words, and the words of a task as elements: text is always set as text.

import { make } from "../../live/dom.js";

/** @typedef {{text: string, kind?: string, to?: string}} Span */
/** @typedef {{kind: string, level?: number, spans?: Span[], items?: {spans: Span[], depth?: number}[], rows?: Span[][][]}} Block */

/** @param {number} at Unix time [s] @returns {string} with the zone of the reader */
export function when(at) {
  return new Date(at * 1000).toLocaleString([], { weekday: "short", day: "numeric", month: "short", year: "numeric", hour: "2-digit", minute: "2-digit", timeZoneName: "short" });
}

/** @param {number} seconds @returns {string} such as "2 days 3 h" */
export function long(seconds) {
  const minutes = Math.max(0, Math.floor(seconds / 60));
  const [days, hours] = [Math.floor(minutes / 1440), Math.floor(minutes / 60) % 24];
  if (days) return `${days} ${days === 1 ? "day" : "days"}${hours ? ` ${hours} h` : ""}`;
  if (hours) return `${hours} h ${minutes % 60} min`;
  return minutes ? `${minutes} min` : "less than a minute";
}

/** @param {Block[]} blocks @returns {HTMLElement[]} */
export function drawn(blocks) {
  return blocks.map((block) => {
    const spans = pieces(block.spans ?? []);
    if (block.kind === "heading") return make(/** @type {"h3"} */ ((block.level ?? 1) < 3 ? "h3" : "h4"), {}, ...spans);
    if (block.kind === "code") return make("pre", { tabindex: "0" }, make("code", { text: block.spans?.[0]?.text ?? "" }));
    if (block.kind === "list" || block.kind === "numbers") {
      const tag = block.kind === "list" ? "ul" : "ol";
      return make(/** @type {"ul"} */ (tag), {}, ...(block.items ?? []).map((item) => make("li", { class: item.depth ? `d${item.depth}` : "" }, ...pieces(item.spans))));
    }
    if (block.kind === "table") {
      const [head, ...rows] = block.rows ?? [];
      const titles = (head ?? []).map((cell) => (cell.length ? make("th", { scope: "col" }, ...pieces(cell)) : make("td")));
      const titled = (head ?? []).some((cell) => cell.length);
      return make("table", {}, ...(titled ? [make("thead", {}, make("tr", {}, ...titles))] : []), make("tbody", {}, ...rows.map((row) => make("tr", {}, ...row.map((cell, index) =>
        (index || !cell.length ? make("td", {}, ...pieces(cell)) : make("th", { scope: "row" }, ...pieces(cell))))))));
    }
    return make("p", {}, ...spans);
  });
}

/** @param {Span[]} spans @returns {Node[]} */
function pieces(spans) {
  return spans.map(({ text, kind, to }) => {
    if (kind === "code" || kind === "strong" || kind === "em") return make(kind, { text });
    if (kind === "link" && to && /^https?:/.test(to)) return make("a", { href: to, rel: "noopener noreferrer", target: "_blank", text });
    return document.createTextNode(text);
  });
}
