// VAL-II in colours: the shapes that all highlighters of vrts share, read a line at a time.

import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { Tag } from "@lezer/highlight";
import { PATTERNS } from "./val2.js";

const SHAPES = PATTERNS.map(([expression, parts]) => ({ expression: new RegExp(expression, "iy"), parts }));

/** Colours are variables of the page; words that are alike have one. @type {Record<string, object>} */
const LOOKS = {
  comment: { color: "var(--soft)", fontStyle: "italic" },
  section: { color: "var(--blue)", fontWeight: "700" },
  string: { color: "var(--green)" },
  character: { color: "var(--green)" },
  label: { color: "var(--amber)", fontWeight: "600" },
  structure: { color: "var(--red)", fontWeight: "600" },
  instruction: { color: "var(--blue)", fontWeight: "600" },
  qualifier: { color: "var(--blue)" },
  number: { color: "var(--amber)" },
  format: { color: "var(--green)" },
  function: { color: "var(--blue)" },
  constant: { color: "var(--amber)" },
  word_operator: { color: "var(--red)" },
  string_variable: { color: "var(--ink)" },
  precision_point: { color: "var(--ink)" },
  name: { color: "var(--ink)" },
  operator: { color: "var(--ink)" },
  punctuation: { color: "var(--ink)" },
};
const TAGS = Object.fromEntries(Object.keys(LOOKS).map((name) => [name, Tag.define()]));

const val2 = StreamLanguage.define({
  name: "val2",
  languageData: { commentTokens: { line: ";" }, closeBrackets: { brackets: ["(", "[", '"'] } },
  tokenTable: TAGS,
  startState: () => ({ /** @type {[number, string][]} */ parts: [] }),
  copyState: (/** @type {{parts: [number, string][]}} */ state) => ({ parts: [...state.parts] }),
  /** @param {{string: string, pos: number}} stream @param {{parts: [number, string][]}} state */
  token(stream, state) {
    if (!state.parts.length) state.parts = piecesAt(stream.string, stream.pos);
    const [length, name] = /** @type {[number, string]} */ (state.parts.shift());
    stream.pos += length;
    return name;
  },
});

/** Return what begins at a place: lengths and names, none of them empty. @param {string} line @param {number} at @returns {[number, string][]} */
function piecesAt(line, at) {
  for (const { expression, parts } of SHAPES) {
    expression.lastIndex = at;
    const found = expression.exec(line);
    if (!found?.[0]) continue;
    const texts = parts.length === 1 ? [found[0]] : found.slice(1);
    return texts.map((text, index) => /** @type {[number, string]} */ ([text?.length ?? 0, parts[index].replace(" ", "_")]))
      .filter(([length]) => length).map(([length, name]) => [length, name in LOOKS ? name : ""]);
  }
  return [[1, ""]];
}

/** The language with its colours. */
export const language = [val2, syntaxHighlighting(HighlightStyle.define(Object.entries(LOOKS).map(([name, look]) => ({ tag: TAGS[name], ...look }))))];
