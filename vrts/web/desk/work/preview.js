// What a change for many would do to their marks, before it is made.

import { make } from "../../live/dom.js";
import { after, mark, points } from "../words.js";

const LISTED = 40; // students

/** Return whose marks change, and to what. @param {import("../types.js").Row[]} rows @param {number} by */
export function preview(rows, by) {
  if (!rows.length) return make("p", { text: "Nobody has it: no mark changes." });
  const box = make("div", {});
  box.append(make("p", { class: "soft", text: by ? `Each mark changes by ${points(by)}, within what is possible; the server computes it.` : "No mark changes." }));
  box.append(make("table", { class: "preview" },
    make("thead", {}, make("tr", {}, make("th", { scope: "col", text: "Student" }), make("th", { scope: "col", class: "number", text: "Now" }), make("th", { scope: "col", class: "number", text: "Then" }))),
    make("tbody", {}, ...rows.slice(0, LISTED).map((row) => make("tr", {},
      make("th", { scope: "row", dir: "auto", text: row.name }), make("td", { class: "number", text: mark(row.final) }), make("td", { class: "number", text: mark(after(row.final, by, row.total)) }))))));
  if (rows.length > LISTED) box.append(make("p", { class: "soft", text: `and ${rows.length - LISTED} more` }));
  return box;
}
