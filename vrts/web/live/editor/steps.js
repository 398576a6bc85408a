// Programs of a text, and steps as lines of it.

const HEADER = /^[ \t]*\.PROGRAM[ \t]+([A-Za-z][\w.]*)/i;
const SECTION = /^[ \t]*\.(?:PROGRAM|END|LOCATIONS|REALS|STRINGS|DOUBLES|TRANS|JOINTS)\b/i;

/**
 * Return where programs begin and end: number of the header's line, and of the first that is no step.
 * @param {string[]} lines @returns {{name: string, first: number, last: number}[]} from 1
 */
export function programsIn(lines) {
  /** @type {{name: string, first: number, last: number}[]} */
  const found = [];
  lines.forEach((line, index) => {
    if (SECTION.test(line) && found.length && found[found.length - 1].last > lines.length) found[found.length - 1].last = index + 1;
    const header = HEADER.exec(line);
    if (header) found.push({ name: header[1], first: index + 1, last: lines.length + 1 });
  });
  return found;
}

/** @param {string} line */
function plain(line) {
  return line.trim().replace(/\s+/g, " ").toUpperCase();
}

/**
 * Return the line of a text that is a step of a program in memory; 0 when the text is another program.
 * @param {string[]} lines of the text @param {{name: string, lines: string[]}} program @param {number} step from 1
 */
export function lineOf(lines, program, step) {
  const place = programsIn(lines).find(({ name }) => name.toUpperCase() === program.name.toUpperCase());
  if (!place || step < 1) return 0;
  let at = 0;
  for (let number = place.first + 1; number < place.last; number += 1) {
    if (plain(lines[number - 1]) !== plain(program.lines[at] ?? "")) continue;
    at += 1;
    if (at === step) return number;
  }
  return 0;
}
