// Which page a search shows first: the one whose title is what was typed, then one whose title begins
// so, then sections with all its words in their titles. Sphinx does the rest.
"use strict";
const asked = (new URLSearchParams(window.location.search).get("q") || "").trim().toLowerCase();
const askedWords = asked.split(/\s+/).filter((word) => word.length > 2);
var Scorer = {
  score: ([, title, , , score]) => {
    const last = title.split(" > ").pop().toLowerCase();
    if (last === asked) return score + 1000;
    if (last.startsWith(asked + " ")) return score + 500;
    const all = askedWords.length > 0 && askedWords.every((word) => last.includes(word));
    return score + (all ? 100 : 0);
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
