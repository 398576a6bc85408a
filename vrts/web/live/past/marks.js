// What happened, by time: from the blocks that are here, from the store, and from whoever offers more.

import { BLOCK } from "./blocks.js";

export const FARTHEST = 20; // blocks, of a minute each, that are looked through for the next mark
const SAME = 0.002; // marks of the same words nearer than this are one [s]
const TINY = 1e-3; // by which the next one is later [s]

/** @typedef {{t: number, kind: string, text: string}} Mark */

/** What can be jumped to: name, and which kinds of marks. @type {Record<string, [string, (kind: string) => boolean]>} */
export const JUMPS = {
  all: ["Events", (kind) => kind !== "line"],
  contact: ["Contacts", (kind) => kind === "contact" || kind === "near"],
  grasp: ["Grips", (kind) => kind === "grasp" || kind === "hand"],
  line: ["Lines", (kind) => kind === "line"],
  stop: ["Stops", (kind) => kind === "panic" || kind === "fault" || kind === "program"],
  note: ["Notes", (kind) => kind === "said"],
};

/** @type {(() => Mark[])[]} */
const sources = [];

/** Have marks of another kind on the time line, such as notes: kind `said`. @param {() => Mark[]} source */
export function offerMarks(source) {
  sources.push(source);
}

/** All marks that are known. */
export class Marks {
  /** @param {import("../store.js").Store} store @param {import("./blocks.js").Blocks} blocks */
  constructor(store, blocks) {
    this.store = store;
    this.blocks = blocks;
  }

  /**
   * Return the marks from one time to another, in order.
   * @param {number} from [s] @param {number} to [s] @param {boolean} lines whether those of each line are wanted
   * @returns {Mark[]}
   */
  between(from, to, lines = false) {
    const { events, contacts, near } = this.store.now;
    /** @type {Mark[]} */
    const found = [
      ...events.map((row) => ({ t: row.time_s, kind: row.kind, text: row.text })),
      ...contacts.map((row) => ({ t: row.start, kind: "contact", text: row.text })),
      ...near.map((row) => ({ t: row.start, kind: "near", text: row.text })),
      ...sources.flatMap((source) => source()),
    ];
    for (const { data } of this.blocks.kept.values()) {
      if (data.until < from || data.begin > to) continue;
      found.push(...data.marks);
      if (lines) for (const [t, number] of data.lines) if (number >= 0) found.push({ t, kind: "line", text: data.steps[number].text });
    }
    const inside = found.filter(({ t }) => from <= t && t <= to).sort((a, b) => a.t - b.t || (a.text < b.text ? -1 : 1));
    return inside.filter((mark, index) => !inside.slice(Math.max(index - 8, 0), index)
      .some((other) => mark.t - other.t < SAME && other.text === mark.text && other.kind === mark.kind));
  }

  /**
   * Return the next mark, or the one before; without one, whether there may be one farther away.
   * @param {number} t [s] @param {1 | -1} direction @param {keyof typeof JUMPS} jump @param {number} now [s]
   * @returns {Promise<{mark?: Mark, far: boolean}>}
   */
  async next(t, direction, jump, now) {
    const fits = JUMPS[jump][1];
    let number = Math.floor(t / BLOCK);
    for (let looked = 0; looked < FARTHEST; looked++, number += direction) {
      const [from, to] = [number * BLOCK, (number + 1) * BLOCK];
      if (number < 0 || from > now || to <= this.blocks.reaches) return { far: false };
      await this.blocks.fetched(number);
      const marks = this.between(from, to, jump === "line").filter((mark) => fits(mark.kind));
      const mark = direction > 0 ? marks.find((one) => one.t > t + TINY) : marks.findLast((one) => one.t < t - TINY);
      if (mark) return { mark, far: false };
    }
    return { far: true };
  }
}
