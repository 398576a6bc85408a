// The editor itself: CodeMirror with the language, the help and the line at work.
//
// It lies in a shadow root of its own: there its styles are constructed style sheets, for which the
// content security policy of the page needs no exception.

import { acceptCompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentLess, insertTab } from "@codemirror/commands";
import { bracketMatching, indentUnit } from "@codemirror/language";
import { forEachDiagnostic, lintGutter, lintKeymap, openLintPanel } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, Prec } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers } from "@codemirror/view";
import { breakpoints } from "../rehearsal/gutter.js";
import { atWork } from "./at_work.js";
import { whenFixesCome } from "./diagnostics.js";
import { closeExplained, explain, hover } from "./hover.js";
import { language } from "./language.js";
import { closeSignature, signature } from "./signature.js";
import { theme } from "./theme.js";
import { completion } from "./words.js";

/** Mend what is wrong at the cursor, as is preferred. @param {EditorView} view */
export function fixHere(view) {
  const { from, to } = view.state.doc.lineAt(view.state.selection.main.head);
  /** @type {{action: any, from: number, to: number} | null} */
  let found = null;
  forEachDiagnostic(view.state, (one, start, end) => {
    if (!found && start <= to && end >= from && one.actions?.length) found = { action: one.actions[0], from: start, to: end };
  });
  if (!found) return whenFixesCome(view, () => void fixHere(view)) || openLintPanel(view);
  const { action, from: start, to: end } = /** @type {{action: any, from: number, to: number}} */ (found);
  action.apply(view, start, end);
  return true;
}

/**
 * Type over what is selected ourselves: Chromium would give what is typed the looks of what was there,
 * as an inline style, which the content security policy refuses.
 * @param {InputEvent} event @param {EditorView} view
 */
function typedOver(event, view) {
  const { main } = view.state.selection;
  if (event.inputType !== "insertText" || !event.data || main.empty || view.composing) return false;
  const words = event.data;
  const insert = () => view.state.update(view.state.replaceSelection(words), { userEvent: "input.type", scrollIntoView: true });
  if (!view.state.facet(EditorView.inputHandler).some((handle) => handle(view, main.from, main.to, words, insert))) view.dispatch(insert());
  event.preventDefault();
  return true;
}

/**
 * @param {HTMLElement} host element that becomes the editor's
 * @param {import("./help.js").Help} help
 * @param {{changed: (update: any) => void, save: () => void, run: () => void, layOut: () => void}} told
 */
export function makeView(host, help, told) {
  const root = host.attachShadow({ mode: "open" });
  const extensions = [
    breakpoints, lineNumbers(), lintGutter(), history(), drawSelection(), highlightSpecialChars(), highlightActiveLine(),
    highlightActiveLineGutter(), bracketMatching(), closeBrackets(), highlightSelectionMatches(), indentUnit.of("  "),
    language, completion(help), hover(help), signature(help), atWork, theme,
    EditorView.domEventHandlers({ beforeinput: typedOver }),
    EditorState.allowMultipleSelections.of(false),
    EditorView.contentAttributes.of({ "aria-label": "Program. Escape, then Tab leaves the editor.", tabindex: "0", spellcheck: "false", autocapitalize: "off", autocorrect: "off" }),
    Prec.high(keymap.of([
      { key: "Tab", run: acceptCompletion },
      { key: "Escape", run: closeSignature },
      { key: "Escape", run: closeExplained },
      { key: "Mod-s", preventDefault: true, run: () => { told.save(); return true; } },
      { key: "Mod-Enter", run: () => { told.run(); return true; } },
      { key: "Shift-Alt-f", run: () => { told.layOut(); return true; } },
      { key: "F1", run: explain },
      { key: "Mod-.", run: fixHere },
    ])),
    keymap.of([...closeBracketsKeymap, ...completionKeymap, ...lintKeymap, ...searchKeymap, ...historyKeymap,
      ...defaultKeymap.filter((/** @type {any} */ { key }) => key !== "Alt-l"), // it leads back to live
      { key: "Tab", run: insertTab, shift: indentLess }]),
    EditorView.updateListener.of(told.changed),
  ];
  return new EditorView({ state: EditorState.create({ doc: "", extensions }), parent: root, root });
}
