// The monitor: a command line with history and completion, and what the terminal shows.

import { COMMANDING, allow, whyNoCommand } from "../allowed.js";
import { byId, make, onSubmit, write } from "../dom.js";
import { ofNow } from "../past/shown.js";
import { hintFor } from "./monitor_questions.js";
import { common, completions, namesIn } from "./monitor_words.js";

const MOST_HISTORY = 200;
const MOST_WORDS = 40;
const KEPT = "vrts lines";

/** @param {import("../pages/room.js").App} app */
export function mountMonitor({ store, act, command, toasts }) {
  const output = byId("terminal-output");
  const field = byId("terminal-line");
  const words = byId("terminal-words");
  /** @type {string[]} */
  const lines = JSON.parse(sessionStorage.getItem(KEPT) ?? "[]");
  byId("terminal").prepend(ofNow());
  let at = lines.length; // place in the history
  let draft = "";

  store.on(["output"], ({ output: text }) => {
    const below = output.scrollHeight - output.scrollTop - output.clientHeight < 40;
    write(output, text);
    if (below) output.scrollTop = output.scrollHeight;
  });
  store.on(["status"], ({ status }) => write(byId("terminal-prompt"), status?.prompt || "·"));
  store.on([...COMMANDING, "status"], () => {
    const why = whyNoCommand(store.now);
    allow(field, why);
    allow(byId("terminal-interrupt"), why);
    const { status, control, you, connection } = store.now;
    const short = why && connection === "open" && control.holder !== you ? "Take control first" : why; // the whole would not fit
    const hint = short || hintFor(status?.prompt ?? "", status !== null);
    if (field.placeholder !== hint) field.placeholder = hint;
  });
  byId("terminal-interrupt").addEventListener("click", () => act({ type: "interrupt" }));

  onSubmit(byId("terminal-form"), async () => {
    const line = field.value;
    if (line && line !== lines.at(-1)) lines.push(line);
    lines.splice(0, lines.length - MOST_HISTORY);
    sessionStorage.setItem(KEPT, JSON.stringify(lines));
    at = lines.length;
    field.value = "";
    words.hidden = true;
    output.scrollTop = output.scrollHeight;
    try {
      await command({ type: "line", line });
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
      if (!field.value) field.value = line;
    }
  });

  field.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      if (at === lines.length) draft = field.value;
      at = Math.min(Math.max(at + (event.key === "ArrowUp" ? -1 : 1), 0), lines.length);
      field.value = lines[at] ?? draft;
    } else if (event.key === "Tab" && !event.shiftKey && field.value) {
      event.preventDefault();
      complete();
    } else if (event.key === "c" && event.ctrlKey && field.selectionStart === field.selectionEnd) {
      event.preventDefault();
      act({ type: "interrupt" });
    } else if (event.key === "Escape") {
      words.hidden = true;
    }
  });
  field.addEventListener("input", () => (words.hidden = true));

  /** Put in what is certain, show what is possible. */
  function complete() {
    const cursor = field.selectionStart ?? field.value.length;
    const before = field.value.slice(0, cursor);
    const programs = store.now.programs.map(({ name }) => name);
    const texts = [...lines, ...store.now.programs.flatMap((program) => program.lines)];
    const found = completions(before, programs, namesIn(texts));
    if (!found.length) {
      words.hidden = true;
      return;
    }
    const start = /[#$]?[A-Za-z0-9_.]*$/.exec(before)?.[0] ?? "";
    insert(start, common(found) + (found.length === 1 ? " " : ""), cursor);
    words.hidden = found.length === 1;
    words.replaceChildren(...found.slice(0, MOST_WORDS).map((word) => make("button", {
      type: "button", text: word, tabindex: "-1",
      click: () => {
        const end = field.selectionStart ?? field.value.length;
        insert(/[#$]?[A-Za-z0-9_.]*$/.exec(field.value.slice(0, end))?.[0] ?? "", `${word} `, end);
        words.hidden = true;
        field.focus();
      },
    })));
  }

  /** @param {string} start what is there @param {string} word that takes its place @param {number} cursor */
  function insert(start, word, cursor) {
    const kept = field.value.slice(0, cursor - start.length) + word;
    field.value = kept + field.value.slice(cursor);
    field.setSelectionRange(kept.length, kept.length);
  }
}
