// Which rows the list shows, and in which order. Computes; shows nothing.

/** @typedef {import("./types.js").Row} Row */
/** @typedef {"conflict" | "unsafe" | "mine" | "open" | "alike"} Flag */
/** @typedef {"next" | "mark" | "name"} Order */
/** @typedef {{text: string, flags: Set<Flag>, reason: string, cause: string, order: Order}} Filter */

/** @type {[Flag, string, string][]} name, word on the button, what it shows */
export const FLAGS = [
  ["conflict", "Conflict", "Graders decided differently"],
  ["unsafe", "Unsafe", "Marks that nobody should take for final"],
  ["mine", "Mine", "Assigned to me"],
  ["open", "Unfinished", "Still to be finished: mine by me, the others by anybody"],
  ["alike", "Alike", "Programs that are like another one"],
];

/** @returns {Filter} */
export function everything() {
  return { text: "", flags: new Set(), reason: "", cause: "", order: "next" };
}

/** Return whether somebody still has to look at a row. @param {Row} row @param {string} me */
export function isOpen(row, me) {
  if (row.excused) return false;
  const done = row.finished.filter((one) => !one.stale);
  return row.assigned.includes(me) ? !done.some((one) => one.who === me) : !done.length;
}

/** @param {Row} row @param {Flag} flag @param {string} me */
export function has(row, flag, me) {
  if (flag === "conflict") return Boolean(row.conflict);
  if (flag === "unsafe") return row.unsafe.length > 0;
  if (flag === "mine") return row.assigned.includes(me);
  if (flag === "open") return isOpen(row, me);
  return row.likeness !== null;
}

/** Return the rows that a filter leaves, in its order. @param {Iterable<Row>} rows @param {Filter} filter @param {string} me @returns {Row[]} */
export function shown(rows, filter, me) {
  const words = plain(filter.text).split(/\s+/).filter(Boolean);
  const flags = [...filter.flags];
  const kept = [...rows].filter(
    (row) =>
      flags.every((flag) => has(row, flag, me)) &&
      (!filter.reason || row.unsafe.some((doubt) => doubt.reason === filter.reason)) &&
      (!filter.cause || row.causes.includes(filter.cause)) &&
      (!words.length || matches(row, words)),
  );
  return kept.sort(ORDERS[filter.order]);
}

/** Return how many rows have each flag and each reason. @param {Iterable<Row>} rows @param {string} me */
export function counts(rows, me) {
  /** @type {Record<string, number>} */
  const flags = {};
  /** @type {Map<string, number>} */
  const reasons = new Map();
  for (const row of rows) {
    for (const [flag] of FLAGS) if (has(row, flag, me)) flags[flag] = (flags[flag] ?? 0) + 1;
    for (const reason of new Set(row.unsafe.map((doubt) => doubt.reason))) reasons.set(reason, (reasons.get(reason) ?? 0) + 1);
  }
  return { flags, reasons };
}

/** Return the row to look at after one: the next in the work list that is open, from the top again at the end. @param {Row[]} rows in any order @param {Row | undefined} now @param {string} me */
export function nextOpen(rows, now, me) {
  const open = rows.filter((row) => row !== now && isOpen(row, me)).sort(ORDERS.next);
  return open.find((row) => now && row.order > now.order) ?? open[0] ?? null;
}

/** @type {Record<Order, (a: Row, b: Row) => number>} */
const ORDERS = {
  next: (a, b) => a.order - b.order,
  mark: (a, b) => (a.final ?? -1) - (b.final ?? -1) || a.order - b.order,
  name: (a, b) => a.name.localeCompare(b.name) || a.order - b.order,
};

/** @param {Row} row @param {string[]} words */
function matches(row, words) {
  const text = plain(`${row.name} ${row.id} ${row.cause ?? ""}`);
  return words.every((word) => text.includes(word));
}

/** Return a text without accents and capitals. @param {string} text */
function plain(text) {
  return text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}
