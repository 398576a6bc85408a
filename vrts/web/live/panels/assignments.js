// Handing in: which assignments there are, the question before, and what the server answers. For the editor and for the page of assignments.

import { make } from "../dom.js";
import { asked } from "../editor/asking.js";

/** @typedef {{points: string, cause: string, line?: number, time_s?: number, hint?: string, why?: string[]}} Loss */
/**
 * @typedef {{number: number, at: number, state: string, mark?: string, total?: string, late?: string, said?: string, by?: string,
 *   before?: number, page?: boolean, losses?: Loss[]}} Attempt
 */
/**
 * @typedef {{id: string, title: string, opens: number, due: number, closes: number, best: boolean, exam: boolean, team: boolean, late: string, own_due?: boolean, excused?: boolean,
 *   most: number | null, left: number | null, refusal: string, refusal_help: string, attempts?: Attempt[], final?: Final}} Work
 */
/** @typedef {{who?: string, text: string, line?: number, time_s?: number, points?: string}} Comment */
/** @typedef {{mark: string, made_of: string[], comments: Comment[], remarks: string[], page: boolean}} Final */
/** @typedef {{title: string, name: string, rank: string, team: string, hands_in: boolean, assignments: Work[]}} AllWork */
/** @typedef {{number: number, at: number, late: string, again: boolean}} Taken */

/** Ask what there is to do. @returns {Promise<AllWork>} */
export async function allWork() {
  return read(await fetch("/course/work/now"));
}

/** Return the number that the next attempt has. @param {Work} work */
export function nextNumber(work) {
  return Math.max(0, ...(work.attempts ?? []).map(({ number }) => number)) + 1;
}

/**
 * Ask whether a program is to be handed in, and hand it in.
 * @param {AllWork} all @param {string} id of the assignment that is chosen first; "" for any
 * @param {string} text @param {string} called what the program is called
 * @returns {Promise<Taken & {work: Work} | null>} null: somebody thought better of it
 */
export async function handIn(all, id, text, called) {
  const open = all.assignments.filter(({ refusal }) => !refusal);
  if (!all.hands_in) throw new Error("Only students on the list of the course hand in.");
  if (!open.length) throw new Error(all.assignments.length === 1 ? all.assignments[0].refusal : "Nothing can be handed in now.");
  let work = open.find((one) => one.id === id) ?? open[0];
  const what = make("p", { id: "hand-in-what" });
  const pick = make("select", { "aria-label": "Assignment", change: () => {
    work = open.find((one) => one.id === pick.value) ?? work;
    tell();
  } }, ...open.map((one) => make("option", { value: one.id, text: one.title })));
  pick.value = work.id;
  pick.disabled = open.length < 2;
  function tell() {
    const left = work.left === null ? "" : ` of ${work.most}`;
    const late = work.late ? `Handing in now is ${work.late}.` : "You are on time.";
    const whose = work.team && all.team ? ` It counts for all of ${all.team}.` : "";
    what.textContent = `${called} becomes attempt ${nextNumber(work)}${left}. ${late}${whose}`;
  }
  tell();
  const answer = await asked("Hand in?", [make("p", {}, pick), what], [["yes", "Hand in"], ["", "Not now"]]);
  if (answer !== "yes") return null;
  const body = JSON.stringify({ assignment: work.id, text, attempt: nextNumber(work), late: work.late });
  const taken = await read(await fetch("/course/work/hand-in", { method: "POST", headers: { "Content-Type": "application/json" }, body }));
  return { ...taken, work };
}

/** Return what was handed in, in words. @param {Taken & {work: Work}} taken */
export function takenWords({ work, number, late, again }) {
  if (again) return `This is the same program as attempt ${number} at ${work.title}: it counts already.`;
  return `Handed in: attempt ${number} at ${work.title}${late ? `, ${late}` : ""}. Its mark comes soon.`;
}

/** @param {Response} answer */
async function read(answer) {
  const json = answer.headers.get("content-type")?.startsWith("application/json") ? await answer.json() : {};
  if (!answer.ok) throw new Error([json.text ?? `the server answered ${answer.status}`, json.help].filter(Boolean).join("; "));
  return json;
}
