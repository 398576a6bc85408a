// The WebSocket: joins, sends, gives answers to who asked, and comes back after a drop.

import { unpacked } from "./frame.js";
import { VERSION, packed } from "./protocol.js";

const FIRST_PAUSE = 250; // before coming back [ms]
const LONGEST_PAUSE = 8_000; // [ms]
const SILENCE = 12_000; // without a frame, after which the connection counts as dead [ms]
const EPOCH = Date.UTC(2026, 0, 1);
const FINAL = new Set(["kicked", "room closed", "room", "replaced", "version", "crowded", "left"]); // not to be followed by coming back

/** @typedef {import("./protocol.js").Message} Message */

/** What the server refused, in its words. */
export class Refusal extends Error {
  /** @param {{code: string, text: string, help?: string}} why */
  constructor(why) {
    super(why.help ? `${why.text}; ${why.help}` : why.text);
    this.code = why.code;
  }
}

/** One connection to a room, over any number of sockets. */
export class Connection {
  /**
   * @param {object} heard
   * @param {(message: Message) => void} heard.message
   * @param {(frame: import("./frame.js").PoseFrame) => void} heard.frame
   * @param {(state: "connecting"|"open"|"waiting"|"ended", why?: string) => void} heard.state
   */
  constructor(heard) {
    this.heard = heard;
    this.room = "";
    this.rate = 50;
    this.resume = "";
    this.seen = 0;
    this.last = 0; // number of the last command or question
    this.pause = FIRST_PAUSE;
    this.ended = true;
    this.bytes = 0;
    /** @type {Map<number, {resolve: (value: any) => void, reject: (error: Error) => void}>} */
    this.asked = new Map();
    window.addEventListener("online", () => this.hurry());
    document.addEventListener("visibilitychange", () => document.hidden || this.hurry());
    window.setInterval(() => this.watch(), 2_000);
  }

  /** Enter a room. @param {string} room empty: one's own */
  enter(room) {
    this.leave();
    this.room = room;
    this.resume = sessionStorage.getItem(`vrts ${room}`) ?? "";
    this.seen = 0;
    this.ended = false;
    this.open();
  }

  /** Close for good. */
  leave() {
    this.ended = true;
    window.clearTimeout(this.timer);
    this.socket?.close();
    this.socket = undefined;
    this.giveUp("you left the room");
  }

  open() {
    window.clearTimeout(this.timer);
    this.heard.state("connecting");
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.fresh = 0;
    socket.addEventListener("open", () => {
      socket.send(packed("join", { room: this.room, rate: this.rate, resume: this.resume, seen: this.seen, version: VERSION }));
    });
    socket.addEventListener("message", (event) => this.socket === socket && this.take(event.data));
    socket.addEventListener("close", () => this.socket === socket && this.dropped());
  }

  dropped() {
    this.socket = undefined;
    if (this.ended) return;
    this.heard.state("waiting");
    this.timer = window.setTimeout(() => this.open(), this.pause * (0.75 + 0.5 * Math.random()));
    this.pause = Math.min(this.pause * 2, LONGEST_PAUSE);
  }

  /** Come back now: the network or the user has returned. */
  hurry() {
    if (this.ended || this.socket) return;
    this.pause = FIRST_PAUSE;
    this.open();
  }

  /** A socket that frames came from and that has gone silent is dead, whatever it says. */
  watch() {
    if (!this.socket || !this.fresh || performance.now() - this.fresh < SILENCE) return;
    const socket = this.socket;
    this.dropped();
    socket.close();
  }

  /** @param {ArrayBuffer | string} data */
  take(data) {
    if (typeof data !== "string") {
      const frame = unpacked(data);
      this.fresh = performance.now();
      if (frame) this.heard.frame(frame);
      return;
    }
    /** @type {Message} */
    const message = JSON.parse(data);
    if (message.type === "welcome") this.welcomed(message);
    if (message.type === "closed") this.closed(message);
    if (typeof message.number === "number") this.seen = Math.max(this.seen, message.number);
    if (typeof message.of === "number" && this.answered(message)) return;
    this.heard.message(message);
  }

  /** @param {Message} message */
  welcomed(message) {
    this.pause = FIRST_PAUSE;
    if (!message.resumed) {
      this.seen = 0;
      this.giveUp("the connection was lost before the answer came");
    }
    this.resume = message.resume;
    sessionStorage.setItem(`vrts ${this.room}`, message.resume);
    this.heard.state("open");
  }

  /** @param {Message} message */
  closed(message) {
    if (!FINAL.has(message.code)) return;
    this.ended = true;
    sessionStorage.removeItem(`vrts ${this.room}`);
    this.heard.state("ended", message.text);
  }

  /** Give an answer to who asked. @param {Message} message @returns {boolean} whether somebody did */
  answered(message) {
    const waiting = this.asked.get(message.of);
    if (!waiting) return false;
    this.asked.delete(message.of);
    if (message.type === "refused") waiting.reject(new Refusal(/** @type {any} */ (message)));
    else waiting.resolve(message.result ?? message);
    return true;
  }

  /** @param {string} why */
  giveUp(why) {
    for (const { reject } of this.asked.values()) reject(new Error(why));
    this.asked.clear();
  }

  get ready() {
    return this.socket?.readyState === WebSocket.OPEN;
  }

  /** Send a message that needs no answer. @param {string} type @param {Record<string, unknown>} [fields] */
  send(type, fields = {}) {
    const text = packed(type, fields);
    if (this.ready) this.socket?.send(text);
    return this.ready;
  }

  /**
   * Send a question or a command; the answer is told by its number. The numbers grow also over
   * reloads of the page: they follow the clock.
   * @param {string} type @param {Record<string, unknown>} fields @param {"of"|"number"} name of the number
   * @returns {Promise<any>}
   */
  ask(type, fields, name = "of") {
    this.last = Math.max(this.last + 1, Math.floor((Date.now() - EPOCH) / 50) % 2 ** 31);
    const number = this.last;
    return new Promise((resolve, reject) => {
      if (!this.send(type, { ...fields, [name]: number })) {
        reject(new Error("there is no connection at the moment"));
        return;
      }
      this.asked.set(number, { resolve, reject });
    });
  }

  /** @param {number} rate frames a second */
  setRate(rate) {
    this.rate = rate;
    this.send("rate", { rate });
  }
}
