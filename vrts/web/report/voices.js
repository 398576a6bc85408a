// What people said and did while a session went on: lanes under the time bar, rows of the list, and what of it is listed.

/** @typedef {{t: number, end: number | null, kind: string, name: string, text: string}} Voice */
/** @typedef {import("./lanes.js").Lane} Lane */
/** @typedef {import("./events.js").Row} Row */

const LANES = { control: "Control", people: "People", chat: "Chat", note: "Notes", stop: "Stops" };
const CONTACTS = ["contact", "graze", "doubtful", "near"];
const OF_VOICE = "voice ";

/** Return what is listed of a voice. @param {Voice} voice */
function words({ name, text, kind }) {
  return kind === "chat" || kind === "note" ? `${name || "somebody"}: ${text}` : `${name || "somebody"} ${text}`;
}

/** Return a row of the list for each voice. @param {Voice[] | undefined} voices @returns {Row[]} */
export function voiceRows(voices = []) {
  return voices.map((voice) => ({ t: voice.t, kind: OF_VOICE + voice.kind, text: words(voice), line: 0 }));
}

/** Return the lanes in which there is anything. @param {Voice[] | undefined} voices @returns {Lane[]} */
export function voiceLanes(voices = []) {
  return Object.entries(LANES).map(([kind, name]) => ({
    name,
    bars: voices.filter((voice) => voice.kind === kind).map((voice) => ({
      start: voice.t, end: voice.end ?? voice.t, kind: OF_VOICE + kind, label: voice.end === null ? "" : voice.name,
      text: `${words(voice)}, at ${voice.t.toFixed(1)} s`,
    })),
  })).filter(({ bars }) => bars.length);
}

/** Return the group by which a row can be left out of the list. @param {string} kind */
function groupOf(kind) {
  if (kind.startsWith(OF_VOICE)) return LANES[/** @type {keyof typeof LANES} */ (kind.slice(OF_VOICE.length))] ?? "People";
  if (kind === "comment") return LANES.note; // beside those of who led the session
  return CONTACTS.includes(kind) ? "Contacts" : "Robot";
}

/**
 * Put switches above the list that say what is listed; only a page with voices has them.
 * @param {HTMLElement} box of the list @param {Row[]} rows @param {(listed: (row: Row) => boolean) => void} list
 */
export function bindFilter(box, rows, list) {
  if (!rows.some(({ kind }) => kind.startsWith(OF_VOICE))) return;
  const groups = [...new Set(rows.map(({ kind }) => groupOf(kind)))];
  const wanted = new Set(groups);
  const field = document.createElement("fieldset");
  field.className = "listed";
  const legend = document.createElement("legend");
  legend.textContent = "Listed";
  field.append(legend, ...groups.map((group) => {
    const label = document.createElement("label");
    const tick = document.createElement("input");
    tick.type = "checkbox";
    tick.checked = true;
    tick.addEventListener("change", () => {
      if (tick.checked) wanted.add(group);
      else wanted.delete(group);
      list((row) => wanted.has(groupOf(row.kind)));
    });
    label.append(tick, ` ${group}`);
    return label;
  }));
  box.before(field);
}
