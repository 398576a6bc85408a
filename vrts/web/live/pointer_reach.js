// Asks whether the tool can go somewhere: at most twenty times a second, one question at a time.

/** @typedef {import("./protocol.js").Reached} Reached what the session answers */
/** @typedef {"asking"|"yes"|"way"|"touches"|"no"|"unknown"} ReachState yes: the way is free; way: something touches before its end */
/** @typedef {{position_m: number[], oat_rad: number[], straight: boolean}} Question */
/** @typedef {{state: ReachState, text: string, reached: Reached | null}} Answer */

export const BETWEEN_MS = 50; // questions

const BRANCHES = {
  lefty: "left arm", righty: "right arm", above: "elbow above", below: "elbow below",
  flip: "wrist flipped", noflip: "wrist not flipped",
};

/** Keeps the answer to the last question; answers that come late do not count. */
export class ReachAsker {
  /**
   * @param {(question: Question) => Promise<Reached>} ask
   * @param {(answer: Answer) => void} told called whenever the answer changes
   */
  constructor(ask, told) {
    this.ask = ask;
    this.told = told;
    /** @type {Question | null} */
    this.waiting = null;
    this.under_way = false;
    this.stopped = false;
    this.asked = -Infinity; // [ms] when the last question went out
    this.timer = 0;
  }

  /** @param {Question} question replaces one that still waits */
  want(question) {
    this.waiting = question;
    this.stopped = false;
    this.told({ state: "asking", text: "asking whether it can be reached", reached: null });
    this.next();
  }

  /** Ask nothing more. */
  stop() {
    this.waiting = null;
    this.stopped = true; // an answer that is under way is of no use any more
    clearTimeout(this.timer);
    this.timer = 0;
  }

  /** Send what waits, now or when it is time. */
  next() {
    if (this.under_way || this.timer || !this.waiting) return;
    const wait = this.asked + BETWEEN_MS - performance.now();
    if (wait > 0) {
      this.timer = window.setTimeout(() => {
        this.timer = 0;
        this.next();
      }, wait);
      return;
    }
    const question = this.waiting;
    this.waiting = null;
    this.asked = performance.now();
    this.under_way = true;
    this.ask(question).then(
      (reached) => this.answered({ state: stateOf(reached), text: words(reached), reached }),
      (problem) => this.answered({ state: "unknown", text: `not known: ${problem.message}`, reached: null }),
    );
  }

  /** @param {Answer} answer */
  answered(answer) {
    this.under_way = false;
    if (!this.waiting && !this.stopped) this.told(answer);
    this.next();
  }
}

/** @param {Reached} reached @returns {ReachState} */
export function stateOf({ reachable, way, touches }) {
  if (!reachable) return "no";
  if (touches?.some((touch) => touch.at_goal)) return "touches";
  if (touches?.length) return "way";
  return way === "unknown" ? "unknown" : "yes";
}

/** @param {Reached} reached */
export function words(reached) {
  if (!reached.reachable) return `out of reach: ${reached.why || "no arm branch leads there"}`;
  const branch = reached.branch.map((word) => BRANCHES[/** @type {keyof typeof BRANCHES} */ (word.toLowerCase())] ?? word);
  const place = branch.length ? `in reach: ${branch.join(", ")}` : "in reach";
  const touches = reached.touches ?? [];
  if (!touches.length) {
    if (reached.way === "free") return `${place}; nothing touches on the way`;
    return reached.way === "unknown" ? `${place}; ${reached.why || "the way is not decided"}` : place;
  }
  const first = touches.find((touch) => touch.at_goal) ?? touches[0];
  const where = first.at_goal ? "touches there" : `touches on the way, ${Math.round(100 * first.start)} % along`;
  const more = touches.length > 1 ? ` (and ${touches.length - 1} more)` : "";
  return `${where}: ${first.text}${more}`;
}
