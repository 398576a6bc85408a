// Breakpoints beside the lines, and the line where a rehearsal stands.

import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, WidgetType, gutter, keymap } from "@codemirror/view";
import { make } from "../dom.js";
import { moved } from "./lines.js";

export const MOST_BREAKPOINTS = 200;

/** @typedef {{at: number, verified: boolean}} Breakpoint `at`: where its line begins */
/** @typedef {{breakpoints: Breakpoint[], here: number}} Signs `here`: where the present line begins; −1: none */

const toggled = StateEffect.define();
const forgotten = StateEffect.define();
const checked = StateEffect.define(); // lines where no rehearsal stops
const stands = StateEffect.define();

/** @type {StateField<Signs>} */
const signs = StateField.define({
  /** @returns {Signs} */
  create: () => ({ breakpoints: [], here: -1 }),
  update(before, change) {
    let { here } = before;
    /** @type {Breakpoint[]} */
    let breakpoints = before.breakpoints;
    if (change.docChanged) {
      const places = new Map(breakpoints.map(({ at, verified }) => [moved(at, change), verified]));
      breakpoints = [...places].filter(([at]) => at >= 0).map(([at, verified]) => ({ at, verified }));
      here = here < 0 ? here : moved(here, change);
    }
    for (const /** @type {import("@codemirror/state").StateEffect<any>} */ effect of change.effects) {
      if (effect.is(toggled)) breakpoints = other(breakpoints, effect.value);
      if (effect.is(forgotten)) [breakpoints, here] = [[], -1];
      if (effect.is(checked)) breakpoints = breakpoints.map(({ at }) => ({ at, verified: !effect.value.has(change.newDoc.lineAt(at).number) }));
      if (effect.is(stands)) here = effect.value;
    }
    if (alike(breakpoints, before.breakpoints)) breakpoints = before.breakpoints; // who looks for others finds none
    return breakpoints === before.breakpoints && here === before.here ? before : { breakpoints, here };
  },
  provide: (field) => EditorView.decorations.compute([field], (state) => drawn(state.field(field))),
});

/** @param {Breakpoint[]} breakpoints @param {number} at @returns {Breakpoint[]} */
function other(breakpoints, at) {
  const rest = breakpoints.filter((one) => one.at !== at);
  return rest.length < breakpoints.length ? rest : [...rest, { at, verified: true }].sort((a, b) => a.at - b.at);
}

/** @param {Breakpoint[]} some @param {Breakpoint[]} others */
function alike(some, others) {
  return some.length === others.length && some.every(({ at, verified }, index) => at === others[index].at && verified === others[index].verified);
}

/** What a screen reader finds in a line with a breakpoint: the gutter is not read. */
class Named extends WidgetType {
  /** @override */
  toDOM() {
    return make("span", { class: "cm-break-name", role: "img", "aria-label": "breakpoint" });
  }

  /** @override */
  eq() {
    return true;
  }
}

const named = Decoration.widget({ widget: new Named(), side: -1 });
const look = Decoration.line({ class: "cm-rehearsed", attributes: { "aria-current": "step" } });

/** @param {Signs} shown */
function drawn({ breakpoints, here }) {
  return Decoration.set([...breakpoints.map(({ at }) => named.range(at)), ...(here < 0 ? [] : [look.range(here)])], true);
}

/** What stands beside a line. */
class Sign extends GutterMarker {
  /** @param {Breakpoint | undefined} breakpoint @param {boolean} here @param {number} line */
  constructor(breakpoint, here, line) {
    super();
    this.kind = `${breakpoint ? (breakpoint.verified ? "cm-break" : "cm-break cm-break-idle") : ""} ${here ? "cm-here" : ""}`.trim();
    this.line = line;
  }

  /** @override @param {Sign} sign */
  eq(sign) {
    return sign.kind === this.kind && sign.line === this.line;
  }

  /** @override */
  toDOM() {
    const idle = this.kind.includes("idle") ? ": nothing stops here" : "";
    const text = this.kind.includes("break") ? `Breakpoint at line ${this.line}${idle}` : `The rehearsal stands at line ${this.line}`;
    return make("span", { class: this.kind, role: "img", "aria-label": text, title: text });
  }
}

