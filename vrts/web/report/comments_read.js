// Comments of graders as data: read from the page, or from a message of the desk, without trust.

const LONGEST = 2000; // characters of a comment: no grader can write more
const MOST = 300; // comments; the page lists all
const SHORT = 60; // characters of what a mark is called

/** @typedef {{text: string, who: string, line: number | null, t: number | null, points: string, hidden: boolean}} Comment t [s]; hidden: from the student */
/** @typedef {Comment & {t: number}} Timed */

/** Read the items of a page's list; one with two places is told at both. @param {Iterable<Element>} items @returns {Comment[]} */
export function readComments(items) {
  return [...items].flatMap((item) => {
    const words = /** @type {HTMLElement | null} */ (item.querySelector(".words"));
    if (!words) return [];
    const said = { text: words.innerText || (words.textContent ?? ""), who: item.querySelector("small")?.textContent ?? "", points: item.querySelector(".points")?.textContent ?? "" };
    return [...item.querySelectorAll(".place")].flatMap((place) => {
      const { line, t } = /** @type {HTMLElement} */ (place).dataset;
      return comment({ ...said, line: line && Number(line), time_s: t && Number(t) });
    });
  }).slice(0, MOST);
}

/** Read what the desk tells; what is none is left out. @param {unknown} told @returns {Comment[]} */
export function toldComments(told) {
  return Array.isArray(told) ? told.slice(0, MOST).flatMap(comment) : [];
}

/** @param {any} told @returns {Comment[]} none or one */
function comment(told) {
  if (typeof told?.text !== "string" || !told.text.trim()) return [];
  const words = (/** @type {unknown} */ value) => (typeof value === "string" ? value.slice(0, LONGEST) : "");
  const line = Number.isInteger(told.line) && told.line > 0 ? told.line : null;
  const t = Number.isFinite(told.time_s) && told.time_s >= 0 ? told.time_s : null;
  if (line === null && t === null) return [];
  return [{ text: words(told.text), who: words(told.who), line, t, points: words(told.points), hidden: told.hidden === true }];
}

/** Return the first words of a text. @param {string} text */
export function shortly(text) {
  const line = text.replace(/\s+/g, " ").trim();
  if (line.length <= SHORT) return line;
  const cut = line.lastIndexOf(" ", SHORT);
  return `${line.slice(0, cut > SHORT / 2 ? cut : SHORT)} …`;
}

/** Return comments in groups, none of which begins sooner than `apart` [s] after the one before. @param {Timed[]} timed @param {number} apart */
export function inGroups(timed, apart) {
  /** @type {Timed[][]} */
  const groups = [];
  for (const one of timed) {
    const last = groups[groups.length - 1];
    if (last && one.t - last[0].t < apart) last.push(one);
    else groups.push([one]);
  }
  return groups;
}
