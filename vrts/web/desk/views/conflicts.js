// What graders decided differently: both sides, and which of them counts.

import { button, byId, make, prose, write } from "../../live/dom.js";
import { inText, isolated } from "../../live/names.js";
import { missing, tooLong } from "../missing.js";
import { amount, when } from "../words.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Conflict} Conflict */

const WITH_FILE = "A change in `overrides.toml` and a decision by a grader differ. Delete the one in that file, or undo the other in the history of the program.";

const WITHOUT = "Decide it again, or undo it in the history of the program.";

/** What a conflict is about, in words. @type {Record<string, string>} */
const ABOUT = { file: "a change in overrides.toml", finish: "the mark they finished with", extension: "the deadline" };

/** The view. */
export class Conflicts {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.place = /** @type {HTMLElement} */ (byId("view-conflicts"));
    /** What was typed, by conflict. @type {Map<string, string>} */
    this.drafts = new Map();
    this.seen = "";
    desk.on(["class", "view"], () => this.fill());
  }

  fill() {
    const conflicts = this.desk.data?.conflicts ?? [];
    const badge = byId("conflict-count");
    write(badge, conflicts.length ? String(conflicts.length) : "");
    badge.classList.toggle("bad", conflicts.length > 0);
    const seen = JSON.stringify(conflicts);
    if (seen === this.seen) return; // what is being typed stays
    this.seen = seen;
    const had = this.place.contains(document.activeElement);
    this.place.replaceChildren(make("section", {}, make("h2", { text: "Conflicts" }),
      make("p", { class: "soft", text: conflicts.length ? "Two decisions about the same thing differ. Neither counts, and the mark is unsafe, until somebody says which one holds: for this student, with all that its grader said about the mark." : "No two decisions contradict each other." })),
      ...conflicts.map((conflict) => this.card(conflict)));
    if (had) this.place.focus({ preventScroll: true }); // what had the keyboard may be gone
  }

  /** @param {Conflict} conflict */
  card(conflict) {
    const { desk } = this;
    const row = conflict.student ? desk.rows.get(conflict.student) : undefined;
    const reason = make("input", { "aria-label": "Reason", placeholder: "Why this one holds", dir: "auto", value: this.drafts.get(conflict.id) ?? "" });
    reason.addEventListener("input", () => this.drafts.set(conflict.id, reason.value));
    const apart = row && conflict.about === "finish" ? difference(row) : "";
    const title = make("h3", { text: row ? `${inText(row.name)}: ${ABOUT[conflict.about] ?? conflict.about}${apart}` : "A rubric item" });
    const decide = async (/** @type {string} */ keep, /** @type {string} */ sentence) => {
      if (!reason.value.trim()) {
        missing(reason, "Give a reason: it is kept with the decision.");
        return;
      }
      if (tooLong(reason)) return;
      const over = conflict.sides.map((side) => side.record).filter((record) => record !== keep);
      if (await desk.act([{ does: "decide", keep, over, reason: reason.value.trim(), ...(conflict.student ? { students: [conflict.student] } : {}) }], `Decided: ${sentence}`)) this.drafts.delete(conflict.id);
    };
    const look = row ? [make("p", {}, button(`Look at ${inText(row.name)}`, () => {
      desk.show("work");
      void desk.choose(row.id);
    }, { class: "as-link" }))] : [];
    const told = make("p", { dir: "auto" }, ...prose(conflict.sentence.charAt(0).toUpperCase() + conflict.sentence.slice(1)));
    if (!conflict.sides.length) return make("section", { class: "dispute", "aria-label": conflict.sentence }, title, told, make("p", {}, ...prose(conflict.sentence.includes("`overrides.toml`") ? WITH_FILE : WITHOUT)), ...look);
    return make("section", { class: "dispute", "aria-label": conflict.sentence }, title, told,
      ...look,
      make("label", { class: "reason" }, "Reason ", reason),
      make("div", { class: "sides" }, ...conflict.sides.map((side) => make("article", { class: "side" },
        make("p", { class: "soft" }, isolated(side.who), `, ${when(side.at)}`),
        make("p", { class: "what", dir: "auto" }, ...prose(side.sentence)),
        button("This one holds", () => void decide(side.record, side.sentence), { class: "main", "aria-label": `This one holds: ${inText(side.who)}, ${side.sentence}` })))));
  }
}

/** Return how far the marks are apart that graders have finished with. @param {import("../types.js").Row} row */
function difference(row) {
  const marks = row.finished.flatMap((one) => amount(one.mark) ?? []);
  return marks.length > 1 ? `, ${Math.round((Math.max(...marks) - Math.min(...marks)) * 1000) / 1000} apart` : "";
}
