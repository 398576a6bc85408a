// A small client of the language server: one text, questions about it, what is wrong with it.

const PAUSE = 80; // between two changes that are told [ms]
const FIRST_WAIT = 1_000; // before the help is asked for again [ms]
const LONGEST_WAIT = 30_000; // [ms]
const LONGEST = 200_000; // characters

/** @typedef {"starting"|"on"|"off"|"elsewhere"|"idle"} State */

/** The help for one text. */
export class Help {
  /**
   * @param {object} heard
   * @param {() => string} heard.text as it is now
   * @param {(diagnostics: any[], version: number) => void} heard.diagnostics
   * @param {(state: State, words: string) => void} heard.state
   */
  constructor(heard) {
    this.heard = heard;
    this.version = 0; // of the text that was told last
    this.changed = false; // since then
    this.last = 0;
    this.wait = FIRST_WAIT;
    /** @type {Map<number, (result: any) => void>} */
    this.asked = new Map();
    this.ready = false;
    /** @type {number | undefined} */
    this.pause = undefined;
    this.open();
  }

  /** Begin, or begin again. */
  open() {
    window.clearTimeout(this.timer);
    this.timer = undefined;
    this.state("starting", "Help is starting …");
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/lsp`);
    this.socket = socket;
    let why = { code: "", text: "" };
    socket.addEventListener("message", ({ data }) => {
      const message = JSON.parse(data);
      if (message.method === "closed") why = message;
      else this.take(message);
    });
    socket.addEventListener("close", () => this.socket === socket && this.closed(why));
  }

  /** @param {{code: string, text: string}} why */
  closed(why) {
    this.socket = undefined;
    this.ready = false;
    for (const answer of this.asked.values()) answer(null);
    this.asked.clear();
    if (why.code === "elsewhere" || why.code === "idle") {
      this.state(why.code, why.text);
      return;
    }
    this.state("off", why.text || "no help at the moment: everything else works");
    this.timer = window.setTimeout(() => this.open(), this.wait * (0.75 + 0.5 * Math.random()));
    this.wait = Math.min(this.wait * 2, LONGEST_WAIT);
  }

  /** @param {any} message */
  take(message) {
    if (message.method === "ready") {
      this.ready = true;
      this.wait = FIRST_WAIT;
      this.version += 1;
      this.changed = false;
      this.send("didOpen", { version: this.version, text: this.text() });
      this.state("on", "");
    } else if (message.method === "textDocument/publishDiagnostics") {
      if (message.version === this.version && !this.changed) this.heard.diagnostics(message.diagnostics, message.version);
    } else if (typeof message.id === "number") {
      this.asked.get(message.id)?.(message.result);
      this.asked.delete(message.id);
    }
  }

  /** Hear that the text is another one now. */
  change() {
    this.changed = true;
    if (this.now === "idle") this.open();
    this.pause ??= window.setTimeout(() => this.tell(), PAUSE);
  }

  /** Tell the text as it is now, unless it has been told. */
  tell() {
    window.clearTimeout(this.pause);
    this.pause = undefined;
    if (!this.changed || !this.ready) return;
    this.changed = false;
    this.version += 1;
    this.send("didChange", { version: this.version, text: this.text() });
  }

  /** Ask about the text as it is now. @param {string} what @param {object} fields @returns {Promise<any>} null where there is no answer */
  ask(what, fields) {
    if (!this.ready) return Promise.resolve(null);
    this.tell();
    this.last += 1;
    const id = this.last;
    return new Promise((resolve) => {
      this.asked.set(id, resolve);
      this.send(what, { id, ...fields });
    });
  }

  text() {
    return this.heard.text().slice(0, LONGEST);
  }

  /** @param {string} what @param {object} fields */
  send(what, fields) {
    this.socket?.send(JSON.stringify({ method: `textDocument/${what}`, ...fields }));
  }

  /** @param {State} state @param {string} words */
  state(state, words) {
    this.now = state;
    this.heard.state(state, words);
  }
}
