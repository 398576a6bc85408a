// Places as the language server counts them, and as the editor does.

/** @typedef {{line: number, character: number}} Position line from 0, UTF-16 units */
/** @typedef {{start: Position, end: Position}} Range */
/** @typedef {{range: Range, newText: string}} Edit */

/** @param {import("@codemirror/state").Text} doc @param {Position} place @returns {number} offset; the nearest there is */
export function offset(doc, { line, character }) {
  if (line >= doc.lines) return doc.length;
  const row = doc.line(line + 1);
  return Math.min(row.from + character, row.to);
}

/** @param {import("@codemirror/state").Text} doc @param {number} at @returns {Position} */
export function position(doc, at) {
  const row = doc.lineAt(at);
  return { line: row.number - 1, character: at - row.from };
}

/** Return edits as changes of the editor. @param {import("@codemirror/state").Text} doc @param {Edit[]} edits */
export function changes(doc, edits) {
  return edits.map(({ range, newText }) => ({ from: offset(doc, range.start), to: offset(doc, range.end), insert: newText }));
}