/** Set a breakpoint at a line, or take it away. @param {EditorView} view @param {number} at where in the text */
export function toggleBreakpoint(view, at) {
  const { from, number } = view.state.doc.lineAt(at);
  const { breakpoints } = view.state.field(signs);
  const taken = breakpoints.some((one) => one.at === from);
  if (!taken && breakpoints.length >= MOST_BREAKPOINTS) {
    view.dispatch({ effects: EditorView.announce.of(`There are ${MOST_BREAKPOINTS} breakpoints already`) });
    return true;
  }
  view.dispatch({ effects: [toggled.of(from), EditorView.announce.of(taken ? `No breakpoint at line ${number} any more` : `Breakpoint at line ${number}`)] });
  return true;
}

/** Return the lines with breakpoints, from 1. @param {EditorView} view */
export function breakpointLines(view) {
  return view.state.field(signs).breakpoints.map(({ at }) => view.state.doc.lineAt(at).number);
}

/** Whether breakpoints have been set or taken away. @param {{startState: any, state: any}} update */
export function otherBreakpoints({ startState, state }) {
  return startState.field(signs).breakpoints !== state.field(signs).breakpoints;
}

/** Say at which lines no rehearsal stops. @param {EditorView} view @param {Set<number>} idle */
export function tellIdle(view, idle) {
  view.dispatch({ effects: checked.of(idle) });
}

/** Show where the rehearsal stands. @param {EditorView} view @param {number} line from 1; 0: nowhere */
export function showHere(view, line) {
  const { doc } = view.state;
  const at = line > 0 && line <= doc.lines ? doc.line(line).from : -1;
  if (at === view.state.field(signs).here) return;
  view.dispatch({ effects: at < 0 ? stands.of(at) : [stands.of(at), EditorView.scrollIntoView(at, { y: "nearest", yMargin: 40 })] });
}

/** Take all signs away: the text is another one. @param {EditorView} view */
export function forgetSigns(view) {
  view.dispatch({ effects: forgotten.of(null) });
}

const looks = EditorView.theme({
  ".cm-breakpoints": { width: "20px", cursor: "pointer" },
  ".cm-breakpoints .cm-gutterElement": { display: "grid", placeItems: "center" },
  ".cm-breakpoints .cm-gutterElement > span": { display: "block", width: "16px", height: "16px", position: "relative" },
  ".cm-breakpoints .cm-gutterElement:hover:not(:has(.cm-break))::before": { content: '""', gridArea: "1 / 1", width: "11px", height: "11px", borderRadius: "50%", border: "2px solid var(--red)", opacity: ".55" },
  ".cm-break::before": { content: '""', position: "absolute", inset: "2px", borderRadius: "50%", border: "6px solid var(--red)", boxSizing: "border-box" },
  ".cm-break.cm-break-idle::before": { borderWidth: "2px", borderStyle: "dashed" },
  ".cm-break.cm-here::before": { inset: "0", borderWidth: "2px" },
  ".cm-here::after": { content: '""', position: "absolute", left: "4px", top: "2px", borderLeft: "9px solid var(--lit-edge)", borderTop: "6px solid transparent", borderBottom: "6px solid transparent",
    filter: "drop-shadow(0 0 1px var(--ink))" },
  ".cm-rehearsed": { backgroundColor: "var(--lit)", boxShadow: "inset 4px 0 0 var(--lit-edge)" },
  ".cm-break-name": { display: "inline-block", width: "0", height: "1em", verticalAlign: "text-bottom" },
});

export const breakpoints = [
  signs, looks,
  gutter({
    class: "cm-breakpoints",
    renderEmptyElements: true,
    lineMarker: (view, { from }) => {
      const { breakpoints: all, here } = view.state.field(signs);
      const breakpoint = all.find(({ at }) => at === from);
      return breakpoint || here === from ? new Sign(breakpoint, here === from, view.state.doc.lineAt(from).number) : null;
    },
    lineMarkerChange: ({ startState, state }) => startState.field(signs) !== state.field(signs),
    domEventHandlers: {
      mousedown: (view, { from }, event) => {
        if (event.button !== 0) return false;
        event.preventDefault();
        return toggleBreakpoint(view, from);
      },
    },
  }),
  keymap.of([{ key: "F9", run: (/** @type {EditorView} */ view) => toggleBreakpoint(view, view.state.selection.main.head) }]),
];
