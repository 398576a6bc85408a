// The program: its lines, which of them runs, where points were lost, and what was said of it.

import { byId, make } from "../../live/dom.js";
import { lost } from "../words.js";
import { spoken } from "./comments.js";

/** @typedef {import("../desk.js").Desk} Desk */

const MOST = 20_000; // lines that are shown

/** The lines. */
export class Source {
  /** @param {Desk} desk @param {import("../frame.js").Replay} replay */
  constructor(desk, replay) {
    this.desk = desk;
    this.replay = replay;
    this.list = /** @type {HTMLElement} */ (byId("code"));
    /** @type {HTMLElement[]} */
    this.lines = [];
    this.lit = 0;
    this.of = "";
    desk.on(["chosen"], () => this.clear());
    desk.on(["detail"], () => this.fill());
    desk.on(["moment"], () => this.light());
    this.list.addEventListener("click", (event) => this.clicked(/** @type {HTMLElement} */ (event.target)));
    this.list.addEventListener("keydown", (event) => this.key(event));
  }

  clear() {
    this.list.replaceChildren();
    this.lines = [];
    this.lit = 0;
    this.of = "";
  }

  fill() {
    const { detail } = this.desk;
    const top = this.of === this.desk.chosen ? this.list.scrollTop : 0;
    const had = this.of === this.desk.chosen && this.list.contains(document.activeElement);
    this.clear();
    this.of = this.desk.chosen;
    if (!detail?.source) {
      if (detail) this.list.append(make("li", { class: "soft nothing", text: detail.source_problem || "There is no program to show." }));
      return;
    }
    this.lines = detail.source.lines.slice(0, MOST).map((text, k) => row(text, k + 1));
    for (const loss of detail.losses) {
      const line = loss.line ? this.lines[loss.line - 1] : null;
      if (!line) continue;
      line.classList.add("lost");
      line.append(make("button", { type: "button", class: "loss", "data-t": loss.time_s ?? "", tabindex: -1, title: loss.sentence.replaceAll("`", ""), text: lost(loss.points) }));
    }
    for (const comment of detail.comments) {
      const line = comment.line ? this.lines[comment.line - 1] : null;
      line?.append(spoken(this.desk, comment, (time) => this.replay.show(time)));
    }
    this.list.replaceChildren(...this.lines);
    this.list.scrollTop = top;
    const first = detail.losses.find((loss) => loss.line)?.line;
    this.tabStop(this.desk.line ?? first ?? 1);
    if (!top && first) this.reveal(first);
    this.light();
    if (had) /** @type {HTMLElement | null} */ (this.list.querySelector("button.n[tabindex='0']"))?.focus({ preventScroll: true });
  }

  /** Light the line that runs, and the one that was chosen. */
  light() {
    const now = this.desk.moment.line ?? 0;
    this.lines.forEach((line, k) => {
      line.classList.toggle("lit", k + 1 === now);
      line.classList.toggle("picked", k + 1 === this.desk.line);
      const number = line.firstElementChild;
      if (k + 1 === now) number?.setAttribute("aria-current", "step");
      else number?.removeAttribute("aria-current");
      number?.setAttribute("aria-pressed", String(k + 1 === this.desk.line));
    });
    if (now !== this.lit && now) this.reveal(now);
    this.lit = now;
  }

  /** @param {number} line */
  reveal(line) {
    const one = this.lines[line - 1];
    if (!one) return;
    const above = one.offsetTop - this.list.scrollTop;
    if (above < 24 || above > this.list.clientHeight - 48) this.list.scrollTop = one.offsetTop - this.list.clientHeight / 2;
  }

  /** @param {HTMLElement} target */
  clicked(target) {
    const loss = target.closest(".loss");
    if (loss instanceof HTMLElement && loss.dataset.t) {
      this.replay.show(Number(loss.dataset.t));
      return;
    }
    const line = target.closest(".comment") ? null : target.closest("li");
    const place = line ? this.lines.indexOf(/** @type {HTMLElement} */ (line)) + 1 : 0;
    if (place) this.pick(place);
  }

  /** Choose a line, and see it run; choose it again to choose none. @param {number} line */
  pick(line) {
    const again = this.desk.line === line;
    this.desk.pick(again ? null : line);
    this.tabStop(line);
    if (!again) this.replay.showLine(line);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const line = this.lines.findIndex((one) => one.firstElementChild === event.target) + 1;
    if (!by || !line || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const next = Math.min(Math.max(line + by, 1), this.lines.length);
    this.tabStop(next);
    this.numberOf(next)?.focus();
  }

  /** Let one number be reached by Tab: from there arrows go on. @param {number} line */
  tabStop(line) {
    this.list.querySelector("button.n[tabindex='0']")?.setAttribute("tabindex", "-1");
    (this.numberOf(line) ?? this.numberOf(1))?.setAttribute("tabindex", "0");
  }

  /** Go to the lines by keyboard. */
  enter() {
    /** @type {HTMLElement | null} */ (this.list.querySelector("button.n[tabindex='0']"))?.focus();
  }

  /** @param {number} line @returns {HTMLElement | null} */
  numberOf(line) {
    return this.lines[line - 1]?.querySelector("button.n") ?? null;
  }
}

/** @param {string} text @param {number} number */
function row(text, number) {
  return make("li", {},
    make("button", { type: "button", class: "n", tabindex: -1, "aria-label": `Line ${number}`, "aria-pressed": "false", text: String(number) }),
    make("code", {}, ...coloured(text)));
}

/** Return a line with its comment apart. @param {string} text @returns {Node[]} */
function coloured(text) {
  let quoted = false;
  for (let k = 0; k < text.length; k += 1) {
    if (text[k] === '"') quoted = !quoted;
    if (text[k] === ";" && !quoted) return [document.createTextNode(text.slice(0, k)), make("span", { class: "t-comment", text: text.slice(k) })];
  }
  return [document.createTextNode(text)];
}
