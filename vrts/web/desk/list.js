// The work list: of a thousand rows only those are in the page that can be seen.

import { button, byId, choice, make, write } from "../live/dom.js";
import { counts, FLAGS, isOpen } from "./filters.js";
import { amount, counted, lost, mark } from "./words.js";

/** @typedef {import("./types.js").Row} Row */
/** @typedef {import("./desk.js").Desk} Desk */

const HEIGHT = 52; // of a row [px], as in desk.css
const BEYOND = 6; // rows above and below what can be seen
const SENTENCE = 60; // characters of a cause in a select

/** The list and what narrows it. */
export class WorkList {
  /** @param {Desk} desk */
  constructor(desk) {
    this.desk = desk;
    this.box = /** @type {HTMLElement} */ (byId("list"));
    /** @type {Row[]} */
    this.listed = [];
    /** @type {Map<string, HTMLElement>} */
    this.shown = new Map();
    this.floor = make("div", { class: "floor", role: "presentation" });
    this.none = make("p", { class: "soft none", hidden: true, text: "No program matches." });
    this.box.append(this.floor);
    this.box.after(this.none);
    this.filters();
    this.box.addEventListener("scroll", () => this.draw(), { passive: true });
    this.box.addEventListener("keydown", (event) => this.key(event));
    this.box.addEventListener("click", (event) => {
      const id = /** @type {HTMLElement} */ (event.target).closest("[data-id]")?.getAttribute("data-id");
      if (id) void desk.choose(id);
    });
    new ResizeObserver(() => this.draw()).observe(this.box);
    desk.on(["class", "list"], () => this.fill());
    desk.on(["chosen"], () => this.reveal());
  }

  /** Build what narrows the list. */
  filters() {
    const { desk } = this;
    const set = () => desk.tell("list");
    this.search = make("input", { type: "search", id: "search", placeholder: "Search (/)", "aria-label": "Search names and causes", autocomplete: "off", spellcheck: "false", maxlength: 200 });
    this.search.addEventListener("input", () => {
      desk.filter.text = this.search?.value ?? "";
      set();
    });
    this.flags = FLAGS.map(([flag, word, title]) => {
      const one = button("", () => {
        if (!desk.filter.flags.delete(flag)) desk.filter.flags.add(flag);
        one.setAttribute("aria-pressed", String(desk.filter.flags.has(flag)));
        set();
      }, { title, "aria-pressed": "false", class: "flag" });
      one.append(word, " ", make("span", { class: "count" }));
      return /** @type {const} */ ([flag, one]);
    });
    this.reasons = choice([["", "Any reason"]], { "aria-label": "Reason why a mark is unsafe" });
    this.reasons.addEventListener("change", () => {
      desk.filter.reason = this.reasons?.value ?? "";
      set();
    });
    this.causes = choice([["", "Any cause"]], { "aria-label": "Cause of a loss" });
    this.causes.addEventListener("change", () => {
      desk.filter.cause = this.causes?.value ?? "";
      set();
    });
    const order = choice([["next", "next"], ["mark", "mark"], ["name", "name"]], { "aria-label": "Order of the list" });
    order.addEventListener("change", () => {
      desk.filter.order = /** @type {import("./filters.js").Order} */ (order.value);
      set();
    });
    this.count = make("span", { class: "soft", role: "status" });
    byId("filters").append(
      this.search,
      make("div", { class: "flags", role: "group", "aria-label": "Show only" }, ...this.flags.map(([, one]) => one)),
      make("div", { class: "picks" }, this.reasons, this.causes),
      make("div", { class: "counted" }, this.count, make("span", { class: "fill" }), make("span", { class: "soft", text: "by" }), order),
    );
  }

  /** Show the class, or what the filters leave of it. */
  fill() {
    const { desk } = this;
    this.listed = desk.listed;
    const { flags, reasons } = counts(desk.rows.values(), desk.me);
    for (const [flag, one] of this.flags ?? []) write(/** @type {Element} */ (one.lastElementChild), String(flags[flag] ?? 0));
    options(this.reasons, "Any reason", [...reasons].map(([reason, count]) => [reason, `${reason} (${count})`]));
    options(this.causes, "Any cause", (desk.data?.causes ?? []).map((cause) => [cause.key, `${lost(cause.points)} ${short(cause.sentence)} (${cause.count})`]));
    if (this.count) write(this.count, `${this.listed.length.toLocaleString("en")} of ${counted(desk.rows.size, "program")}`);
    this.none.hidden = this.listed.length > 0;
    this.floor.style.height = `${this.listed.length * HEIGHT}px`;
    for (const one of this.shown.values()) one.remove();
    this.shown.clear();
    this.draw();
  }

