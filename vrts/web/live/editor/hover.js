// What a word is: shown where the mouse rests on it, and by a key.

import { activateHover, closeHoverTooltips, hoverTooltip } from "@codemirror/view";
import { offset, position } from "./places.js";
import { said } from "./said.js";

/** @param {import("./help.js").Help} help */
export function hover(help) {
  return hoverTooltip(async (view, at) => {
    const { doc } = view.state;
    const answer = await help.ask("hover", { position: position(doc, at) });
    if (!answer || view.state.doc !== doc) return null;
    const from = answer.range ? offset(doc, answer.range.start) : at;
    const end = answer.range ? offset(doc, answer.range.end) : at;
    return { pos: from, end, above: true, create: () => ({ dom: said(answer.contents.value) }) };
  }, { hoverTime: 350, hideOnChange: true });
}

/** Show what the word at the cursor is, until the cursor moves. @param {import("@codemirror/view").EditorView} view */
export function explain(view) {
  const at = view.state.selection.main.head;
  activateHover(view, at, 1, { until: (/** @type {any} */ change) => change.docChanged || change.selectionSet });
  return true;
}

/** Close what is shown. @param {import("@codemirror/view").EditorView} view */
export function closeExplained(view) {
  view.dispatch({ effects: closeHoverTooltips });
  return false; // Escape closes other things, too
}
