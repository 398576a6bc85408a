// The class in numbers: marks, checks, causes, attempts, graders.

import { get } from "../api.js";
import { inText, isolated } from "../../live/names.js";
import { button, byId, make, prose } from "../../live/dom.js";
import { counted, lost, mark } from "../words.js";
import { histogram, progress, table } from "./charts.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Statistics} Data */

/** The view. */
export class StatisticsView {
  /** @param {Desk} desk @param {(cause: string) => void} bulk */
  constructor(desk, bulk) {
    this.desk = desk;
    this.bulk = bulk;
    this.place = /** @type {HTMLElement} */ (byId("view-statistics"));
    this.seen = "";
    desk.on(["view", "class"], () => void this.fill());
  }

  async fill() {
    const { data, view } = this.desk;
    if (view !== "statistics" || !data || this.seen === data.revision) return;
    this.seen = data.revision;
    try {
      this.draw(await get("/api/statistics"));
    } catch (problem) {
      this.seen = "";
      this.desk.failed(problem, () => void this.fill());
    }
  }

  /** @param {Data} data */
  draw(data) {
    const { desk } = this;
    const top = this.place.scrollTop;
    const unsafe = [...desk.rows.values()].filter((row) => row.unsafe.length).length;
    this.place.replaceChildren(
      section("Marks",
        make("p", { class: "lead" }, "Mean ", make("b", { text: mark(data.mean) }), ", median ", make("b", { text: mark(data.median) }), ` of ${desk.total}; ${counted(desk.rows.size, "program")}${unsafe ? `, ${unsafe} of them with a mark that is unsafe` : ""}.`),
        histogram(data.marks, "Final marks")),
      section("Checks", this.checks(data)),
      section("Causes", this.causes(data)),
      ...attempts(data, desk.total),
      section("Graders", data.graders.length ? table("Graders", ["Grader", "#Assigned", "#Finished", "#Mean"],
        data.graders.map((row) => [isolated(desk.nameOf(row.who)), String(row.rows), String(row.finished), mark(row.mean)])) : make("p", { class: "soft", text: "Nobody has decided anything yet." }),
        ...this.double(data)),
    );
    this.place.scrollTop = top;
  }

  /** @param {Data} data */
  checks(data) {
    if (!data.checks.length) return make("p", { class: "soft", text: "No check was made." });
    return make("div", {},
      make("p", { class: "soft", text: "Discrimination, from −1 to 1: near 1, those who pass this check do well elsewhere too; near 0 it tells nothing of that; below 0, look whether it asks for what you meant." }),
      make("div", { class: "check-cards" }, ...data.checks.map((check) => make("article", { class: "check-card" },
        make("h3", {}, ...prose(check.title || check.id)),
        histogram(check.histogram, check.title || check.id, { small: true }),
        make("p", { class: "soft" }, `mean ${check.mean === null ? "–" : String(Math.round(check.mean * 100) / 100).replace("-", "−")}${check.most ? ` of ${check.most}` : ", it can only cost"}; all points ${check.full}, none ${check.none}`),
        make("p", { class: check.discrimination !== null && check.discrimination < 0.1 ? "weak" : "" }, "discrimination ", make("b", { text: check.discrimination === null ? "–" : check.discrimination.toFixed(2).replace("-", "−") }))))));
  }

  /** @param {Data} data */
  causes(data) {
    if (!data.causes.length) return make("p", { class: "soft", text: "Nobody lost anything." });
    return table("What was lost most often", ["Cause", "#Points", "#Students"], data.causes.map((cause) => [
      button(cause.sentence.replaceAll("`", ""), () => this.bulk(cause.key), { class: "as-link" }), lost(cause.points), String(cause.count)]));
  }

  /** @param {Data} data */
  double(data) {
    if (!data.double.length) return [];
    const { desk } = this;
    return [table("Marked by two", ["Student", "Marks", "#Difference"], data.double.map((row) => [
      button(inText(desk.rows.get(row.student)?.name ?? row.student), () => {
        desk.show("work");
        void desk.choose(row.student);
      }, { class: "as-link" }),
      Object.entries(row.marks).map(([who, value]) => `${inText(desk.nameOf(who))} ${mark(value)}`).join(", "), mark(row.difference)]))];
  }
}

/** Return progress over attempts where they were all marked, and else marks by how often students handed in. @param {Data} data @param {number} total */
function attempts(data, total) {
  const marked = data.progress.length > 1;
  const rows = marked ? data.progress : data.attempts;
  if (rows.length < 2) return [];
  const [title, words, head] = marked ? ["Progress over attempts", "number of the attempt", "Attempt"] : ["Marks by number of hand-ins", "number of hand-ins", "Hand-ins"];
  return [section(title, progress(rows, total, words),
    ...(marked ? [make("p", { class: "soft", text: "Computed marks, before lateness and changes by hand. Students who handed in less often are missing in later attempts." })] : []),
    table(`By ${words}`, [head, "#Students", "#Mean", "#Median"], rows.map((row) => [String(row.number), String(row.count), mark(row.mean), mark(row.median)])))];
}

/** @param {string} title @param {(Node | string)[]} body */
function section(title, ...body) {
  return make("section", {}, make("h2", { text: title }), ...body);
}
