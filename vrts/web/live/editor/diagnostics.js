// What is wrong with the text, marked where it is, with what would mend it.

import { setDiagnostics } from "@codemirror/lint";
import { make } from "../dom.js";
import { changes, offset, position } from "./places.js";

const SEVERITIES = ["", "error", "warning", "info", "hint"];
const MOST = 200; // that are marked

/** @typedef {{title: string, preferred: boolean, edits: import("./places.js").Edit[], range: import("./places.js").Range | null}} Fix */

/** What to do when what would mend a text has come. @type {WeakMap<import("@codemirror/view").EditorView, (() => void)[]>} */
const waiting = new WeakMap();

/**
 * Do something when what would mend the text has come; return false if nothing is awaited.
 * @param {import("@codemirror/view").EditorView} view @param {() => void} act
 */
export function whenFixesCome(view, act) {
  const acts = waiting.get(view);
  acts?.push(act);
  return acts !== undefined;
}

/**
 * Mark what is wrong; then ask what would mend it.
 * @param {import("@codemirror/view").EditorView} view @param {import("./help.js").Help} help @param {any[]} found
 */
export async function mark(view, help, found) {
  const { doc } = view.state;
  const marked = found.slice(0, MOST).map((one) => marking(doc, one, []));
  view.dispatch(setDiagnostics(view.state, marked));
  if (!found.some(({ severity }) => severity <= 2)) return void waiting.delete(view);
  const whole = { start: position(doc, 0), end: position(doc, doc.length) };
  const acts = waiting.get(view) ?? [];
  waiting.set(view, acts);
  /** @type {Fix[] | null} */
  const fixes = await help.ask("codeAction", { range: whole });
  if (view.state.doc !== doc) return; // the present text is asked about by now
  waiting.delete(view);
  if (fixes?.length) show(view, found, fixes);
  for (const act of acts) act();
}

/**
 * Mark what is wrong once more, with what would mend it.
 * @param {import("@codemirror/view").EditorView} view @param {any[]} found @param {Fix[]} fixes
 */
function show(view, found, fixes) {
  const { doc } = view.state;
  const withFixes = found.slice(0, MOST).map((one) => marking(doc, one, fixes.filter(({ range }) => range && same(range, one.range))));
  view.dispatch(setDiagnostics(view.state, withFixes));
}

/**
 * @param {import("@codemirror/state").Text} doc @param {any} one
 * @param {{title: string, preferred: boolean, edits: import("./places.js").Edit[]}[]} fixes
 */
function marking(doc, { range, message, severity, code }, fixes) {
  return {
    from: offset(doc, range.start), to: offset(doc, range.end), severity: SEVERITIES[severity] ?? "info", source: code, message,
    renderMessage: () => make("div", { text: message }),
    actions: [...fixes].sort((a, b) => Number(b.preferred) - Number(a.preferred)).map(({ title, edits }) => ({
      name: title,
      /** @param {import("@codemirror/view").EditorView} view */
      apply: (view) => {
        if (view.state.doc === doc) view.dispatch({ changes: changes(doc, edits), userEvent: "input.fix" });
        view.focus();
      },
    })),
  };
}

/** @param {import("./places.js").Range} a @param {import("./places.js").Range} b */
function same(a, b) {
  return a.start.line === b.start.line && a.start.character === b.start.character && a.end.line === b.end.line && a.end.character === b.end.character;
}
