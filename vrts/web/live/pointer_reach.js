// Asks whether the tool can go somewhere: at most twenty times a second, one question at a time.

/**
 * @typedef {object} Reached what the session answers (`Reached`)
 * @property {boolean} reachable
 * @property {string} why in words, when it cannot
 * @property {string} code
 * @property {string[]} branch such as lefty, above, noflip
 * @property {number[]} joints_rad at the goal
 */

/** @typedef {{position_m: number[], oat_rad: number[], straight: boolean}} Question */
/** @typedef {{state: "asking"|"yes"|"no"|"unknown", text: string, reached: Reached | null}} Answer */

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
    this.asked = -Infinity; // [ms] when the last question went out
    this.timer = 0;
  }

  /** @param {Question} question replaces one that still waits */
  want(question) {
    this.waiting = question;
    this.told({ state: "asking", text: "asking whether it can be reached", reached: null });
    this.next();
  }

  /** Ask nothing more. */
  stop() {
    this.waiting = null;
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
      (reached) => this.answered({ state: reached.reachable ? "yes" : "no", text: words(reached), reached }),
      (problem) => this.answered({ state: "unknown", text: `not known: ${problem.message}`, reached: null }),
    );
  }

  /** @param {Answer} answer */
  answered(answer) {
    this.under_way = false;
    if (!this.waiting) this.told(answer);
    this.next();
  }
}

/** @param {Reached} reached */
export function words(reached) {
  if (!reached.reachable) return `out of reach: ${reached.why || "no arm branch leads there"}`;
  const branch = reached.branch.map((word) => BRANCHES[/** @type {keyof typeof BRANCHES} */ (word.toLowerCase())] ?? word);
  return branch.length ? `in reach: ${branch.join(", ")}` : "in reach";
}
