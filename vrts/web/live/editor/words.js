// Completion: what may stand here, as the language server says.

import { autocompletion } from "@codemirror/autocomplete";
import { offset, position } from "./places.js";

const KINDS = { 3: "function", 6: "variable", 9: "namespace", 12: "enum", 14: "keyword", 18: "text", 21: "constant", 22: "class" };
const BEGUN = /[$#.]?[\w.]*$/;

/** @param {import("./help.js").Help} help */
export function completion(help) {
  /** @param {any} context */
  async function source(context) {
    const typed = context.matchBefore(BEGUN);
    if (!context.explicit && (!typed || typed.from === typed.to)) return null;
    const { doc } = context.state;
    const answer = await help.ask("completion", { position: position(doc, context.pos) });
    if (!answer?.items.length || context.aborted) return null;
    const first = answer.items[0].textEdit?.range;
    return {
      from: first ? offset(doc, first.start) : typed?.from ?? context.pos,
      validFor: answer.isIncomplete ? undefined : /^[$#.]?[\w.]*$/,
      options: answer.items.map((/** @type {any} */ item, /** @type {number} */ index) => ({
        label: item.label, detail: item.detail ?? undefined, type: KINDS[/** @type {keyof typeof KINDS} */ (item.kind)] ?? "text",
        apply: item.textEdit?.newText ?? item.label, info: item.documentation ?? undefined, boost: -Math.min(index, 99),
      })),
    };
  }
  return autocompletion({ override: [source], icons: false, activateOnTypingDelay: 120, maxRenderedOptions: 60 });
}
