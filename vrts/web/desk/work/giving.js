// Rubric items given and taken: the records for that, and what they likely do to marks.

import { inText } from "../../live/names.js";
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

/**
 * Return whose marks something given to all would not simply change, and why: it is left out for them.
 * Who is excused has no mark; a mark that another grader has set would be in conflict with it.
 * @param {Row[]} rows @param {string} me
 */
export function apart(rows, me) {
  const excused = rows.filter((row) => row.excused);
  const set = rows.filter((row) => !row.excused && (row.set_by ?? []).some((who) => who !== me));
  const out = new Set([...excused, ...set].map((row) => row.id));
  const names = (/** @type {Row[]} */ some) => some.slice(0, 5).map((row) => inText(row.name)).join(", ") + (some.length > 5 ? ` and ${some.length - 5} more` : "");
  /** @type {string[]} */
  const why = [];
  if (set.length) why.push(`Left out, as another grader has set their mark: ${names(set)}.`);
  if (excused.length) why.push(`Left out, as they are excused: ${names(excused)}.`);
  return { getting: rows.filter((row) => !out.has(row.id)), why };
}

/** Return whose marks an item changes, and who has one by hand in its place. @param {Row[]} rows */
export function changing(rows) {
  const fixed = rows.filter((row) => row.excused || (row.set_by ?? []).length);
  return { open: rows.filter((row) => !fixed.includes(row)), fixed };
}
