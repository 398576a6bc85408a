// What pages about people ask the server.

/** @param {string} path @returns {Promise<any>} */
export async function asked(path) {
  return read(await fetch(path));
}

/** @param {string} path @param {object} message @returns {Promise<any>} */
export async function told(path, message) {
  const headers = { "Content-Type": "application/json" };
  return read(await fetch(path, { method: "POST", headers, body: JSON.stringify(message) }));
}

/** @param {Response} answer */
async function read(answer) {
  if (answer.status === 204) return null;
  const json = answer.headers.get("content-type")?.startsWith("application/json");
  const body = json ? await answer.json() : {};
  if (answer.ok) return body;
  throw new Error([body.text ?? `the server answered ${answer.status}`, body.help].filter(Boolean).join("; "));
}
