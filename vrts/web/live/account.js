// Who one is: by cookie, join link, class code, or account.

/** @typedef {{name: string, supervisor: boolean, alone: boolean, students_reset: boolean, rooms: import("./protocol.js").RoomEntry[]}} Me */

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
  // the header counts whole seconds; less than that is no difference
  if (!Number.isNaN(date) && Math.abs(date - Date.now()) > 1500) offset = (date + 500 - Date.now()) / 1000;
}
