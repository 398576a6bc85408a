// The line at work, lit and kept in sight.

import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView } from "@codemirror/view";

const lit = StateEffect.define();
const look = Decoration.line({ class: "cm-at-work", attributes: { "aria-current": "step" } });

export const atWork = StateField.define({
  create: () => Decoration.none,
  update(found, change) {
    let next = found.map(change.changes);
    for (const effect of change.effects) if (effect.is(lit)) next = effect.value < 0 ? Decoration.none : Decoration.set([look.range(effect.value)]);
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Light a line; 0: none. @param {import("@codemirror/view").EditorView} view @param {number} line from 1 */
export function light(view, line) {
  const { doc } = view.state;
  const at = line > 0 && line <= doc.lines ? doc.line(line).from : -1;
  view.dispatch({ effects: at < 0 ? lit.of(at) : [lit.of(at), EditorView.scrollIntoView(at, { y: "nearest", yMargin: 40 })] });
}
