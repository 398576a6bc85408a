// The grade book of an assignment: final marks, as `vrts grade export` writes them.

import { byId, make } from "../../live/dom.js";

const NO_MARKING = "The course does not say yet where it was marked. Name the folder in course.toml, such as marked = \"marked/cans\".";
const LONGEST = 4 * 1024 * 1024; // bytes of a teacher's file, as in grade_book.py

/** The dialog in which a teacher asks for a grade book. */
export class Grades {
  constructor() {
    this.dialog = /** @type {HTMLDialogElement} */ (byId("grades"));
    this.assignment = /** @type {HTMLSelectElement} */ (byId("grades-assignment"));
    this.to = /** @type {HTMLSelectElement} */ (byId("grades-to"));
    this.file = /** @type {HTMLInputElement} */ (byId("grades-fill"));
    this.column = /** @type {HTMLInputElement} */ (byId("grades-column"));
    this.despite = /** @type {HTMLInputElement} */ (byId("grades-despite"));
    this.button = /** @type {HTMLButtonElement} */ (byId("grades-go"));
    /** @type {import("./types.js").Column[]} */
    this.columns = [];
    byId("grades-open").addEventListener("click", () => this.open());
    byId("grades-close").addEventListener("click", () => this.dialog.close());
    this.assignment.addEventListener("change", () => this.begin());
    this.to.addEventListener("change", () => this.begin());
    byId("grades-form").addEventListener("submit", (/** @type {Event} */ event) => {
      event.preventDefault();
      void this.save();
    });
  }

  /** @param {import("./types.js").Column[]} columns */
  show(columns) {
    const before = this.marked();
    this.columns = columns;
    if (this.dialog.open && this.marked() !== before) this.begin();
    const chosen = this.assignment.value;
    if (this.assignment.options.length === columns.length && columns.every(({ id, title }, k) => this.assignment.options[k].value === id && this.assignment.options[k].text === title)) return;
    this.assignment.replaceChildren(...columns.map(({ id, title }) => make("option", { value: id, text: title })));
    if (columns.some(({ id }) => id === chosen)) this.assignment.value = chosen;
  }

  open() {
    const marked = this.columns.filter((one) => one.marked);
    if (marked.length && !marked.some(({ id }) => id === this.assignment.value)) this.assignment.value = marked[marked.length - 1].id;
    this.begin();
    this.dialog.showModal();
  }

  /** Show what has to be said for what is chosen. */
  begin() {
    const fills = this.to.value !== "csv";
    byId("grades-file").hidden = byId("grades-title-of").hidden = !fills;
    this.despite.checked = false;
    byId("grades-unsafe").hidden = true;
    this.button.disabled = !this.marked();
    this.say(this.marked() ? "" : NO_MARKING, "");
  }

  /** Whether the course says where the chosen assignment was marked. */
  marked() {
    return this.columns.some(({ id, marked }) => marked && id === this.assignment.value);
  }

  /** @param {string} why @param {string} words */
  say(why, words) {
    byId("grades-said").hidden = !why;
    byId("grades-why").textContent = why;
    byId("grades-words").textContent = words;
    byId("grades-words").hidden = !words;
  }

  async save() {
    const fills = this.to.value !== "csv", file = this.file.files?.[0];
    if (fills && !file) return this.say("Choose the file that you exported there.", "");
    if (fills && file && file.size > LONGEST) return this.say("This file is too large to be a grade book.", "");
    this.button.disabled = true;
    this.say("", "");
    try {
      const asked = { assignment: this.assignment.value, to: this.to.value, fill: fills && file ? await base64(file) : "", column: fills ? this.column.value.trim() : "", despite: this.despite.checked };
      const answer = await fetch("/course/board/grades", { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(asked) });
      if (answer.ok) {
        keep(await answer.blob(), fills && file ? file.name : `${asked.assignment}-marks.csv`);
        this.dialog.close();
      } else {
        const told = await answer.json();
        byId("grades-unsafe").hidden = told.code !== "unsafe";
        this.say(told.code === "unsafe" ? "Some marks are unsafe, so nothing was exported. Decide them at the desk, or export them all the same." : "Nothing was exported.",
          [told.text, told.help].filter(Boolean).join("\n"));
      }
    } catch {
      this.say("The server does not answer. Nothing was exported.", "");
    }
    this.button.disabled = false;
  }
}

/** @param {Blob} file */
async function base64(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = "";
  for (let k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode(...bytes.subarray(k, k + 0x8000));
  return btoa(text);
}

/** Let the browser save a file. @param {Blob} data @param {string} name */
function keep(data, name) {
  const address = URL.createObjectURL(data);
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
