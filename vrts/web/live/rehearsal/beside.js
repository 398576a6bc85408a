// What stands beside the present line: variables, what was typed, what happens, and lost points.

import { figure, make, prose, write } from "../dom.js";
import { altered, seconds } from "./phase.js";

const MOST_ROWS = 200; // of what happens

/** @typedef {import("./phase.js").Place} Place */
/** @typedef {import("./phase.js").Ready} Ready */

/** The tables under the editor. */
export class Beside {
  /** @param {(time_s: number) => void} seek */
  constructor(seek) {
    this.seek = seek;
    this.variables = make("tbody");
    this.none = make("p", { class: "soft", text: "None yet." });
    this.typed = make("pre", { tabindex: "0", role: "region", "aria-label": "What was typed until here" });
    this.events = make("ul", { class: "rehearsal-events" });
    this.marked = make("h2");
    this.lost = make("ul", { class: "rehearsal-events" });
    this.markPart = part(this.marked, scrolled("Points lost in the rehearsal", this.lost));
    this.element = make("div", { class: "rehearsal-beside", id: "rehearsal-beside", hidden: true },
      part(make("h2", { text: "Variables" }), scrolled("Variables here", make("table", { class: "rehearsal-variables" }, this.variables), this.none)),
      part(make("h2", { text: "Typed" }), this.typed),
      part(make("h2", { text: "What happens" }), scrolled("What happens in the rehearsal", this.events)),
      this.markPart);
    /** @type {Place | null} */
    this.place = null;
  }

  /** Show a run. @param {Ready} ready @param {(line: number) => number} lineNow where a line of that text is now */
  begin({ begin_s: begin = 0, marks, mark, note, undetermined, problems }, lineNow) {
    this.place = null;
    const rows = [...marks].sort((a, b) => a.time_s - b.time_s).slice(0, MOST_ROWS).map(({ time_s, kind, text, line }) => {
      const now = lineNow(line);
      const remedy = problems.find((one) => one.line === line && one.message === text)?.help;
      const at = `${seconds(time_s - begin)}${now ? `, line ${now}` : ""}`;
      return make("li", {}, make("button", { type: "button", class: `is-${kind}`, click: () => this.seek(time_s) }, make("small", { text: at }), " ", ...prose(remedy ? `${text}. ${remedy}` : text)));
    });
    rows.unshift(...[note, undetermined ? "Of some pairs of bodies nothing could be proven." : ""].filter(Boolean).map((text) => make("li", { class: "soft", text })));
    const told = new Set(marks.map(({ text }) => text));
    rows.push(...problems.filter(({ message }) => !told.has(message)).map(({ line, severity, message, help }) => make("li", { class: `rehearsal-problem is-${severity}` },
      make("small", { text: lineNow(line) ? `${severity}, line ${lineNow(line)}` : severity }), " ", ...prose(help ? `${message}. ${help}` : message))));
    this.events.replaceChildren(...(rows.length ? rows : [make("li", { class: "soft", text: "Nothing." })]));
    this.markPart.hidden = !mark;
    if (!mark) return;
    write(this.marked, `Mark ${figure(mark.mark, 1)} of ${figure(mark.total, 1).replace(/\.0$/, "")}`);
    const lost = mark.lost.map(({ points, text, at_s: at }) => {
      const words = [make("b", { class: "points", text: points }), " ", ...prose(text)];
      return make("li", {}, at === null ? make("span", {}, ...words) : make("button", { type: "button", click: () => this.seek(at) }, ...words));
    });
    this.lost.replaceChildren(...(lost.length ? lost : [make("li", { class: "soft", text: "No points are lost." })]));
  }

  /** Show what is so at a place. @param {Place} place */
  show(place) {
    const fresh = altered(this.place, place);
    this.place = place;
    this.none.hidden = place.variables.length > 0;
    this.variables.replaceChildren(...place.variables.map(({ name, value }) => make("tr", { class: fresh.has(name) ? "altered" : "" },
      make("th", { scope: "row", text: name }), make("td", { text: value }))), ...(place.more ? [make("tr", {}, make("th", { scope: "row", text: `and ${place.more} more` }))] : []));
    write(this.typed, place.typed.join("\n"));
    this.typed.scrollTop = this.typed.scrollHeight;
  }
}

/** @param {HTMLElement} head @param {HTMLElement} content */
function part(head, content) {
  return make("section", {}, head, content);
}

/** Return a box that scrolls, by keys too. @param {string} label @param {HTMLElement[]} content */
function scrolled(label, ...content) {
  return make("div", { class: "rehearsal-box", tabindex: "0", role: "region", "aria-label": label }, ...content);
}
