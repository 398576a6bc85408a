// What became of rubric items: every version, undone or brought back for all who have the item.

import { ask } from "../ask.js";
import { button, make } from "../../live/dom.js";
import { isolated } from "../../live/names.js";
import { amount, counted, points, when } from "../words.js";
import { changing } from "./giving.js";
import { preview } from "./preview.js";

/** @typedef {import("../desk.js").Desk} Desk */
/** @typedef {import("../types.js").Item} Item */
/** @typedef {import("../types.js").Version} Version */

/** The versions of the item that is changed, and the items that nobody has any more. */
export class Versions {
  /** @param {Desk} desk @param {(undo: () => Promise<unknown>) => void} around what is done around an undo of a version */
  constructor(desk, around) {
    this.desk = desk;
    this.around = around;
    this.ofOne = make("div", { class: "versions" });
    this.withdrawn = make("details", { class: "versions" });
    this.seen = "";
    desk.sure = (records, given) => this.sure(records, given);
  }

  /** @param {Item | null} changed the item that is in the form */
  fill(changed) {
    const items = this.desk.data?.items ?? [];
    const now = items.find((item) => item.id === changed?.id) ?? null;
    const gone = items.filter((item) => item.withdrawn);
    const seen = JSON.stringify([now, gone]);
    if (seen === this.seen) return; // what has the keyboard stays
    this.seen = seen;
    this.ofOne.replaceChildren(...(now ? [make("h3", { text: "What became of this item" }), this.list(now)] : []));
    this.withdrawn.hidden = !gone.length;
    this.withdrawn.replaceChildren(make("summary", { text: `Withdrawn: ${counted(gone.length, "item")}` }),
      ...gone.flatMap((item) => [make("h3", { dir: "auto", text: item.title }), this.list(item)]));
  }

  /** @param {Item} item */
  list(item) {
    return make("ul", { class: "past" }, ...[...item.versions].reverse().map((one) => {
      const says = `${one.title} (${points(one.points)})${one.withdrawn ? ", withdrawn" : ""}`;
      const by = one.undone_by;
      const back = by ? button("Undo the undo", () => this.around(() => this.desk.undo([by], `undoing of ${says}`)), { class: "jump", "aria-label": `Undo the undo: ${says}` })
        : button("Undo", () => this.around(() => this.desk.undo([one.record], says)), { class: "jump", "aria-label": `Undo: ${says}` });
      return make("li", { class: by ? "undone" : "" }, make("p", { dir: "auto", text: says }),
        make("p", { class: "soft" }, isolated(one.name), `, ${when(one.at)}`), back);
    }));
  }

  /**
   * Ask whoever undoes what became of an item that others have: their marks change, too.
   * @param {string[]} records that are to be undone @param {Set<string>} given students who lose it by the same deed
   * @returns {Promise<boolean>}
   */
  async sure(records, given) {
    for (const item of this.desk.data?.items ?? []) {
      const others = item.students.filter((id) => !given.has(id)).flatMap((id) => this.desk.rows.get(id) ?? []);
      const [now, then] = [latest(item, []), latest(item, records)];
      if (now === then || !others.length) continue;
      const { open, fixed } = changing(others);
      const title = item.title || item.id;
      const becomes = then && !then.withdrawn ? `“${title}” is then “${then.title}” (${points(then.points)}).` : `Then nobody has “${title}” any more.`;
      const body = [make("p", { dir: "auto", text: becomes }), preview(open, worth(then) - worth(now)),
        ...(fixed.length ? [make("p", { text: `${counted(fixed.length, "student")} with a mark by hand, or excused: that stays, unless the item was given after it.` })] : [])];
      if (!(await ask(`Changes ${counted(open.length, "student")}`, body, "Undo"))) return false;
    }
    return true;
  }
}

/** Return the version of an item that likely holds when records are undone; the server tells which does. @param {Item} item @param {string[]} records */
function latest(item, records) {
  return item.versions.filter((one) => !records.includes(one.record) && (!one.undone_by || records.includes(one.undone_by))).at(-1);
}

/** @param {Version | undefined} version */
function worth(version) {
  return version && !version.withdrawn ? amount(version.points) ?? 0 : 0;
}
