// What the page knows, and what is done with it: told at once, written by the server, undone again.

import { cancel, get, listen, NotDone, post } from "./api.js";
import { everything, nextOpen, shown } from "./filters.js";
import { after, counted } from "./words.js";

/** @typedef {import("./types.js").Row} Row */
/** @typedef {import("./types.js").Said} Said */
/** @typedef {import("./types.js").Item} Item */
/** @typedef {import("./types.js").Conflict} Conflict */
/** @typedef {"class" | "chosen" | "detail" | "moment" | "view" | "link" | "marking" | "list"} News */
/** @typedef {"work" | "causes" | "conflicts" | "statistics"} View */
/** @typedef {{revision: string, added: string[], rows: Row[], items?: Item[], conflicts?: Conflict[]}} Written */

const LATER = 150; // after which news of others are fetched [ms]
const UNDOS = 100; // that are remembered

/** The desk's state. */
export class Desk {
  /** @param {import("./notes.js").Notes} notes */
  constructor(notes) {
    this.notes = notes;
    /** @type {import("./types.js").ClassData | null} */
    this.data = null;
    /** @type {Map<string, Row>} */
    this.rows = new Map();
    /** @type {string} */
    this.chosen = "";
    /** @type {import("./types.js").Detail | null} */
    this.detail = null;
    /** What is shown of the replay. @type {{time_s: number | null, line: number | null, end_s: number}} */
    this.moment = { time_s: null, line: null, end_s: 0 };
    /** A line that somebody chose in the source. @type {number | null} */
    this.line = null;
    /** @type {View} */
    this.view = "work";
    this.online = true;
    this.filter = everything();
    /** @type {{records: string[], words: string, given: Set<string>}[]} */
    this.done = [];
    /** Asks whether records are to be undone, where that changes more than what was done. @type {(records: string[], given: Set<string>) => Promise<boolean>} */
    this.sure = async () => true;
    /** @type {Promise<unknown>} */
    this.queue = Promise.resolve();
    /** @type {Promise<unknown>} */
    this.undoing = Promise.resolve();
    /** @type {Map<News, ((desk: Desk) => void)[]>} */
    this.hearers = new Map();
    this.waiting = 0;
    this.asked = 0;
    /** @type {Map<string, Promise<import("./types.js").Detail>>} */
    this.ahead = new Map();
  }

  /** Call back at news. @param {News[]} news @param {() => void} hear */
  on(news, hear) {
    for (const one of news) this.hearers.set(one, [...(this.hearers.get(one) ?? []), hear]);
  }

  /** @param {News} news */
  tell(news) {
    for (const hear of this.hearers.get(news) ?? []) hear(this);
  }

  get me() {
    return this.data?.me.id ?? "";
  }

  get total() {
    return this.data?.total ?? 0;
  }

  /** The row that is looked at. */
  get row() {
    return this.rows.get(this.chosen);
  }

  /** The rubric items that are in use, in their order. */
  get items() {
    return (this.data?.items ?? []).filter((item) => !item.withdrawn);
  }

  /** The rows that the list shows. */
  get listed() {
    return shown(this.rows.values(), this.filter, this.me);
  }

  /** @param {string} who */
  nameOf(who) {
    return this.data?.graders.find((one) => one.id === who)?.name ?? who;
  }

  /** Fetch the class, and from then on what changes. */
  async begin() {
    await this.fetchClass();
    listen(
      (revision) => revision !== null && revision === this.data?.revision ? undefined : this.later(),
      (marking) => {
        if (this.data && marking) this.data.marking = marking;
        this.tell("marking");
      },
      (open) => this.linked(open),
    );
  }

  /** @param {boolean} open */
  linked(open) {
    const back = open && !this.online;
    if (this.online !== open) {
      this.online = open;
      this.tell("link");
    }
    if (back) this.later();
  }

