// Breakpoints in the gutter: they stay with their lines while the text changes.

import { RangeSet, StateEffect, StateField } from "@codemirror/state";
import { GutterMarker, gutter } from "@codemirror/view";
import { make } from "../dom.js";

const toggled = StateEffect.define({ map: (at, changes) => changes.mapPos(at) });

class Break extends GutterMarker {
  /** @override */
  toDOM() {
    return make("span", { class: "cm-break" });
  }
}
const mark = new Break();

const field = StateField.define({
  create: () => RangeSet.empty,
  update(found, change) {
    let next = found.map(change.changes);
    for (const effect of change.effects) {
      if (!effect.is(toggled)) continue;
      let known = false;
      next.between(effect.value, effect.value, () => { known = true; });
      next = known ? next.update({ filter: (from) => from !== effect.value }) : next.update({ add: [mark.range(effect.value)] });
    }
    return next;
  },
});

/** Set a breakpoint at the line of the cursor, or take it away. @param {import("@codemirror/view").EditorView} view */
export function toggleBreakpoint(view) {
  view.dispatch({ effects: toggled.of(view.state.doc.lineAt(view.state.selection.main.head).from) });
  return true;
}

/** Return the lines with breakpoints, from 1. @param {import("@codemirror/state").EditorState} state @returns {number[]} */
export function brokenLines(state) {
  /** @type {Set<number>} */
  const lines = new Set();
  state.field(field).between(0, state.doc.length, (from) => { lines.add(state.doc.lineAt(from).number); });
  return [...lines];
}

export const breakpoints = [
  field,
  gutter({
    class: "cm-breaks",
    markers: (view) => view.state.field(field),
    initialSpacer: () => mark,
    domEventHandlers: {
      mousedown(view, line) {
        view.dispatch({ effects: toggled.of(line.from) });
        return true;
      },
    },
  }),
];
