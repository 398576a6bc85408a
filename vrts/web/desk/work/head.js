// Who is looked at: name, mark, what is odd, and what is done next.

import { button, byId, make, write } from "../../live/dom.js";
import { inText } from "../../live/names.js";
import { difference } from "../list.js";
import { mark, when } from "../words.js";

/** @typedef {import("../desk.js").Desk} Desk */

/** The line above replay, program and reasons. */
export class Head {
  /** @param {Desk} desk @param {() => void} finish */
  constructor(desk, finish) {
    this.desk = desk;
    this.name = make("h2", { id: "row-name", dir: "auto", text: "" });
    this.id = make("span", { class: "soft" });
    this.mark = make("b", { class: "final" });
    this.of = make("span", { class: "soft of" });
    this.chips = make("p", { class: "chips" });
    this.finish = button("Finish", finish, { class: "main", title: "I have looked at this: finish it, and go on (F)" });
    this.again = button("Mark again", () => void desk.markAgain([desk.chosen]), { title: "Mark this program again" });
    this.report = make("a", { class: "button", target: "_blank", rel: "noopener", text: "Report" });
    this.sent = make("a", { class: "button", target: "_blank", rel: "noopener", text: "Student's page" });
    byId("head").append(
      make("div", { class: "who-line" }, this.name, this.id, make("span", { class: "fill" }),
        make("p", { class: "mark-now" }, this.mark, this.of)),
      make("div", { class: "what-line" }, this.chips,
        make("div", { class: "acts" }, this.report, this.sent, this.again,
          button("Next", () => desk.next(), { title: "Next in the work list (N)" }), this.finish)),
    );
    desk.on(["chosen", "class", "detail"], () => this.fill());
  }

  fill() {
    const { row, detail, total } = this.desk;
    byId("head").classList.toggle("empty", !row);
    if (!row) return;
    write(this.name, row.name);
    write(this.id, row.id === row.name ? "" : row.id);
    write(this.mark, row.excused ? "excused" : mark(row.final));
    this.mark.classList.toggle("pending", Boolean(row.pending));
    write(this.of, [row.excused ? "" : `of ${row.total ?? total}`, difference(row)].filter(Boolean).join(", "));
    const mine = row.finished.find((one) => one.who === this.desk.me);
    write(this.finish, mine && !mine.stale ? "Finished ✓" : "Finish");
    link(this.report, detail?.report);
    link(this.sent, detail?.sent);
    this.chips.replaceChildren(...this.tags(row));
    write(byId("heard"), `${inText(row.name)}, ${row.excused ? "excused" : `${mark(row.final)} of ${row.total ?? total}`}${row.unsafe.length ? ", unsafe" : ""}`);
  }

  /** @param {import("../types.js").Row} row @returns {HTMLElement[]} */
  tags(row) {
    const { desk } = this;
    /** @type {HTMLElement[]} */
    const tags = [];
    if (row.alone) tags.push(tag("on your own", "", "What other graders think of this is hidden until all have finished it"));
    if (row.otherwise) tags.push(tag("agreed otherwise", "bad", row.otherwise));
    if (row.conflict) tags.push(button("Conflict", () => desk.show("conflicts"), { class: "tag bad" }));
    for (const doubt of row.unsafe) if (doubt.reason !== "conflict") tags.push(tag(doubt.reason, "review", doubt.sentence));
    if (row.late && !row.unsafe.some((doubt) => doubt.reason === "late")) tags.push(tag(row.deduction ? `late, −${row.deduction}` : "late", "", row.late));
    if (row.due) tags.push(tag(`due ${when(row.due)}`, "", "A later deadline"));
    if (row.likeness) {
      const others = row.likeness.with.map((id) => inText(desk.rows.get(id)?.name ?? id)).join(", ");
      tags.push(make("a", { class: "tag", target: "_blank", rel: "noopener", href: "/files/staff/similarity.html", title: `Like ${others}`, text: "alike" }));
    }
    for (const who of row.assigned) tags.push(tag(who === desk.me ? "yours" : inText(desk.nameOf(who)), "", "Assigned"));
    for (const one of row.finished) tags.push(tag(`✓ ${inText(desk.nameOf(one.who))} ${mark(one.mark)}${one.stale ? " (earlier)" : ""}`, "", one.stale ? "Finished before the program or the mark changed" : "Finished"));
    return tags;
  }
}

/** @param {HTMLAnchorElement} place @param {string | null | undefined} url */
function link(place, url) {
  place.classList.toggle("away", !url);
  if (url) place.href = url;
  else place.removeAttribute("href");
}

/** @param {string} text @param {string} kind @param {string} title */
function tag(text, kind = "", title = "") {
  return make("span", { class: `tag ${kind}`, title, text });
}
