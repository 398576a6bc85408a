// How the editor looks: the page's variables, so light and dark come by themselves.

import { EditorView } from "@codemirror/view";

const BOX = { backgroundColor: "var(--paper)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "8px", boxShadow: "0 6px 24px rgb(0 0 0 / .18)" };
const BUTTON = { font: "inherit", fontSize: "13px", color: "var(--ink)", backgroundColor: "var(--paper)", backgroundImage: "none", border: "1px solid var(--line)", borderRadius: "6px",
  padding: "2px 8px", minHeight: "26px", cursor: "pointer" };

export const theme = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--code)", fontSize: "13px", border: "1px solid var(--line)", borderRadius: "9px", overflow: "hidden" },
  "&.cm-focused": { outline: "2px solid var(--blue)", outlineOffset: "1px" },
  ".cm-scroller": { fontFamily: "ui-monospace, 'Cascadia Mono', 'SF Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace", lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)", padding: "6px 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)", borderLeftWidth: "2px" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "var(--blue-soft)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--line) 40%, transparent)" },
  ".cm-gutters": { backgroundColor: "var(--code)", color: "var(--soft)", border: "0", borderRight: "1px solid var(--line)" },
  ".cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--line) 40%, transparent)", color: "var(--ink)" },
  ".cm-at-work": { backgroundColor: "var(--lit)", boxShadow: "inset 4px 0 0 var(--lit-edge)" },
  ".cm-tooltip": { ...BOX, maxWidth: "min(34rem, 90vw)", zIndex: "20" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "ui-monospace, Menlo, Consolas, 'DejaVu Sans Mono', monospace", fontSize: "13px", maxHeight: "13em" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": { padding: "3px 8px", lineHeight: "1.4", display: "flex", gap: ".8em" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--blue)", color: "var(--paper)" },
  ".cm-completionDetail": { fontStyle: "normal", color: "var(--soft)", marginLeft: "auto", overflow: "hidden", textOverflow: "ellipsis" },
  "li[aria-selected] .cm-completionDetail": { color: "inherit" },
  ".cm-completionMatchedText": { textDecoration: "none", fontWeight: "700" },
  ".cm-completionInfo": { ...BOX, padding: "6px 10px", fontSize: "13px", lineHeight: "1.45", whiteSpace: "pre-wrap" },
  ".cm-said": { padding: "6px 10px", fontSize: "13px", lineHeight: "1.45", maxHeight: "16rem", overflow: "auto" },
  ".cm-said pre": { margin: "0 0 4px", padding: "4px 6px", backgroundColor: "var(--code)", borderRadius: "5px", whiteSpace: "pre-wrap", fontFamily: "inherit" },
  ".cm-said p": { margin: "0 0 4px", whiteSpace: "pre-wrap" },
  ".cm-said mark": { backgroundColor: "transparent", color: "var(--blue)", fontWeight: "700", textDecoration: "underline" },
  ".cm-diagnostic": { padding: "5px 10px", whiteSpace: "pre-wrap", borderLeftWidth: "4px", fontSize: "13px" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--hit)" },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--graze)" },
  ".cm-diagnostic-info": { borderLeftColor: "var(--blue)" },
  ".cm-diagnosticAction": { ...BUTTON, display: "inline-block", margin: "5px 6px 0 0", fontWeight: "600" },
  ".cm-panels": { backgroundColor: "var(--paper)", color: "var(--ink)" },
  ".cm-panels-bottom": { borderTop: "1px solid var(--line)" },
  ".cm-panel.cm-panel-lint ul": { maxHeight: "9rem" },
  ".cm-panel.cm-panel-lint ul [aria-selected], .cm-panel.cm-panel-lint ul:focus [aria-selected]": { backgroundColor: "var(--paper)", color: "var(--ink)", outline: "2px solid var(--blue)", outlineOffset: "-2px" },
  ".cm-panel-lint .cm-diagnosticAction": { display: "none" }, // a button in an option is none for screen readers: Ctrl+. mends
  ".cm-panel button[name=close]": { color: "var(--ink)", minWidth: "26px", minHeight: "26px", fontSize: "16px" },
  ".cm-panel.cm-search": { padding: "5px 26px 5px 8px", fontSize: "13px" },
  ".cm-textfield": { font: "inherit", fontSize: "13px", color: "var(--ink)", backgroundColor: "var(--code)", border: "1px solid var(--soft)", borderRadius: "6px", padding: "2px 6px", minHeight: "26px" },
  ".cm-button": BUTTON,
  ".cm-searchMatch": { backgroundColor: "var(--amber-soft)", outline: "1px solid var(--amber)" },
  ".cm-searchMatch-selected": { backgroundColor: "var(--lit)" },
  "&.cm-focused .cm-matchingBracket": { backgroundColor: "var(--blue-soft)", outline: "1px solid var(--blue)" },
  ".cm-placeholder": { color: "var(--soft)" },
});
