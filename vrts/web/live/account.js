// Who one is: by cookie, join link, class code, or account.

import { carried } from "./still/carried.js";

/** @typedef {{name: string, supervisor: boolean, alone: boolean, students_reset: boolean, course?: boolean, robots?: boolean, leads?: boolean, teaches?: boolean, rooms: import("./protocol.js").RoomEntry[]}} Me */

/** What the server said when it let nobody in. */
export class Denied extends Error {
  /** @param {number} status @param {{code?: string, text?: string, help?: string}} problem */
  constructor(status, problem) {
    super([problem.text ?? `the server answered ${status}`, problem.help].filter(Boolean).join("; "));
    this.status = status;
  }
}

let offset = 0;

/** Return the server's clock minus the page's, as far as known [s]; times of turns are the server's. */
export function clockOffset() {
  return offset;
}

/** Return who is logged in; null when nobody is. @returns {Promise<Me | null>} */
export async function whoAmI() {
  const brought = carried();
  if (brought) {
    const [page] = /** @type {(PerformanceNavigationTiming | undefined)[]} */ (performance.getEntriesByType("navigation"));
    compareClocks(brought.now * 1000, performance.timeOrigin + (page?.responseStart ?? 0));
    return brought.me;
  }
  const answer = await fetch("/me");
  readClock(answer);
  return answer.status === 401 ? null : body(answer);
}

/** Enter by a link's token or a class code. @param {string} code @param {string} name @returns {Promise<Me>} */
export function enter(code, name) {
  return post("/enter", { code, name });
}

/** @param {string} user @param {string} password @returns {Promise<Me>} */
export function logIn(user, password) {
  return post("/login", { user, password });
}

/** @typedef {{guests: boolean, title: string, provider: string}} HowIn */

/** Ask how people come in here. @returns {Promise<HowIn>} */
export async function howIn() {
  return body(await fetch("/door"));
}

/** End the cookie. */
export async function logOut() {
  const answer = await fetch("/logout", { method: "POST" });
  if (!answer.ok) await body(answer);
}

/** @param {string} path @param {object} message */
async function post(path, message) {
  const answer = await fetch(path, {
    method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(message),
  });
  readClock(answer);
  return body(answer);
}

/** @param {Response} answer */
async function body(answer) {
  const json = answer.headers.get("content-type")?.startsWith("application/json");
  const read = json ? await answer.json() : {};
  if (!answer.ok) throw new Denied(answer.status, read);
  return read;
}

/** @param {Response} answer */
function readClock(answer) {
  const date = Date.parse(answer.headers.get("date") ?? "");
  if (!Number.isNaN(date)) compareClocks(date + 500, Date.now()); // the header counts whole seconds
}

/** @param {number} theirs @param {number} ours both since 1970 [ms]; two seconds are no difference */
function compareClocks(theirs, ours) {
  if (Math.abs(theirs - ours) > 2_000) offset = (theirs - ours) / 1000;
}
