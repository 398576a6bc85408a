// Notes at the edge of the page: what was done, with a way back, and what was not.

import { button, make, prose } from "../live/dom.js";

const SHOWN = 9_000; // of a note about something done [ms]
const MOST = 3;

/** A stack of notes; screen readers hear each. */
export class Notes {
  /** @param {HTMLElement} place */
  constructor(place) {
    this.place = place;
  }

  /** Say what was done. @param {string} text @param {(() => void) | null} undo */
  done(text, undo = null) {
    for (const old of this.place.querySelectorAll(".note:not(.warn)")) old.remove(); // the last one alone has a way back
    const note = this.add(text, "note");
    if (undo) {
      const back = button("Undo", () => {
        note.remove();
        undo();
      }, { title: "Undo (U)" });
      note.append(back);
    }
    this.fade(note);
  }

  /** Say what was not done: stays until somebody has read it. @param {string} text @param {string[]} details @param {(() => void) | null} again @returns {HTMLElement} the note */
  problem(text, details = [], again = null) {
    const note = this.add([text, ...details].join("\n"), "note warn");
    if (again) {
      note.append(button("Try again", () => {
        note.remove();
        again();
      }));
    }
    note.append(button("Close", () => note.remove()));
    return note;
  }

  /** @param {string} text @param {string} kind */
  add(text, kind) {
    for (const old of Array.from(this.place.children)) if (old.querySelector("p")?.textContent === text) old.remove();
    const note = make("div", { class: kind }, make("p", { dir: "auto" }, ...prose(text)));
    this.place.append(note);
    while (this.place.children.length > MOST) this.place.firstChild?.remove();
    return note;
  }

  /** Take a note away after a while, but not under the pointer or with the keyboard in it. @param {HTMLElement} note */
  fade(note) {
    const wait = () => window.setTimeout(() => {
      if (note.matches(":hover, :focus-within")) wait();
      else note.remove();
    }, SHOWN);
    wait();
  }
}
