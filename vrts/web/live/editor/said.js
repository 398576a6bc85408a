// What the language server says in Markdown, as elements: code, paragraphs, nothing else.

import { make } from "../dom.js";

/** @param {string} text @returns {HTMLElement} */
export function said(text) {
  const pieces = text.split(/^```\w*\n([\s\S]*?)\n```$/m);
  const box = make("div", { class: "cm-said" });
  pieces.forEach((piece, index) => {
    const trimmed = piece.trim();
    if (!trimmed) return;
    if (index % 2) box.append(make("pre", { text: trimmed }));
    else for (const paragraph of trimmed.split(/\n{2,}/)) box.append(make("p", {}, ...inline(paragraph)));
  });
  return box;
}

/** @param {string} text @returns {(Node | string)[]} */
function inline(text) {
  return text.split(/(`[^`\n]+`|\*\*[^*\n]+\*\*)/).map((part) => {
    if (part.startsWith("`")) return make("code", { text: part.slice(1, -1) });
    if (part.startsWith("**")) return make("strong", { text: part.slice(2, -2) });
    return part;
  });
}
