// Lines of a text while it is changed: where breakpoints go, and where the lines of an earlier text are now.

/** @typedef {import("@codemirror/state").Text} Text */
/** @typedef {import("@codemirror/state").ChangeSet} ChangeSet */

/**
 * Return where the line that began somewhere begins after a change; −1: it is gone.
 * A change of the whole text, as laying out makes, keeps the number of the line.
 * @param {number} at @param {{changes: ChangeSet, startState: {doc: Text}, newDoc: Text}} change
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
    /** @type {ChangeSet | null} */
    this.since = null;
  }

  /** @param {ChangeSet} changes */
  change(changes) {
    this.since = this.since?.compose(changes) ?? changes;
  }

  /** Return the line of the present text that a line was; 0: none. @param {number} line @param {Text} now */
  toNow(line, now) {
    if (line < 1 || line > this.doc.lines) return 0;
    const { from } = this.doc.line(line);
    return now.lineAt(this.since ? this.since.mapPos(from, 1) : from).number;
  }

  /** Return the line of that text that a present one was. @param {number} line @param {Text} now */
  toThen(line, now) {
    const { from } = now.line(line);
    return this.doc.lineAt(this.since ? this.since.invertedDesc.mapPos(from, 1) : from).number;
  }
}
