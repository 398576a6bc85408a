// What the step or function takes in which the cursor stands, and which part it stands in.

import { StateEffect, StateField } from "@codemirror/state";
import { ViewPlugin, showTooltip } from "@codemirror/view";
import { make } from "../dom.js";
import { position } from "./places.js";

const PAUSE = 150; // after the last key [ms]
const shown = StateEffect.define();

/** @typedef {{pos: number}} Shown */

const field = StateField.define({
  create: () => /** @type {Shown | null} */ (null),
  update(value, change) {
    for (const effect of change.effects) if (effect.is(shown)) return effect.value;
    return value && change.docChanged ? { ...value, pos: change.changes.mapPos(value.pos) } : value;
  },
  provide: (one) => showTooltip.from(one),
});

/** @param {import("./help.js").Help} help */
export function signature(help) {
  const watch = ViewPlugin.fromClass(class {
    /** @param {import("@codemirror/view").EditorView} view */
    constructor(view) {
      this.view = view;
    }

    /** @param {any} change */
    update(change) {
      if (change.docChanged) this.later(true);
      else if (change.selectionSet && this.view.state.field(field)) this.later(false);
    }

    /** @param {boolean} typed */
    later(typed) {
      window.clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.look(typed), PAUSE);
    }

    /** @param {boolean} typed */
    async look(typed) {
      const { doc, selection } = this.view.state;
      const at = selection.main.head;
      if (typed && !/[(,\s]\S*$/.test(doc.lineAt(at).text.slice(0, at - doc.lineAt(at).from))) return this.show(null);
      const answer = this.view.hasFocus && selection.main.empty ? await help.ask("signatureHelp", { position: position(doc, at) }) : null;
      if (this.view.state.doc !== doc || this.view.state.selection.main.head !== at) return;
      const one = answer?.signatures[0];
      this.show(one ? { pos: at, above: true, strictSide: false, create: () => ({ dom: drawn(one, answer.activeParameter) }) } : null);
    }

    /** @param {object | null} value */
    show(value) {
      if (value || this.view.state.field(field)) this.view.dispatch({ effects: shown.of(value) });
    }

    destroy() {
      window.clearTimeout(this.timer);
    }
  });
  return [field, watch];
}

/** Take it away. @param {import("@codemirror/view").EditorView} view */
export function closeSignature(view) {
  if (view.state.field(field, false)) view.dispatch({ effects: shown.of(null) });
  return false;
}

/** @param {{label: string, documentation: string | null, parameters: {label: string}[]}} one @param {number} active */
function drawn({ label, documentation, parameters }, active) {
  const part = parameters[active]?.label ?? "";
  const at = part ? label.indexOf(part, label.search(/[\s(]/) + 1) : -1;
  const line = at < 0 ? make("pre", { text: label })
    : make("pre", {}, label.slice(0, at), make("mark", { text: part }), label.slice(at + part.length));
  return make("div", { class: "cm-said", role: "note" }, line, ...(documentation ? [make("p", { text: documentation })] : []));
}
