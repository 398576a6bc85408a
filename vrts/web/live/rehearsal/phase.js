// What a rehearsal has come to, and what may be asked of it. No page here, no socket.

/**
 * @typedef {"rehearse"|"run"|"over"|"into"|"out"|"back"|"back_run"|"start"|"end"} Step
 * @typedef {{line: number, verified: boolean, at?: number}} Checked a breakpoint; `at`: the line that it stands for
 * @typedef {{time_s: number, kind: string, text: string, line: number}} Moment
 * @typedef {{mark: number, total: number, lost: import("../protocol.js").Lost[]}} Mark
 * @typedef {{line: number, column: number, end_line: number, end_column: number, code: string, severity: "error"|"warning"|"note", message: string, help?: string}} Problem
 * @typedef {object} Ready the whole run is known
 * @property {number} [begin_s] where it begins on its clock [s]
 * @property {number} duration_s
 * @property {Checked[]} breakpoints
 * @property {Moment[]} marks
 * @property {import("../protocol.js").Contact[]} contacts
 * @property {import("../protocol.js").Contact[]} near
 * @property {boolean} undetermined of some pairs of bodies nothing could be proven
 * @property {Problem[]} problems warnings, and what went wrong
 * @property {string} note what else has to be said; empty: nothing
 * @property {Mark | null} mark by the public checks; null: the room has no task
 * @property {{why: string, line: number, time_s: number, text: string}} ended
 * @typedef {object} Place where it stands
 * @property {"breakpoint"|"step"|"end"|"start"|"error"|"time"} why "time": a moment that was asked about
 * @property {number} time_s
 * @property {string} program
 * @property {number} line of the text that is rehearsed; 0: not in it
 * @property {number} depth
 * @property {string} step_text
 * @property {string} text why it stands there, where there is more to say
 * @property {{name: string, value: string}[]} variables
 * @property {number} more variables that are not told
 * @property {string[]} typed
 */

/**
 * @typedef {object} Phase
 * @property {"none"|"begun"|"there"|"ended"} kind
 * @property {Ready | null} ready
 * @property {Place | null} place
 * @property {boolean} asked whether a step is under way
 * @property {boolean} shown whether the picture shows it
 * @property {boolean} earlier whether the text is another one by now
 * @property {string} why nothing goes on
 */

/** @type {Phase} */
export const NONE = { kind: "none", ready: null, place: null, asked: false, shown: false, earlier: false, why: "" };
const FORWARD = ["run", "over", "into", "out", "end"];

/**
 * Return what follows when something has happened.
 * @param {Phase} phase
 * @param {{type: "rehearse"} | {type: "ready", ready: Ready} | {type: "asked"} | {type: "placed", place: Place, step: boolean} | {type: "ended", message: string}
 *   | {type: "refused"} | {type: "shown", shown: boolean} | {type: "changed", earlier: boolean} | {type: "stop"}} happened
 * @returns {Phase}
 */
export function next(phase, happened) {
  switch (happened.type) {
    case "rehearse":
      return { ...NONE, kind: "begun" };
    case "ready":
      return { ...phase, kind: "there", ready: happened.ready };
    case "asked":
      return phase.kind === "there" ? { ...phase, asked: true } : phase;
    case "refused": // the step, not the rehearsal
      return { ...phase, asked: false };
    case "placed":
      return { ...phase, place: happened.place, asked: phase.asked && !happened.step };
    case "ended":
      return { ...NONE, kind: "ended", why: happened.message };
    case "shown":
      return { ...phase, shown: happened.shown };
    case "changed":
      return phase.kind === "none" || phase.kind === "ended" ? phase : { ...phase, earlier: happened.earlier };
    default:
      return NONE;
  }
}

/**
 * Return why a step cannot be gone now; empty: it can.
 * @param {Phase} phase @param {Step} step
 */
export function whyNot(phase, step) {
  if (phase.kind === "begun") return "The rehearsal is being worked out.";
  if (phase.kind !== "there" || !phase.ready) return "Rehearse first.";
  if (phase.asked) return "The step before is under way.";
  const why = phase.place?.why;
  if (FORWARD.includes(step) && (why === "end" || why === "error")) return "The rehearsal ends here.";
  if (!FORWARD.includes(step) && why === "start") return "The rehearsal begins here.";
  return "";
}

/**
 * Return where a rehearsal stands, in words.
 * @param {Phase} phase @param {number} line where that is in the text as it is now; 0: nowhere
 * @param {string} text of that line
 */
export function words(phase, line, text) {
  if (phase.kind === "begun") return "Being worked out …";
  if (phase.kind !== "there" || !phase.place) return phase.why;
  const { place } = phase;
  if (place.why === "end" && phase.ready) return `End: ${bare(phase.ready.ended.text)}${phase.earlier ? " (of an earlier text)" : ""}`;
  const at = line ? `line ${line}: ${text.trim()}` : [place.program, place.step_text].filter(Boolean).join(": ");
  const why = { breakpoint: "Breakpoint", step: "Step", end: "End", start: "Start", error: "Error", time: `At ${seconds(place.time_s - (phase.ready?.begin_s ?? 0))}` }[place.why];
  const more = place.why === "error" && place.text ? `: ${bare(place.text)}` : place.why === "start" && phase.ready ? `. ${outcome(phase.ready)}` : "";
  return `${at ? `${why}, ${at}` : why}${more}${phase.earlier ? " (of an earlier text)" : ""}`;
}

/** Return what comes of a run, in words. @param {Ready} ready */
export function outcome({ duration_s, marks, ended }) {
  const contacts = marks.filter(({ kind }) => kind === "contact").length;
  return `${seconds(duration_s)}, ${contacts === 1 ? "1 contact" : `${contacts || "no"} contacts`}; ${bare(ended.text)}`;
}

/** @param {string} text with names between backticks */
function bare(text) {
  return text.replaceAll("`", "");
}

/** Return which variables have another value than before. @param {Place | null} before @param {Place} now @returns {Set<string>} */
export function altered(before, now) {
  if (!before) return new Set();
  const old = new Map(before.variables.map(({ name, value }) => [name, value]));
  return new Set(now.variables.filter(({ name, value }) => old.get(name) !== value).map(({ name }) => name));
}

/** Return how long something takes, as people read it. @param {number} seconds */
export function seconds(seconds) {
  const whole = Math.floor(Math.max(seconds, 0) / 60);
  return whole ? `${whole}:${(seconds - 60 * whole).toFixed(1).padStart(4, "0")} min` : `${Math.max(seconds, 0).toFixed(1)} s`;
}
