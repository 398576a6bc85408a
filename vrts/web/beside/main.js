// Beside the text of an editor: obeys the editor's messages, and tells it where the reader goes.

import { Futures } from "./futures.js";
import { Places } from "./places.js";
import { Stage } from "./stage.js";

const EVERY = 100; // [ms] between what the editor is told while something plays

/** @type {{postMessage: (message: unknown) => void}} */
const editor = /** @type {any} */ (window).acquireVsCodeApi();
const note = /** @type {HTMLElement} */ (document.getElementById("note"));
const replay = /** @type {HTMLElement} */ (document.getElementById("replay"));
const stage = new Stage(tell);
const futures = new Futures((number) => editor.postMessage({ kind: "other", number }));
stage.shown = futures.show.bind(futures);
document.querySelector(".controls")?.append(/** @type {HTMLElement} */ (document.getElementById("places-check")));
const places = new Places(
  /** @type {HTMLElement} */ (document.querySelector(".view")),
  /** @type {HTMLInputElement} */ (document.getElementById("show-places")),
  {
    reach: (row, at) => editor.postMessage({ kind: "reach", ...called(row), at }),
    move: (row, at) => editor.postMessage({ kind: "move", ...called(row), at }),
  },
);
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

/** Return what a location is called among ourselves. @param {import("./places.js").Row} row */
function called({ name, of, subscripts, file }) {
  return { name, of, subscripts, file };
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
    const data = typeof recording === "string" ? JSON.parse(recording) : recording;
    await stage.take(data, Number.isFinite(t) ? t : null);
    places.over(stage.viewer);
    futures.ghost.over(stage.viewer);
    places.take(data.locations ?? []);
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
  futures({ rows }) {
    futures.list(rows);
  },
  async other({ other }) {
    await futures.take(other);
    stage.stand(stage.player.t);
  },
  compared({ rows }) {
    futures.compared(rows);
  },
  reach(answer) {
    places.answered(answer);
  },
  moved({ name, why, text }) {
    if (why !== undefined) places.refused(name);
    say(why === undefined ? text : `${name} stays: ${why}`, why !== undefined);
  },
};

window.addEventListener("message", ({ data }) => {
  const act = OBEYED[data?.kind];
  if (act) going = going.then(() => act(data)).catch((problem) => say(`this cannot be shown: ${problem.message}`, true));
});
document.addEventListener("keydown", (event) => {
  const key = event.key.toLowerCase();
  if ((event.ctrlKey || event.metaKey) && !event.altKey && (key === "z" || key === "y")) {
    editor.postMessage({ kind: key === "y" || event.shiftKey ? "redo" : "undo" }); // of the text
    event.preventDefault();
  }
  if (event.key === "Escape") editor.postMessage({ kind: "leave" }); // back to the text
});
editor.postMessage({ kind: "ready" });
// For tests and for the curious.
Object.assign(window, { vrts: { stage, places, futures } });
