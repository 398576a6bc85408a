// Who is here: somebody with several pages open is one person.

/** @typedef {import("./protocol.js").Person} Person */

/**
 * Return one entry for everybody: the page that has control or waits for it, else one that is there.
 * @param {Person[]} people @param {import("./protocol.js").Control} control @param {string} you
 * @returns {Person[]}
 */
export function persons(people, control, you) {
  const rank = (/** @type {Person} */ one) => [one.id === control.holder, control.queue.includes(one.id), one.hand, one.id === you, !one.away]
    .reduce((sum, yes, index) => sum + (yes ? 2 ** (5 - index) : 0), 0);
  /** @type {Map<string, Person>} */
  const best = new Map();
  for (const one of people) {
    const before = best.get(one.name);
    if (!before || rank(one) > rank(before)) best.set(one.name, one);
  }
  return [...best.values()];
}

/** Return "1st", "2nd", ... @param {number} n */
export function ordinal(n) {
  return `${n}${n % 100 > 10 && n % 100 < 14 ? "th" : ["th", "st", "nd", "rd"][n % 10] ?? "th"}`;
}
