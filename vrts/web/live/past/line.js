// What every time line has: the one of the past, and that of a rehearsal.

import { make } from "../dom.js";

const STEPS = { ArrowLeft: -0.1, ArrowRight: 0.1, ArrowDown: -0.1, ArrowUp: 0.1 }; // [s]
const PAGES = { PageDown: -1, PageUp: 1 };
const SPEEDS = [["0.25", "¼×"], ["0.5", "½×"], ["1", "1×"], ["2", "2×"], ["4", "4×"]];

/** Return a choice of speeds for the picture. @param {Record<string, any>} attributes */
export function speeds(attributes) {
  return make("select", attributes, ...SPEEDS.map(([value, text]) => make("option", { value, text, selected: value === "1" })));
}

/**
 * Do what a key at the slider asks for: steps that people can use, whatever the slider shows.
 * @param {KeyboardEvent} event @param {number} t where the slider stands [s] @param {number} page how far a page goes [s]
 * @param {{seek: (t: number) => void, home: () => void, end: () => void}} wishes
 */
export function slideByKey(event, t, page, wishes) {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const step = STEPS[/** @type {keyof typeof STEPS} */ (event.key)] ?? page * (PAGES[/** @type {keyof typeof PAGES} */ (event.key)] ?? 0);
  if (event.key === "Home") wishes.home();
  else if (event.key === "End") wishes.end();
  else if (step) wishes.seek(t + step * (event.shiftKey ? 10 : 1));
  else return;
  event.preventDefault();
}

/**
 * Do what a key anywhere on the time line asks for: comma and full stop jump, space plays.
 * @param {KeyboardEvent} event @param {{jump: (direction: 1 | -1) => void, play: () => void}} wishes
 */
export function goByKey(event, wishes) {
  const target = /** @type {HTMLElement} */ (event.target);
  if (event.altKey || event.ctrlKey || event.metaKey || target.matches("select")) return;
  if (event.key === ",") wishes.jump(-1);
  else if (event.key === ".") wishes.jump(1);
  else if (event.key === " " && !target.matches("button")) wishes.play();
  else return;
  event.preventDefault();
}
