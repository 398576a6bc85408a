// Lines of a text while it is changed: where breakpoints go, and where the lines of an earlier text are now.

/** @typedef {import("@codemirror/state").Text} Text */
/** @typedef {{changes: import("@codemirror/state").ChangeSet, startState: {doc: Text}, newDoc: Text}} Change */

/**
 * Return where the line that began somewhere begins after a change; −1: it is gone.
 * A change of the whole text, as laying out makes, keeps the number of the line.
 * @param {number} at @param {Change} change
 */
export function moved(at, { changes, startState: { doc }, newDoc }) {
  const line = doc.lineAt(at);
  let whole = false;
  let gone = false;
  changes.iterChanges((from, to, _, __, inserted) => {
    if (from === 0 && to === doc.length && to > 0) whole = true;
    else if (!inserted.length && from <= line.from && (to > line.to || (to === line.to && from < line.from))) gone = true;
  });
  if (whole) return line.number > newDoc.lines ? -1 : newDoc.line(line.number).from;
  return gone ? -1 : newDoc.lineAt(changes.mapPos(at, 1)).from;
}

/** Remembers a text, and where its lines have gone since. */
export class Earlier {
  /** @param {Text} doc */
  constructor(doc) {
    this.doc = doc;
    this.begins = starts(doc); // of its lines in the present text; −1: it is gone
  }

  /** @param {Change} change */
  change(change) {
    this.begins = change.newDoc.eq(this.doc) ? starts(this.doc) : this.begins.map((at) => (at < 0 ? at : moved(at, change)));
  }

  /** Return the line of the present text that a line was; 0: none. @param {number} line @param {Text} now */
  toNow(line, now) {
    const at = this.begins[line - 1] ?? -1;
    return at < 0 ? 0 : now.lineAt(at).number;
  }

  /** Return the line of that text that a present one was; 0: none. @param {number} line @param {Text} now */
  toThen(line, now) {
    return this.begins.indexOf(now.line(line).from) + 1;
  }
}

/** @param {Text} doc */
function starts(doc) {
  return Array.from({ length: doc.lines }, (_, index) => doc.line(index + 1).from);
}
