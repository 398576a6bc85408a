// Why the mark is what it is: what was lost and when, the checks, the steps, and what graders did.

import { inText, isolated } from "../../live/names.js";
import { button, byId, figure, make, prose } from "../../live/dom.js";
import { counted, lost, mark, moment, points, when } from "../words.js";
import { ask } from "../ask.js";
import { ALIKE, compare } from "../views/compare.js";
import { tabs } from "./tabs.js";

/** @typedef {import("../desk.js").Desk} Desk */

const MOST_ALIKE = 12; // programs that are named

/** The reasons. */
export class Reasons {
  /** @param {Desk} desk @param {import("../frame.js").Replay} replay @param {import("./source.js").Source} source @param {(cause: string) => void} bulk */
  constructor(desk, replay, source, bulk) {
    this.desk = desk;
    this.replay = replay;
    this.source = source;
    this.bulk = bulk;
    this.of = "";
    this.lost = make("div", {});
    this.checks = make("div", {});
    this.history = make("div", {});
    const all = tabs("Reasons", [["lost", "Reasons", this.lost], ["checks", "Checks", this.checks], ["history", "History", this.history]]);
    byId("reasons").append(all.bar, ...all.panels);
    desk.on(["chosen"], () => this.fill());
    desk.on(["detail"], () => this.fill());
  }

  fill() {
    const { detail, chosen } = this.desk;
    const panels = [this.lost, this.checks, this.history];
    const had = panels.find((one) => one.contains(document.activeElement));
    const tops = panels.map((one) => (this.of === chosen ? one.scrollTop : 0));
    for (const one of panels) one.replaceChildren();
    had?.focus({ preventScroll: true }); // the button that was pressed is another one now
    if (!detail) return;
    this.of = chosen;
    this.lost.append(...this.doubts(detail), ...this.losses(detail), ...steps(detail), ...this.alike(detail), ...attempts(detail));
    this.checks.append(...checks(detail), ...findings(detail, (line, time_s) => this.jump(line, time_s)));
    this.history.append(...this.past(detail));
    panels.forEach((one, k) => (one.scrollTop = tops[k]));
  }

  /** @param {import("../types.js").Detail} detail */
  doubts(detail) {
    const agreed = detail.row.otherwise ? [make("div", { class: "doubts" }, make("h3", { text: "Graders agree on another mark" }), make("p", { text: detail.row.otherwise }))] : [];
    if (!detail.row.unsafe.length) return agreed;
    return [...agreed, make("div", { class: "doubts" }, make("h3", { text: "This mark is unsafe" }),
      make("ul", {}, ...detail.row.unsafe.map((doubt) => make("li", {}, make("b", { text: doubt.reason }), " ", ...prose(doubt.sentence)))))];
  }

  /** @param {import("../types.js").Detail} detail */
  losses(detail) {
    if (!detail.losses.length) return [make("h3", { text: "Lost" }), make("p", { class: "soft", text: "Nothing was lost." })];
    return [make("h3", { text: "Lost" }), make("ul", { class: "losses" }, ...detail.losses.map((loss) => this.loss(loss)))];
  }

  /** @param {import("../types.js").Loss} loss */
  loss(loss) {
    const where = make("p", { class: "jumps" });
    const time = loss.time_s;
    const line = loss.line;
    if (time !== null && time !== undefined) where.append(button(`at ${moment(time)}`, () => this.replay.show(time), { class: "jump" }));
    if (line) where.append(button(`line ${line}`, () => this.jump(line, time), { class: "jump" }));
    const cause = this.desk.data?.causes.find((one) => one.key === loss.cause);
    if (cause && cause.count > 1) where.append(button(`all ${cause.count} who lost this`, () => this.bulk(cause.key), { class: "jump" }));
    return make("li", {}, make("b", { class: "points", text: lost(loss.points) }),
      make("div", {}, make("p", {}, ...prose(loss.sentence)), ...(loss.hint ? [make("p", { class: "soft" }, ...prose(loss.hint))] : []), where));
  }

  /** @param {import("../types.js").Detail} detail */
  alike(detail) {
    const like = detail.row.likeness;
    if (!like) return [];
    return [make("h3", { text: `Alike (${like.strength})` }),
      make("p", { class: "soft", text: "Look and decide: likeness never changes a mark." }),
      make("ul", { class: "past" }, ...like.with.slice(0, MOST_ALIKE).map((id) => {
        const row = this.desk.rows.get(id);
        if (!row) { // of another folder: its program stands on the pages of the comparison alone
          return make("li", {}, make("p", { text: id }), make("a", { href: ALIKE, target: "_blank", rel: "noopener", "aria-label": `Compare with ${id}`, text: "Compare" }));
        }
        return make("li", {}, make("p", {}, button(inText(row.name), () => void this.desk.choose(id), { class: "as-link" })),
          button("Compare", () => void compare(this.desk, detail.row.id, id), { class: "jump", "aria-label": `Compare with ${inText(row.name)}` }));
      })), ...(like.with.length > MOST_ALIKE ? [make("p", { class: "soft", text: `and ${like.with.length - MOST_ALIKE} more` })] : [])];
  }

  /** Show a line, and the moment when it mattered. @param {number} line @param {number | null | undefined} time_s */
  jump(line, time_s) {
    this.source.reveal(line);
    this.desk.pick(line);
    if (time_s === null || time_s === undefined) this.replay.showLine(line);
    else this.replay.show(time_s);
  }

