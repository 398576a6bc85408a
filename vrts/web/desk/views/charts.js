// Bars, drawn as SVG.

import { make } from "../../live/dom.js";

/** @typedef {import("../types.js").Bin} Bin */

const [HEIGHT, BELOW] = [150, 18];
const LABELLED = 12; // bins at most of which each has its number below

/** Return how wide a large figure is [px]: drawn as large as it is shown, so that its letters can be read on a phone. */
function wide() {
  return Math.min(640, Math.max(document.documentElement.clientWidth - 72, 240));
}

/** @param {string} tag @param {Record<string, string | number>} attributes @param {string} text @returns {SVGElement} */
function svg(tag, attributes, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  if (text) element.textContent = text;
  return element;
}

/** Return a number without needless digits. @param {number} value */
function plain(value) {
  return String(Math.round(value * 100) / 100).replace("-", "−");
}

/**
 * Return a histogram with its numbers in words.
 * @param {Bin[]} bins @param {string} title @param {{small?: boolean}} options
 */
export function histogram(bins, title, { small = false } = {}) {
  const [width, height] = small ? [200, 56] : [wide(), HEIGHT];
  const most = Math.max(1, ...bins.map((bin) => bin.count));
  const told = bins.filter((bin) => bin.count).map((bin) => `${range(bin)}: ${bin.count}`).join("; ");
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height + BELOW}`, class: small ? "histogram small" : "histogram", role: "img", "aria-label": `${title}. ${told || "nothing"}` });
  const step = width / Math.max(bins.length, 1);
  bins.forEach((bin, k) => {
    const tall = (bin.count / most) * (height - 14);
    const bar = svg("rect", { x: k * step + 1, y: height - tall, width: Math.max(step - 2, 1), height: tall, rx: 2, class: "bar" });
    bar.append(svg("title", {}, `${range(bin)}: ${bin.count}`));
    picture.append(bar);
    if (!small && bin.count) picture.append(svg("text", { x: (k + 0.5) * step, y: height - tall - 3, "text-anchor": "middle" }, String(bin.count)));
  });
  picture.append(svg("line", { x1: 0, x2: width, y1: height + 0.5, y2: height + 0.5, class: "floor" }));
  if (bins.length) {
    picture.append(svg("text", { x: 0, y: height + 14 }, plain(bins[0].from)));
    if (!small && bins.length <= LABELLED) bins.slice(1).forEach((bin, k) => picture.append(svg("text", { x: (k + 1) * step, y: height + 14, "text-anchor": "middle" }, plain(bin.from))));
    picture.append(svg("text", { x: width, y: height + 14, "text-anchor": "end" }, plain(bins[bins.length - 1].to)));
  }
  return picture;
}

/** @param {Bin} bin */
function range(bin) {
  return bin.from === bin.to ? plain(bin.from) : `${plain(bin.from)} to ${plain(bin.to)}`;
}

/**
 * Return means by some number, as a line with dots.
 * @param {{number: number, count: number, mean: number | null}[]} rows @param {number} total @param {string} by
 */
export function progress(rows, total, by) {
  const known = rows.filter((row) => row.mean !== null);
  const width = wide();
  const picture = svg("svg", { viewBox: `0 0 ${width} ${HEIGHT + BELOW}`, class: "histogram", role: "img", "aria-label": `Mean mark by ${by}. ${known.map((row) => `${row.number}: ${plain(row.mean ?? 0)}`).join("; ")}` });
  const x = (/** @type {number} */ k) => (known.length < 2 ? width / 2 : 14 + (k * (width - 28)) / (known.length - 1));
  const y = (/** @type {number} */ mean) => HEIGHT - (mean / Math.max(total, 1)) * (HEIGHT - 18);
  picture.append(svg("line", { x1: 0, x2: width, y1: HEIGHT + 0.5, y2: HEIGHT + 0.5, class: "floor" }));
  picture.append(svg("polyline", { points: known.map((row, k) => `${x(k)},${y(row.mean ?? 0)}`).join(" "), class: "curve" }));
  known.forEach((row, k) => {
    picture.append(svg("circle", { cx: x(k), cy: y(row.mean ?? 0), r: 4, class: "bar" }));
    picture.append(svg("text", { x: x(k), y: y(row.mean ?? 0) - 8, "text-anchor": "middle" }, plain(row.mean ?? 0)));
    picture.append(svg("text", { x: x(k), y: HEIGHT + 14, "text-anchor": "middle" }, String(row.number)));
  });
  return picture;
}

/**
 * Return a table.
 * @param {string} caption @param {string[]} heads those that begin with "#" hold numbers @param {(Node | string)[][]} rows
 */
export function table(caption, heads, rows) {
  const number = heads.map((head) => head.startsWith("#"));
  return make("table", { class: "listing" },
    make("caption", { text: caption }),
    make("thead", {}, make("tr", {}, ...heads.map((head, k) => make("th", { scope: "col", class: number[k] ? "number" : "", text: head.replace("#", "") })))),
    make("tbody", {}, ...rows.map((row) => make("tr", {}, ...row.map((cell, k) => (k ? make("td", { class: number[k] ? "number" : "" }, cell) : make("th", { scope: "row" }, cell)))))));
}
