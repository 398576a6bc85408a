// Below the pointer's numbers: places to snap to, and a measure between two points.

import { make } from "../dom.js";
import { mountMeasure } from "./measuring.js";
import { mountSnapping } from "./snapping.js";

/**
 * @typedef {object} Around what tools work with
 * @property {import("../store.js").Store} store
 * @property {import("../world.js").World} world
 * @property {() => import("../pointer.js").VirtualPointer | null} pointer of the scene that is shown
 */

/** @param {Around} around @returns {{box: HTMLElement}} */
export function mountTools(around) {
  return { box: make("div", { class: "pointer pointer-more" }, mountSnapping(around), mountMeasure(around)) };
}