  /** @param {import("../types.js").Past} one */
  async undo(one) {
    const all = counted(one.students, "student");
    if (one.students > 1 && !(await ask(`Undo it for ${all}?`, [make("p", {}, "This was decided at once for all of them: ", ...prose(one.sentence))], "Undo"))) return;
    await this.desk.undo([one.record], one.sentence);
  }

  /** Undo an undo: it may have undone more than this. @param {import("../types.js").Past} one @param {string} by */
  async redo(one, by) {
    const others = one.undone - 1;
    if (others && !(await ask(`Bring back ${counted(one.undone, "decision")}?`, [make("p", { dir: "auto" }, `It was undone together with ${counted(others, "other")}, and all of them come back: `, ...prose(one.sentence))], "Bring back"))) return;
    await this.desk.undo([by], `undoing of ${one.sentence}`);
  }

  /** Undo what one deed wrote of many. @param {import("../types.js").Past} one */
  async undoAll(one) {
    const all = counted(one.at_once.length, "student");
    if (await ask(`Undo it for ${all}?`, [make("p", { dir: "auto" }, "This was written at once for all of them: ", ...prose(one.sentence))], "Undo")) await this.desk.undo(one.at_once, `${one.sentence}, for ${all}`);
  }

  /** @param {import("../types.js").Detail} detail */
  past(detail) {
    if (!detail.history.length) return [make("p", { class: "soft", text: "Nobody has decided anything here yet." })];
    return [make("ul", { class: "past" }, ...[...detail.history].reverse().map((one) => {
      const entry = make("li", { class: one.undone_by ? "undone" : "" },
        make("p", { dir: "auto" }, ...prose(one.sentence)),
        make("p", { class: "soft" }, isolated(one.name || one.who), `, ${when(one.at)}${one.students > 1 ? `, for ${counted(one.students, "student")}` : ""}${one.undone_by ? `, undone by ${inText(this.desk.nameOf(one.undone_by.split(":")[0]))}` : ""}`));
      const by = one.undone_by;
      if (by) entry.append(button("Undo the undo", () => void this.redo(one, by), { class: "jump", "aria-label": `Undo the undo: ${one.sentence}` }));
      else if (one.at_once.length > 1) {
        const all = one.at_once;
        entry.append(make("p", { class: "jumps" }, button("Undo", () => void this.undo(one), { class: "jump", "aria-label": `Undo: ${one.sentence}` }),
          button(`for all ${all.length} who got it at once`, () => void this.undoAll(one), { class: "jump", "aria-label": `Undo for all ${all.length}: ${one.sentence}` })));
      } else entry.append(button("Undo", () => void this.undo(one), { class: "jump", "aria-label": `Undo: ${one.sentence}` }));
      return entry;
    }))];
  }
}

/** @param {import("../types.js").Detail} detail */
function steps(detail) {
  if (!detail.steps.length) return [];
  return [make("h3", { text: "From the computed to the final mark" }), make("table", { class: "steps" },
    make("tbody", {}, ...detail.steps.map((step) => make("tr", {},
      make("th", { scope: "row" }, ...prose(step.title)),
      make("td", {}, ...prose(step.sentence ?? "")),
      make("td", { class: "number", text: step.points === null ? "" : points(step.points) }))),
    make("tr", { class: "total" }, make("th", { scope: "row", text: "Final" }), make("td", {}), make("td", { class: "number", text: mark(detail.row.final) }))))];
}

/** @param {import("../types.js").Detail} detail */
function attempts(detail) {
  if (detail.attempts.length < 2) return [];
  const several = detail.attempts.filter((one) => one.mark !== null).length > 1;
  return [make("h3", { text: "Attempts" }), ...(several ? [make("p", { class: "soft", text: "Computed marks, before lateness and changes by hand." })] : []), make("ul", { class: "past" }, ...detail.attempts.map((one) =>
    make("li", {}, make("p", { text: `${mark(one.mark)} · ${one.file ?? ""}` }), make("p", { class: "soft", text: when(one.at) }))))];
}

/** @param {import("../types.js").Detail} detail */
function checks(detail) {
  if (!detail.checks.length) return [make("p", { class: "soft", text: "No check was made." })];
  return [make("ul", { class: "checks" }, ...detail.checks.map((check) => make("li", {},
    make("p", {}, make("b", {}, ...prose(check.title || check.id)), check.hidden ? " (hidden)" : ""),
    make("p", { class: "soft" },
      make("span", { class: `answer-${check.answer.replace(" ", "-")}`, text: check.answer }),
      ` ${rounded(check.points)}${check.most ? ` of ${rounded(check.most)}` : ""}`),
    ...(check.message ? [make("p", {}, ...prose(check.message))] : []))))];
}

/** @param {number} value */
function rounded(value) {
  return figure(Math.round(value * 1000) / 1000, 3).replace(/\.?0+$/, "");
}

/** What compiler and run said, each with its line. @param {import("../types.js").Detail} detail @param {(line: number, time_s: number | null) => void} jump */
function findings(detail, jump) {
  if (!detail.findings.length) return [];
  return [make("h3", { text: "Findings" }), make("ul", { class: "checks" }, ...detail.findings.map((one) => make("li", {},
    make("p", {}, make("b", { class: `said-${one.severity}`, text: one.severity }), " ", ...prose(one.headline)),
    make("p", { class: "jumps" }, make("span", { class: "soft", text: one.code }),
      ...(one.line ? [button(`line ${one.line}`, () => jump(one.line ?? 1, one.time_s), { class: "jump" })] : [])))))];
}
