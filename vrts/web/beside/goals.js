// Goals as they stand at a time: open, reached, or lost.

import { LineBasicMaterial, MeshBasicMaterial } from "three";

/** @typedef {{title: string, spans: [number, number][]}} Row of one place that is drawn: from when to when it is reached [s] */
/** @typedef {{reached?: Row[], judged?: number}} Times */
/** @typedef {"open" | "reached" | "lost" | "missed"} Standing */

const SAME = 5e-4; // [s]
/** @type {Record<Standing, [number, number, number]>} colour, and how much of it faces and edges have */
const LOOK = { open: [0x2f9e44, 0.16, 0.7], reached: [0x12b886, 0.45, 1], lost: [0xe5322d, 0.3, 0.9], missed: [0xe5322d, 0.3, 0.9] };
const WORDS = { lost: "reached before, and lost", missed: "not reached" };

/** Return how a goal stands at a time. @param {Row} row @param {number} t [s] @param {number} judged [s] @returns {Standing} */
export function standing(row, t, judged) {
  const now = Math.min(t, judged);
  if (row.spans.some(([start, end]) => start - SAME <= now && (now < end - SAME || end >= judged - SAME))) return "reached";
  if (row.spans.some(([, end]) => end <= now + SAME)) return "lost";
  return t >= judged - SAME ? "missed" : "open";
}

/**
 * Paint the places of goals as they stand; return what there is to say, and how many are reached.
 * @param {import("../viewer/viewer.js").Viewer | null} viewer @param {Times} times @param {number} t [s]
 * @returns {{said: string[], reached: number, count: number}}
 */
export function showGoals(viewer, times, t) {
  const rows = times.reached ?? [];
  const found = rows.map((row) => standing(row, t, times.judged ?? Infinity));
  found.forEach((one, k) => viewer && paint(viewer.goals.children[k], one));
  /** @type {Map<string, Standing>} */
  const named = new Map(rows.map((row, k) => [row.title, found[k]]));
  const said = [...named].filter(([, one]) => one === "lost" || one === "missed").map(([title, one]) => `${title}: ${WORDS[/** @type {"lost" | "missed"} */ (one)]}`);
  return { said, reached: [...named.values()].filter((one) => one === "reached").length, count: named.size };
}

/** @param {import("three").Object3D | undefined} ghost @param {Standing} one */
function paint(ghost, one) {
  if (!ghost || ghost.userData.standing === one) return;
  ghost.userData.standing = one;
  const [color, face, edge] = LOOK[one];
  ghost.traverse((part) => {
    const material = /** @type {any} */ (part).material;
    if (!(material instanceof MeshBasicMaterial || material instanceof LineBasicMaterial)) return;
    material.color.setHex(color);
    material.opacity = material instanceof MeshBasicMaterial ? face : edge;
  });
}
