// The table of what happened, every row a way to its time; contacts and voices stand between the events.

import { bindFilter, voiceRows } from "./voices.js";

const MANY = 150; // rows: from here on paper shows only what matters
const DIGITS = 3; // of times [s]

/** @typedef {{t: number, kind: string, text: string, line: number, process?: boolean, facts?: string}} Row */
/** @typedef {import("./page.js").Contact} Contact */

/** One row for each event, in time order; one of them can be reached by the tabulator. */
export class EventList {
  /**
   * @param {HTMLElement} body of the table
   * @param {{run: {events: Row[]}, contacts: Contact[], grazes: Contact[], doubtful: Contact[], near: Contact[], voices?: import("./voices.js").Voice[]}} data
   * @param {(t: number) => void} jump
   */
  constructor(body, data, jump) {
    this.box = /** @type {HTMLElement} */ (body.closest(".scroll"));
    this.body = body;
    this.jump = jump;
    this.wanted = (/** @type {Row} */ _) => true;
    /** @type {Row[]} */
    this.own = [
      ...data.run.events,
      ...data.contacts.map((c) => row(c, "contact", c.text)),
      ...data.grazes.map((c) => row(c, "graze", `graze: ${c.text}`)),
      ...data.doubtful.map((c) => row(c, "doubtful", `too close to tell: ${c.text}`)),
      ...data.near.map((c) => row(c, "near", c.text)),
      ...voiceRows(data.voices),
    ];
    this.rows = this.own;
    /** @type {HTMLElement[]} */
    this.entries = [];
    /** @type {HTMLElement[]} */
    this.buttons = [];
    /** @type {boolean[]} */
    this.listed = [];
    this.current = -1;
    this.reached = 0;
    this.fill([]);
    bindFilter(this.box, this.rows, (listed) => this.list(listed));
    body.addEventListener("keydown", (event) => this.walk(event));
  }

  /** List comments of graders between the events, and no others. @param {import("./comments_read.js").Timed[]} comments */
  comment(comments) {
    this.fill(comments.map((one) => ({
      t: one.t, kind: "comment", line: one.line ?? 0, text: one.points ? `${one.points}  ${one.text}` : one.text,
      facts: [one.who, one.hidden ? "not for the student" : ""].filter(Boolean).join(" · "),
    })));
  }

  /** @param {Row[]} others beside the page's own */
  fill(others) {
    this.rows = [...this.own, ...others].sort((a, b) => a.t - b.t);
    this.entries = this.rows.map((one) => drawn(one, () => this.jump(one.t)));
    this.buttons = this.entries.map((entry) => /** @type {HTMLElement} */ (entry.querySelector("button")));
    this.body.replaceChildren(...this.entries);
    this.body.classList.toggle("many", this.rows.length > MANY);
    this.current = -1;
    this.list(this.wanted);
  }

  /** Leave rows out, or list them again. @param {(row: Row) => boolean} wanted */
  list(wanted) {
    this.wanted = wanted;
    this.listed = this.rows.map(wanted);
    this.entries.forEach((entry, index) => { entry.hidden = !this.listed[index]; });
    this.reach(Math.max(this.listed.indexOf(true), 0));
  }

  /** @param {number} t [s]; marks the last event that is not later */
  show(t) {
    let index = -1;
    this.rows.forEach((row, k) => { if (this.listed[k] && row.t <= t + 5e-4) index = k; });
    if (index === this.current) return;
    this.entries[this.current]?.classList.remove("now");
    this.entries[this.current]?.removeAttribute("aria-current");
    this.current = index;
    const entry = this.entries[index];
    if (!entry) return;
    entry.classList.add("now");
    entry.setAttribute("aria-current", "true");
    this.reach(index);
    const above = entry.offsetTop - this.box.scrollTop;
    if (above < 30 || above > this.box.clientHeight - 40) this.box.scrollTop = entry.offsetTop - this.box.clientHeight / 2;
  }

  /** Let the tabulator come to one row. @param {number} index */
  reach(index) {
    this.buttons[this.reached]?.setAttribute("tabindex", "-1");
    this.reached = index;
    this.buttons[index]?.removeAttribute("tabindex");
  }

  /** Up and down go from row to row. @param {KeyboardEvent} event */
  walk(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const at = this.buttons.indexOf(/** @type {HTMLElement} */ (event.target));
    if (!step || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    let next = at + step;
    while (this.listed[next] === false) next += step;
    if (this.listed[next] === undefined) return;
    this.reach(next);
    this.buttons[next].focus();
    this.buttons[next].click();
  }

  /** Return the time of the next event after a time, or the last. */
  after(/** @type {number} */ t) {
    return this.rows.find((one, index) => this.listed[index] && one.t > t + 1e-3)?.t ?? t;
  }

  /** Return the time of the event before a time, or the start. */
  before(/** @type {number} */ t) {
    return this.rows.findLast((one, index) => this.listed[index] && one.t < t - 1e-3)?.t ?? 0;
  }
}

/** Return the row of a contact with all that is known of it. @param {Contact} c @param {string} kind @param {string} text @returns {Row} */
function row(c, kind, text) {
  const facts = [`until ${c.end.toFixed(DIGITS)} s`];
  if (kind !== "near") facts.push(`deepest at ${c.deepest.toFixed(DIGITS)} s`);
  facts.push(`at ${c.point.map((x) => (1000 * x).toFixed(0).replace("-", "−")).join(", ")} mm`);
  if (c.held) facts.push(`holding ${c.held}`);
  return { t: c.start, kind, text, line: c.line, facts: facts.join(" · ") };
}

/** Return the line of a row; PC stands for the process control program. @param {Row} one */
function where(one) {
  return one.line ? `${one.process ? "PC " : ""}${one.line}` : "–";
}

/** @param {Row} one @param {() => void} click */
function drawn(one, click) {
  const entry = document.createElement("tr");
  entry.className = one.kind;
  const time = document.createElement("button");
  time.type = "button";
  time.tabIndex = -1;
  time.textContent = `${one.t.toFixed(DIGITS)} s`;
  const words = document.createElement("span");
  words.textContent = one.text;
  const cells = [[time], [words], [where(one)]].map((parts) => {
    const cell = document.createElement("td");
    cell.append(...parts);
    return cell;
  });
  if (one.facts) {
    const facts = document.createElement("small");
    facts.textContent = one.facts;
    cells[1].append(facts);
  }
  entry.append(...cells);
  entry.addEventListener("click", click);
  return entry;
}
