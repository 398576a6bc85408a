// Beside the text of an editor: obeys the editor's messages, and tells it where the reader goes.

import { Stage } from "./stage.js";

const EVERY = 100; // [ms] between what the editor is told while something plays

/** @type {{postMessage: (message: unknown) => void}} */
const editor = /** @type {any} */ (window).acquireVsCodeApi();
const note = /** @type {HTMLElement} */ (document.getElementById("note"));
const replay = /** @type {HTMLElement} */ (document.getElementById("replay"));
const stage = new Stage(tell);
let [toldLine, toldAt] = [-1, -Infinity];
/** @type {Promise<void>} */
let going = Promise.resolve();

/** Tell the editor of a time that the reader chose, or that comes while it plays. @param {number} t @param {number} line */
function tell(t, line) {
  const now = performance.now();
  if (stage.player.playing && line === toldLine && now - toldAt < EVERY) return;
  [toldLine, toldAt] = [line, now];
  editor.postMessage({ kind: "at", t, line, playing: stage.player.playing });
}

/** @param {string} text @param {boolean} old whether what is shown is of another text */
function say(text, old = false) {
  note.textContent = text;
  note.classList.toggle("old", old);
}

/** @type {Record<string, (message: any) => Promise<void> | void>} */
const OBEYED = {
  async recording({ recording, t, still, text, old }) {
    replay.hidden = false;
    replay.classList.toggle("still", Boolean(still));
    await stage.take(typeof recording === "string" ? JSON.parse(recording) : recording, Number.isFinite(t) ? t : null);
    say(text ?? "", old);
  },
  time({ t, text }) {
    stage.stand(t);
    if (text !== undefined) say(text);
  },
  line({ line }) {
    const found = stage.standAtLine(line);
    say(found ? `line ${line}, at ${stage.player.t.toFixed(2)} s` : `line ${line}: nothing happens there in this run`);
  },
  note({ text, old }) {
    say(text, old);
  },
};

window.addEventListener("message", ({ data }) => {
  const act = OBEYED[data?.kind];
  if (act) going = going.then(() => act(data)).catch((problem) => say(`this cannot be shown: ${problem.message}`, true));
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") editor.postMessage({ kind: "leave" }); // back to the text
});
editor.postMessage({ kind: "ready" });
// For tests and for the curious.
Object.assign(window, { vrts: { stage } });
