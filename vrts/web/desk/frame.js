// The replay: the report's page in a frame of its own, which can call nothing, and says what it shows.

import { byId, make } from "../live/dom.js";
import { points } from "./words.js";

/** @typedef {import("./desk.js").Desk} Desk */

const REST = 180; // who leafs through rows loads no replay of those that are only passed [ms]

/** The frame and the talk with it. */
export class Replay {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.place = /** @type {HTMLElement} */ (byId("frame"));
    this.note = make("p", { class: "soft no-frame", text: "" });
    this.place.append(this.note);
    /** @type {HTMLIFrameElement | null} */
    this.frame = null;
    this.url = "";
    /** What is to be shown as soon as the page in the frame listens. @type {Record<string, unknown> | null} */
    this.wanted = null;
    this.listens = false;
    this.waiting = 0;
    desk.on(["chosen"], () => this.close());
    desk.on(["detail"], () => {
      this.open();
      this.tellComments();
    });
    let running = false;
    desk.on(["marking"], () => {
      const ended = running && !desk.data?.marking.running;
      running = desk.data?.marking.running ?? false;
      if (!ended) return;
      this.url = ""; // the report at this address may be another one now
      this.open();
    });
    window.addEventListener("message", (event) => this.hear(event));
  }

  close() {
    window.clearTimeout(this.waiting);
    this.frame?.remove();
    this.frame = null;
    this.url = "";
    this.listens = false;
    this.wanted = null;
    this.note.textContent = "";
  }

  open() {
    const url = this.desk.detail?.report ?? "";
    if (url && url === this.url) return;
    this.close();
    if (!url) {
      this.note.textContent = this.desk.detail ? "There is no report of this one." : "";
      return;
    }
    this.url = url;
    this.note.textContent = "Loading the replay …";
    this.waiting = window.setTimeout(() => {
      const name = this.desk.row?.name ?? "";
      this.frame = make("iframe", { src: `${url}#framed=1`, title: `Replay of ${name}`, sandbox: "allow-scripts", loading: "eager" });
      this.frame.addEventListener("load", () => (this.note.textContent = ""));
      this.place.append(this.frame);
    }, REST);
  }

  /** @param {MessageEvent} event */
  hear(event) {
    if (!this.frame || event.source !== this.frame.contentWindow) return;
    const said = event.data;
    if (said?.vrts === "shown" && Number.isFinite(said.time_s)) {
      this.desk.moment = { time_s: said.time_s, line: whole(said.line), end_s: Number.isFinite(said.end_s) ? said.end_s : 0 };
      if (!this.listens) {
        this.listens = true;
        this.tellComments();
      }
      const wanted = this.wanted;
      this.wanted = null;
      if (wanted) this.say(wanted);
      this.desk.tell("moment");
    } else if (said?.vrts === "line") {
      this.desk.pick(whole(said.line));
    } else if (said?.vrts === "leave") {
      byId("list").focus();
    }
  }

  /** Show a moment. @param {number} time_s */
  show(time_s) {
    this.say({ vrts: "show", time_s: Math.max(time_s, 0) });
  }

  /** Show when a line runs. @param {number} line */
  showLine(line) {
    this.say({ vrts: "show", line });
  }

  /** Go on or back from what is shown. @param {number} by [s] */
  scrub(by) {
    const { time_s, end_s } = this.desk.moment;
    if (time_s !== null) this.show(Math.min(time_s + by, end_s || Infinity));
  }

  /** Let the replay show what is said of the program, as it is decided now. */
  tellComments() {
    const { detail } = this.desk;
    if (this.listens && detail) this.say({ vrts: "comments", comments: commentsOf(detail, this.desk.data?.items ?? []) });
  }

  /** @param {Record<string, unknown>} words */
  say(words) {
    // the frame has no origin of its own that could be named: what is said is a time or a line
    if (this.listens) this.frame?.contentWindow?.postMessage(words, "*");
    else this.wanted = words;
  }
}

/**
 * Return what is said of a program at lines and moments of the run that is shown; rubric items, too.
 * @param {import("./types.js").Detail} detail @param {import("./types.js").Item[]} items
 */
function commentsOf(detail, items) {
  const said = detail.comments.filter((one) => !one.stale)
    .map((one) => ({ text: one.text, who: one.name || one.who, line: one.line, time_s: one.time_s, hidden: one.private }));
  const given = detail.given.flatMap((one) => {
    const item = items.find(({ id }) => id === one.item);
    return item && !item.withdrawn ? [{ text: item.title, who: one.who, line: one.line, time_s: one.time_s, points: points(item.points) }] : [];
  });
  return [...said, ...given];
}

/** @param {unknown} value */
function whole(value) {
  return Number.isInteger(value) && /** @type {number} */ (value) > 0 ? /** @type {number} */ (value) : null;
}