  /** Fetch anew what others changed, once for many news. */
  later() {
    window.clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => void this.refresh(), LATER);
  }

  async refresh() {
    try {
      await this.fetchClass();
      await this.fetchDetail();
    } catch (problem) {
      this.failed(problem, null);
    }
  }

  async fetchClass() {
    const data = /** @type {import("./types.js").ClassData} */ (await get("/api/class"));
    this.linked(true);
    this.data = data;
    this.rows = new Map(data.rows.map((row) => [row.id, named(row)]));
    this.ahead.clear();
    this.tell("class");
    this.tell("marking");
  }

  /** Look at a row. @param {string} id */
  async choose(id) {
    if (!this.rows.has(id)) return;
    if (id === this.chosen) {
      if (this.detail?.row.id !== id) await this.fetchDetail();
      return;
    }
    this.chosen = id;
    this.line = null;
    this.moment = { time_s: null, line: null, end_s: 0 };
    this.detail = null;
    this.tell("chosen");
    await this.fetchDetail();
  }

  async fetchDetail() {
    const id = this.chosen;
    if (!id) return;
    this.asked += 1;
    const asked = this.asked;
    try {
      const detail = await (this.ahead.get(id) ?? this.askFor(id));
      this.ahead.delete(id);
      if (asked !== this.asked || id !== this.chosen) return;
      this.detail = detail;
      this.tell("detail");
    } catch (problem) {
      this.ahead.delete(id);
      this.failed(problem, () => void this.fetchDetail());
    }
  }

  /** @param {string} id @returns {Promise<import("./types.js").Detail>} */
  askFor(id) {
    return get(`/api/row/${encodeURIComponent(id)}`);
  }

  /** Ask for a row that is likely looked at next. @param {string | undefined} id */
  askAhead(id) {
    if (!id || id === this.chosen || this.ahead.has(id) || !this.online) return;
    const asked = this.askFor(id);
    asked.catch(() => this.ahead.delete(id)); // who really wants it asks again, and is told
    this.ahead.set(id, asked);
  }

  /** Go to the row after or before in the list. @param {number} by */
  step(by) {
    const listed = this.listed;
    const now = listed.findIndex((row) => row.id === this.chosen);
    const next = listed[now < 0 ? 0 : Math.min(Math.max(now + by, 0), listed.length - 1)];
    if (next) void this.choose(next.id);
  }

  /** Go to what is to be looked at next. */
  next() {
    const next = nextOpen([...this.rows.values()], this.row, this.me);
    if (next) void this.choose(next.id);
    else this.notes.done("Nothing is left to look at.");
  }

  /** Choose a line of the source. @param {number | null} line */
  pick(line) {
    this.line = line;
    this.tell("moment");
  }

  /** @param {View} view */
  show(view) {
    this.view = view;
    this.tell("view");
  }

  /**
   * Have records written: what they likely change is shown at once, and undone if the server refuses.
   * @param {Said[]} records @param {string} words what is then said to have been done @param {Row[]} guesses
   * @param {boolean} kept whether the key for undoing comes back to it
   * @param {string | null} shown the revision that it is about: who tries again may have been heard the first time
   * @returns {Promise<boolean>} whether it was done
   */
  act(records, words, guesses = [], kept = true, shown = null) {
    const before = guesses.flatMap((row) => this.rows.get(row.id) ?? []);
    for (const row of guesses) this.rows.set(row.id, { ...row, own: likely(this.rows.get(row.id), row), pending: true });
    if (guesses.length) this.tell("class");
    const written = this.queue.then(() => this.write(records, words, before, kept, { expect: shown ?? this.data?.revision ?? "", again: shown !== null }));
    this.queue = written;
    return written;
  }

  /** @param {Said[]} records @param {string} words @param {Row[]} before @param {boolean} kept @param {{expect: string, again: boolean}} about */
  async write(records, words, before, kept, about) {
    try {
      const written = /** @type {Written} */ (await post("/api/records", { records, ...about }));
      this.take(written);
      this.linked(true);
      const given = new Set(records.flatMap((one) => (one.does === "give" ? one.students : [])));
      if (kept && written.added.length) this.done = [...this.done, { records: written.added, words, given }].slice(-UNDOS);
      this.notes.done(words, () => void this.undo(written.added, words, given));
      await this.fetchDetail();
      return true;
    } catch (problem) {
      for (const row of before) this.rows.set(row.id, row);
      this.tell("class");
      this.failed(problem, () => void this.act(records, words, [], kept, about.expect), true);
      if (problem instanceof NotDone && problem.kind === "changed") this.later();
      return false;
    }
  }

  /** @param {Written} written */
  take(written) {
    if (!this.data) return;
    this.data.revision = written.revision;
    for (const row of written.rows) this.rows.set(row.id, named(row));
    if (written.items) this.data.items = written.items;
    if (written.conflicts) this.data.conflicts = written.conflicts;
    this.ahead.clear();
    this.tell("class");
  }

  /** Undo records, or the last thing that was done here. @param {string[] | null} records @param {string} words @param {Set<string>} given students who got an item by them */
  undo(records = null, words = "", given = new Set()) {
    this.undoing = this.undoing.then(() => this.undoNow(records, words, given)); // two keys undo two things
    return this.undoing;
  }

  /** @param {string[] | null} records @param {string} words @param {Set<string>} given */
  async undoNow(records, words, given) {
    await this.queue; // what was pressed before is done first
    const last = records ? { records, words, given } : this.done.at(-1);
    if (!last) {
      this.notes.done("Nothing was done here that could be undone. The history has what was done before.");
      return;
    }
    if (!(await this.sure(last.records, last.given))) return;
    this.done = this.done.filter((one) => one.records[0] !== last.records[0]);
    if (!(await this.act([{ does: "undo", records: last.records }], `Undone: ${last.words}`, [], false))) this.done.push(last);
  }

  /** Mark again. @param {string[] | "all"} students */
  async markAgain(students) {
    try {
      await post("/api/mark", { students });
      this.notes.done(`Marking ${students === "all" ? "all programs" : counted(students.length, "program")} again …`);
    } catch (problem) {
      this.failed(problem, () => void this.markAgain(students));
    }
  }

  /** Stop marking again: what has been marked stays. */
  async stopMarking() {
    try {
      await cancel("/api/mark");
    } catch (problem) {
      this.failed(problem, null);
    }
  }

  /** Say what went wrong. @param {unknown} problem @param {(() => void) | null} again @param {boolean} writing whether something was to be written */
  failed(problem, again, writing = false) {
    if (!(problem instanceof NotDone)) throw problem;
    if (problem.kind === "offline") {
      this.linked(false);
      this.notes.problem(problem.message, writing ? ["Whether it was written before that shows when the desk is there again. Here what you typed is kept."] : [], again);
    } else if (problem.kind === "changed") {
      this.notes.problem(`Not done, because something has changed meanwhile: ${lower(problem.message)}`, ["This page shows it as it is now."]);
    } else {
      this.notes.problem(problem.message, problem.details, problem.kind === "ended" ? null : again);
    }
  }
}

/** Return a row that has a name: with pseudonyms its id. @param {Row} row */
function named(row) {
  return row.name ? row : { ...row, name: row.id };
}

/** Return what whoever is here would likely give alone, when the mark is likely another one. @param {Row | undefined} was @param {Row} row */
function likely(was, row) {
  if (!was || was.own === undefined || was.own === was.final) return row.final;
  return was.own === null || was.final === null || row.final === null ? was.own : after(was.own, row.final - was.final, row.total);
}

/** @param {string} text */
function lower(text) {
  return text.slice(0, 1).toLowerCase() + text.slice(1);
}
