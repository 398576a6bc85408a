// Rubric items given and taken: the records for that, and what they likely do to marks.

import { after, amount } from "../words.js";

/** @typedef {import("../types.js").Row} Row */
/** @typedef {import("../types.js").Item} Item */
/** @typedef {import("../types.js").Said} Said */

/**
 * Return a record for each student, so that each can be undone alone.
 * @param {Item} item @param {string[]} students @param {{line?: number | null, time_s?: number | null}} where @returns {Said[]}
 */
export function gives(item, students, where = {}) {
  return students.map((student) => {
    /** @type {Said} */
    const said = { does: "give", item: item.id, students: [student] };
    if (where.line) said.line = where.line;
    if (where.time_s !== null && where.time_s !== undefined) said.time_s = where.time_s;
    return said;
  });
}

/** Return a row as it likely is with an item, or without it. @param {Row} row @param {Item} item @param {boolean} has */
export function guess(row, item, has) {
  if (row.items.includes(item.id) === has) return row;
  const change = (amount(item.points) ?? 0) * (has ? 1 : -1);
  return { ...row, items: has ? [...row.items, item.id] : row.items.filter((id) => id !== item.id), final: after(row.final, change, row.total) };
}
