// Programs that the server keeps, asked for over HTTP.

/** @typedef {"own"|"room"} Shelf */
/** @typedef {{name: string, number: number, at: number, saver: string, mine: boolean, length: number}} Version */

/** Asks for one room. */
export class Shelves {
  /** @param {() => string} room id of the room */
  constructor(room) {
    this.room = room;
  }

  /** @returns {Promise<{own: Version[], room: Version[]}>} the newest version of everything */
  all() {
    return this.get("", {});
  }

  /** @param {Shelf} shelf @param {string} name @returns {Promise<Version[]>} the newest first */
  versions(shelf, name) {
    return this.get("/versions", { shelf, name });
  }

  /** @param {Shelf} shelf @param {string} name @param {number} number @returns {Promise<string>} */
  async text(shelf, name, number) {
    return (await this.get("/text", { shelf, name, number: String(number) })).text;
  }

  /**
   * Save a text as the next version, unless there is a version that one has not seen.
   * @param {Shelf} shelf @param {string} name @param {string} text @param {number} seen
   * @returns {Promise<{saved: boolean, version: Version | null}>} the newest version
   */
  keep(shelf, name, text, seen) {
    return this.post("/keep", { shelf, name, text, seen });
  }

  /** @param {Shelf} shelf @param {string} name */
  drop(shelf, name) {
    return this.post("/drop", { shelf, name });
  }

  /** @param {string} what @param {Record<string, string>} fields */
  async get(what, fields) {
    return read(await fetch(`/programs${what}?${new URLSearchParams({ room: this.room(), ...fields })}`));
  }

  /** @param {string} what @param {object} fields */
  async post(what, fields) {
    const body = JSON.stringify({ room: this.room(), ...fields });
    return read(await fetch(`/programs${what}`, { method: "POST", headers: { "Content-Type": "application/json" }, body }));
  }
}

/** @param {Response} answer */
async function read(answer) {
  if (answer.status === 204) return null;
  const json = answer.headers.get("content-type")?.startsWith("application/json") ? await answer.json() : {};
  if (!answer.ok) throw new Error([json.text ?? `the server answered ${answer.status}`, json.help].filter(Boolean).join("; "));
  return json;
}
