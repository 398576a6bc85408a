// The socket of a rehearsal: one for this page and room, opened when it is wanted.

import { Blocks, Block } from "../past/blocks.js";

const BETWEEN = 130; // questions where something was at a moment [ms]
const PATIENCE = 30_000; // for a block [ms]
const REFUSED = "The server has no place for a rehearsal at the moment. Try again in a minute.";
const LOST = "The connection to the rehearsal was lost. Rehearse again.";

/** @typedef {Record<string, any> & {type: string, id: number}} Message */

/** Sends and hears what is about the last rehearsal. */
export class Link {
  /**
   * @param {() => string} room id of the room
   * @param {(message: Message) => void} heard
   */
  constructor(room, heard) {
    this.room = room;
    this.heard = heard;
    this.id = 0; // of the last rehearsal
    /** @type {WebSocket | null} */
    this.socket = null;
    /** @type {{what: string, number?: number}[]} what was asked and is not answered, in order; `number`: of a block */
    this.asked = [];
    /** @type {Map<number, (message: Message) => void>} who waits for a block */
    this.blocks = new Map();
    /** @type {number | null} the moment to be asked about next [s] */
    this.wanted = null;
    this.pause = 0;
  }

  /** Begin another rehearsal; the one before is forgotten. @param {{name: string, text: string, from: string, breakpoints: number[]}} fields */
  begin(fields) {
    this.forget();
    this.id += 1;
    const first = JSON.stringify({ type: "rehearse", id: this.id, ...fields });
    if (this.socket?.readyState === WebSocket.OPEN) {
      this.socket.send(first);
      return;
    }
    this.socket?.close();
    const { protocol, host } = location;
    const socket = new WebSocket(`${protocol === "https:" ? "wss" : "ws"}://${host}/rehearse?${new URLSearchParams({ room: this.room() })}`);
    this.socket = socket;
    let opened = false;
    let why = "";
    socket.addEventListener("open", () => {
      opened = true;
      if (socket === this.socket) socket.send(first);
    });
    socket.addEventListener("message", ({ data }) => {
      if (socket !== this.socket) return;
      const message = JSON.parse(data);
      if (message.type === "closed") why = message.text;
      else this.take(message);
    });
    socket.addEventListener("close", () => {
      if (socket !== this.socket) return;
      this.socket = null;
      this.forget();
      this.heard({ type: "ended", id: this.id, message: why || (opened ? LOST : REFUSED), lost: true });
    });
  }

  /** @param {Message} message */
  take(message) {
    if (message.id !== this.id && message.id !== 0) return; // of a rehearsal that is over
    if (message.type === "block") {
      this.answered(({ what, number }) => what === "block" && number === message.number);
      this.blocks.get(message.number)?.(message);
      this.blocks.delete(message.number);
      return;
    }
    if (message.type === "stopped") {
      const step = this.answered(({ what }) => what === "go" || what === "at")?.what === "go";
      if (step || !this.waits("go")) this.heard({ ...message, step });
      return;
    }
    if (message.type === "breakpoints") this.answered(({ what }) => what === "breakpoints");
    if (message.type === "refused" && message.of) {
      this.heard({ ...message, question: this.turnedAway(message) });
      return;
    }
    if (message.id && (message.type === "refused" || message.type === "ended")) this.forget();
    this.heard(message);
  }

  /** Take the first of some questions off the list. @param {(question: {what: string, number?: number}) => boolean} is */
  answered(is) {
    const index = this.asked.findIndex(is);
    return index < 0 ? undefined : this.asked.splice(index, 1)[0];
  }

  /** @param {string} wanted whether such a question waits for its answer */
  waits(wanted) {
    return this.asked.some(({ what }) => what === wanted);
  }

  /** Take a question that was refused off the list. @param {Message} message @returns {string} what it was */
  turnedAway({ of, number, message: why }) {
    const index = this.asked.findLastIndex((one) => one.what === of && one.number === number);
    if (index >= 0) this.asked.splice(index, 1);
    this.blocks.get(number)?.({ type: "block", id: this.id, message: why });
    this.blocks.delete(number);
    return of;
  }

  /** @param {string} type @param {Record<string, any>} fields @returns {boolean} whether it is on its way */
  send(type, fields = {}) {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify({ type, id: this.id, ...fields }));
    this.asked.push({ what: type, number: fields.number });
    return true;
  }

  /** Go a step. @param {string} what */
  go(what) {
    this.wanted = null;
    this.send("go", { what });
  }

  /** Ask where it stands at a moment: one question at a time, the last one counts. @param {number} time_s */
  at(time_s) {
    this.wanted = time_s;
    if (!this.pause) this.ask();
  }

  ask() {
    this.pause = 0;
    if (this.wanted === null) return;
    if (!this.waits("at") && this.send("at", { time_s: this.wanted })) this.wanted = null;
    this.pause = window.setTimeout(() => this.ask(), BETWEEN);
  }

  /** @param {number} number @returns {Promise<import("../past/blocks.js").BlockData>} */
  block(number) {
    return new Promise((resolve, reject) => {
      const late = window.setTimeout(() => reject(new Error("this part of the rehearsal did not come in time")), PATIENCE);
      this.blocks.set(number, ({ data, message }) => {
        window.clearTimeout(late);
        if (data) resolve(data);
        else reject(new Error(message ?? "this part of the rehearsal is missing"));
      });
      if (!this.send("block", { number })) this.blocks.get(number)?.({ type: "block", id: this.id, message: LOST });
    });
  }

  /** End the rehearsal, also one whose text is not on its way yet. */
  stop() {
    if (!this.send("stop")) return this.close();
    this.forget();
    this.id += 1; // what still comes is about nothing
  }

  /** Close: the room is another one. */
  close() {
    const { socket } = this;
    this.socket = null;
    socket?.close();
    this.forget();
    this.id += 1;
  }

  forget() {
    window.clearTimeout(this.pause);
    this.pause = 0;
    this.wanted = null;
    this.asked = [];
    for (const tell of [...this.blocks.values()]) tell({ type: "block", id: this.id, message: LOST });
    this.blocks.clear();
  }
}

/** The poses of a rehearsal, by minutes, as those of the past. */
export class RehearsedBlocks extends Blocks {
  /** @param {Link} link @param {() => import("../../viewer/kinematics.js").Arm | undefined} arm */
  constructor(link, arm) {
    super(() => "", arm, () => {});
    this.link = link;
  }

  /** @override @param {number} number @returns {Promise<Block>} */
  async ask(number) {
    const arm = this.arm();
    if (!arm) throw new Error("there is no picture to show it in");
    return Block.unpack(arm, await this.link.block(number));
  }
}