  /** Put those rows into the page that can be seen. */
  draw() {
    const first = Math.max(Math.floor(this.box.scrollTop / HEIGHT) - BEYOND, 0);
    const last = Math.min(Math.ceil((this.box.scrollTop + this.box.clientHeight) / HEIGHT) + BEYOND, this.listed.length);
    const wanted = new Set(this.listed.slice(first, last).map((row) => row.id));
    for (const [id, one] of this.shown) {
      if (wanted.has(id)) continue;
      one.remove();
      this.shown.delete(id);
    }
    for (let k = first; k < last; k += 1) {
      const row = this.listed[k];
      if (this.shown.has(row.id)) continue;
      const one = this.entry(row, k);
      this.shown.set(row.id, one);
      const after = [...this.floor.children].find((other) => Number(other.getAttribute("aria-posinset")) > k + 1);
      this.floor.insertBefore(one, after ?? null);
    }
    this.light();
  }

  /** @param {Row} row @param {number} place */
  entry(row, place) {
    const { desk } = this;
    const done = !isOpen(row, desk.me);
    const sign = row.conflict ? "⇄" : row.unsafe.length ? "!" : done ? "✓" : "";
    const says = row.conflict ? "conflict" : row.unsafe.length ? "unsafe" : done ? "finished" : "";
    const one = make("div", {
      class: `entry${row.pending ? " pending" : ""}`, role: "option", id: `row-${row.id}`, "data-id": row.id,
      "aria-setsize": this.listed.length, "aria-posinset": place + 1, "aria-selected": "false",
    },
      make("span", { class: `sign ${says}`, title: says },
        make("span", { "aria-hidden": "true", text: sign }), make("span", { class: "unseen", text: says && `${says}, ` })),
      make("span", { class: "who", dir: "auto", text: row.name }),
      make("span", { class: "number", text: row.excused ? "excused" : mark(row.final) }),
      make("span", { class: "soft why", dir: "auto", text: row.why_next || row.cause || "" }),
      make("span", { class: "soft marks", text: [row.items.length ? `${row.items.length} item${row.items.length > 1 ? "s" : ""}` : "", row.comments ? `${row.comments} ✎` : ""].filter(Boolean).join(" ") }),
    );
    one.style.top = `${place * HEIGHT}px`;
    return one;
  }

  /** Show which row is looked at. */
  light() {
    for (const [id, one] of this.shown) one.setAttribute("aria-selected", String(id === this.desk.chosen));
    const now = this.shown.get(this.desk.chosen);
    if (now) this.box.setAttribute("aria-activedescendant", now.id);
    else this.box.removeAttribute("aria-activedescendant");
  }

  /** Scroll to the row that is looked at. */
  reveal() {
    const place = this.listed.findIndex((row) => row.id === this.desk.chosen);
    const [top, height] = [this.box.scrollTop, this.box.clientHeight];
    if (place >= 0 && height) {
      const at = place * HEIGHT;
      if (at < top) this.box.scrollTop = at;
      else if (at + HEIGHT > top + height) this.box.scrollTop = at + HEIGHT - height;
    }
    this.draw();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const page = Math.max(Math.floor(this.box.clientHeight / HEIGHT) - 1, 1);
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    this.desk.step(by);
  }
}

/** @param {HTMLSelectElement | undefined} select @param {string} any @param {string[][]} rows */
function options(select, any, rows) {
  if (!select) return;
  const kept = select.value;
  select.replaceChildren(...[["", any], ...rows].map(([value, text]) => make("option", { value, text })));
  select.value = rows.some(([value]) => value === kept) ? kept : "";
}

/** @param {string} sentence */
export function short(sentence) {
  const plain = sentence.replaceAll("`", "");
  return plain.length > SENTENCE ? `${plain.slice(0, SENTENCE - 1)}…` : plain;
}

/** Return how a mark differs from the computed one. @param {Row} row */
export function difference(row) {
  const [final, computed] = [amount(row.final), amount(row.computed)];
  return final === null || computed === null || final === computed ? "" : `computed ${mark(computed)}`;
}
