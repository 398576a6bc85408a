// What other parts of the page may know of the editor, whether it has been opened or not.

/** @typedef {{program: string, step: number, line: number}} Place a line of the editor, as a step of a program */

class EditorHandle {
  constructor() {
    /** @type {Set<number>} lines of the editor with a breakpoint, from 1 */
    this.breakpoints = new Set();
    /** @type {Place[]} the same as steps of programs */
    this.places = [];
    this.shown = 0; // line that is shown as the one at work; 0: none
    /** @type {((line: number) => void) | null} */
    this.show = null; // set by the open editor
    /** @type {(() => void)[]} */
    this.listeners = [];
  }

  /** Show a line as the one at work, whatever the session does; 0: none. @param {number} line from 1 */
  showLine(line) {
    this.shown = line;
    this.show?.(line);
  }

  /** Be told when breakpoints have changed. @param {() => void} tell */
  onBreakpoints(tell) {
    this.listeners.push(tell);
  }

  /** Take breakpoints over from the open editor. @param {Place[]} places */
  broken(places) {
    this.places = places;
    this.breakpoints = new Set(places.map(({ line }) => line));
    for (const tell of this.listeners) tell();
  }
}

/** The editor of the page. */
export const editor = new EditorHandle();
