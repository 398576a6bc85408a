// Hold to move: a key goes down, a heartbeat follows, and whatever ends it lets go.

import { isLive } from "../looking.js";

const BEAT = 70; // [ms]; the arm stops by itself after 200 ms without one

/** One key at a time. */
export class HeldKey {
  /** @param {import("../pages/room.js").App} app */
  constructor({ act }) {
    this.act = act;
    this.timer = 0;
    for (const name of ["blur", "pagehide"]) window.addEventListener(name, () => this.release());
    document.addEventListener("visibilitychange", () => document.hidden && this.release());
  }

  /** @param {{frame: string, axis: number, way: number, speed: number}} jog */
  press(jog) {
    this.release();
    const back = !isLive();
    this.act({ type: "jog", ...jog });
    if (back) return; // this press only led back to what is now
    this.timer = window.setInterval(() => this.act({ type: "keep" }), BEAT);
  }

  release() {
    if (!this.timer) return;
    window.clearInterval(this.timer);
    this.timer = 0;
    this.act({ type: "let_go" });
  }

  get down() {
    return this.timer !== 0;
  }
}
