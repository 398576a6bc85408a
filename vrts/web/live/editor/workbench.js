// The workbench: what is open, saving and its versions, loading and running, around the editor.

import { COMMANDING, allow, whyNoCommand, whyNotForRoom } from "../allowed.js";
import { byId, button, make, write } from "../dom.js";
import { LONGEST_PROGRAM } from "../protocol.js";
import { light } from "./at_work.js";
import { KEYS as REHEARSING } from "../rehearsal/bar.js";
import { mountRehearsal } from "../rehearsal/rehearsal.js";
import { asked } from "./asking.js";
import { mark } from "./diagnostics.js";
import { keepDraft, keptDraft } from "./draft.js";
import { Help } from "./help.js";
import { changes } from "./places.js";
import { Shelves } from "./shelf.js";
import { lineOf, programsIn } from "./steps.js";
import { chosenVersion, when, who } from "./versions.js";
import { makeView } from "./view.js";

const NEW = ".PROGRAM main\n  \n.END\n";
const KEYS = [
  ["Escape, then Tab", "leave the editor"], ["Ctrl+S", "save"], ["Ctrl+Enter", "load and run"], ["Ctrl+Space", "what may stand here"],
  ["F1", "what this word is"], ["F8", "next mistake"], ["Ctrl+.", "mend it"], ["Shift+Alt+F", "lay out"], ["Ctrl+F", "find"], ...REHEARSING,
];
const MOST_REMARKS = 3; // lines of the monitor that are said here, too
const BUSY = ["running", "waiting"];

/** @typedef {{shelf: import("./shelf.js").Shelf, name: string, seen: number}} Opened `seen`: version that one knows of; 0: none */

/** @param {import("../pages/room.js").App} app @param {HTMLElement} panel */
export function openWorkbench(app, panel) {
  const { store, command, act, toasts } = app;
  const shelves = new Shelves(() => store.now.room?.id ?? "");
  /** @type {{own: import("./shelf.js").Version[], room: import("./shelf.js").Version[]}} */
  let kept = { own: [], room: [] };
  /** @type {Opened} */
  let opened = { shelf: "own", name: "", seen: 0 };
  let saved = NEW; // text as it is kept, or as it was begun
  let along = new Set([""]); // ids of the rooms through which the text has come along
  let mistakes = 0;

  const pick = make("select", { class: "open", "aria-label": "Open a program", change: () => void picked() });
  const older = button("Versions", () => void lookBack(), { title: "All that was saved of this program" });
  const drop = button("Delete", () => void forget());
  const name = make("input", { "aria-label": "Name", maxlength: 40, spellcheck: "false", autocapitalize: "off", placeholder: "name", input: () => told() });
  const shelf = make("select", { "aria-label": "Where it is kept", title: "Where it is kept", change: () => told() },
    make("option", { value: "own", text: "for me" }), make("option", { value: "room", text: "for the room" }));
  const save = button("Save", () => void keep(), { class: "main", title: "Save as a new version (Ctrl+S)" });
  const host = make("div", { class: "host" });
  const state = make("span", { role: "status" });
  const problems = make("span", { role: "status" });
  const helping = make("span", {});
  const wake = button("Bring help here", () => help.open(), { hidden: true });
  const load = button("Load", () => void toRobot(false), { title: "Put the program into the robot's memory", "aria-describedby": "editor-why" });
  const run = button("Run", () => void toRobot(true), { class: "main", title: "Load, then EXECUTE (Ctrl+Enter)", "aria-describedby": "editor-why" });
  const stop = button("Abort", () => act({ type: "line", line: "ABORT" }), { "aria-describedby": "editor-why" });
  const lay = button("Lay out", () => void layOut(), { title: "Indent and space it as vrts does (Shift+Alt+F)" });
  const hand = button("Hand in …", () => void handOver(), { title: "Hand in what is in the editor", hidden: !store.now.course });
  const why = make("p", { class: "why", id: "editor-why", role: "status" });
  const keys = make("details", {}, make("summary", { text: "Keys" }),
    make("dl", {}, ...KEYS.flatMap(([key, words]) => [make("dt", {}, make("kbd", { text: key })), make("dd", { text: words })])));
  panel.classList.add("bench");
  panel.append(
    make("div", { class: "row" }, pick, older, drop),
    make("div", { class: "row" }, name, shelf, save),
    host,
    make("p", { class: "told" }, state, problems, helping, wake),
    make("div", { class: "row" }, run, load, stop, lay, hand),
    why, keys,
  );

  const help = new Help({
    text: () => view?.state.doc.toString() ?? "",
    diagnostics: (found) => {
      mistakes = found.filter(({ severity }) => severity === 1).length;
      const warnings = found.filter(({ severity }) => severity === 2).length;
      write(problems, `${plural(mistakes, "mistake")}${warnings ? `, ${plural(warnings, "warning")}` : ""}`);
      problems.className = mistakes ? "bad" : "";
      void mark(view, help, found);
    },
    state: (now, words) => {
      write(helping, words);
      wake.hidden = now !== "elsewhere";
    },
  });
  /** @type {import("@codemirror/view").EditorView} */
  const view = makeView(host, help, { changed, save: () => void keep(), run: () => void toRobot(true), layOut: () => void layOut() });
  const rehearsal = mountRehearsal(app, view, {
    help, shown: follow, name: fileName,
    why: () => (programsIn(lines()).length ? "" : "A program begins with .PROGRAM and its name."),
  });
  host.after(rehearsal.element, rehearsal.beside);
  Object.assign(window, { editing: { view, help, rehearsal } }); // for tests and for the curious

  // --- the text -------------------------------------------------------------------------------

  function text() {
    return view.state.doc.toString();
  }

  function lines() {
    return text().split("\n");
  }

  /** Put a text into the editor. @param {string} words @param {Opened} as @param {string} base text as it is kept */
  function show(words, as, base = words) {
    opened = as;
    saved = base;
    name.value = as.name;
    shelf.value = as.shelf;
    view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: words }, selection: { anchor: 0 } });
    rehearsal.forget();
    told();
  }

  /** @param {any} update */
  function changed(update) {
    rehearsal?.changed(update);
    if (!update.docChanged) return;
    help.change();
    told();
    remember();
  }

  /** Have the browser keep what is in the editor, for each room where it would be looked for. */
  function remember() {
    for (const one of along) keepDraft(one, { text: text(), saved, opened });
  }

  /** Return the name of the text as a file. */
  function fileName() {
    return `${(opened.name || programsIn(lines())[0]?.name || "main").replace(/[^\w.-]/g, "_").slice(0, 60)}.v2`;
  }

  async function layOut() {
    const { doc } = view.state;
    const edits = await help.ask("formatting", {});
    if (edits?.length && view.state.doc === doc) view.dispatch({ changes: changes(doc, edits), userEvent: "input.format" });
    else if (!edits) toasts.warn("The help is off, so the text stays as it is.");
    view.focus();
  }

  // --- keeping --------------------------------------------------------------------------------

  async function list() {
    try {
      kept = await shelves.all();
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    listed();
  }

  function listed() {
    const group = (/** @type {string} */ label, /** @type {HTMLOptionElement[]} */ options) => (options.length ? [make("optgroup", { label }, ...options)] : []);
    const kind = (/** @type {"own"|"room"} */ which) => kept[which].map((one) => make("option", { value: `${which} ${one.name}`, text: `${one.name} (version ${one.number})` }));
    const memory = store.now.programs.map((one) => make("option", { value: `memory ${one.name}`, text: one.name }));
    pick.replaceChildren(
      make("option", { value: "", text: opened.name ? `${opened.name}` : "not saved yet" }), make("option", { value: "new", text: "New program" }),
      ...group("Mine", kind("own")), ...group("The room's", kind("room")), ...group("In the robot's memory", memory));
    pick.value = "";
  }

  async function picked() {
    const [where, ...rest] = pick.value.split(" ");
    const called = rest.join(" ");
    pick.value = "";
    if (!where || !await mayLeave()) return;
    try {
      if (where === "new") show(NEW, { shelf: "own", name: "", seen: 0 });
      else if (where === "memory") {
        const program = store.now.programs.find((one) => one.name === called);
        if (program) show(`.PROGRAM ${program.name}\n${program.lines.join("\n")}\n.END\n`, { shelf: "own", name: program.name, seen: 0 });
      } else await bring(/** @type {import("./shelf.js").Shelf} */ (where), called);
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    listed();
    view.focus();
  }

  /** @param {import("./shelf.js").Shelf} where @param {string} called */
  async function bring(where, called) {
    kept = await shelves.all();
    const newest = kept[where].find((one) => one.name === called);
    if (newest) show(await shelves.text(where, called, newest.number), { shelf: where, name: called, seen: newest.number });
  }

  /** Ask before changes are left that are not saved. @returns {Promise<boolean>} whether they may be */
  async function mayLeave() {
    if (text() === saved) return true;
    const answer = await asked("Your changes are not saved", [make("p", { text: `Save ${opened.name || "the program"} first?` })],
      [["save", "Save"], ["leave", "Discard changes"], ["", "Keep writing"]]);
    if (answer === "save") return keep();
    return answer === "leave";
  }

  /** Save what is in the editor as a new version. @returns {Promise<boolean>} whether it is saved */
  async function keep() {
    const called = name.value.trim() || programsIn(lines())[0]?.name || "";
    if (!called) {
      toasts.warn("give the program a name first");
      name.focus();
      return false;
    }
    const where = /** @type {import("./shelf.js").Shelf} */ (shelf.value);
    const words = text();
    try {
      let seen = where === opened.shelf && called === opened.name ? opened.seen : 0;
      for (;;) {
        const { saved: done, version } = await shelves.keep(where, called, words, seen);
        if (done && version) {
          opened = { shelf: where, name: called, seen: version.number };
          saved = words;
          name.value = called;
          break;
        }
        if (!version || !await over(where, called, version)) return false;
        seen = version.number;
      }
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
      return false;
    }
    remember();
    told();
    await list();
    return true;
  }

  /** Ask whether to save over a version that one has not seen. @param {import("./shelf.js").Shelf} where @param {string} called @param {import("./shelf.js").Version} version */
  async function over(where, called, version) {
    const theirs = make("pre", { class: "preview", tabindex: "0", "aria-label": "That version", text: await shelves.text(where, called, version.number).catch(() => "") });
    const words = `${version.mine ? "You saved" : `${who(version)} saved`} version ${version.number} of ${called} at ${when(version.at)}, which you have not seen here.`;
    const answer = await asked("There is a newer version", [make("p", { text: words }), theirs],
      [["save", `Save mine as version ${version.number + 1}`], ["", "Keep writing"]]);
    return answer === "save";
  }

  async function lookBack() {
    try {
      const chosen = await chosenVersion(shelves, opened.shelf, opened.name);
      if (chosen && await mayLeave()) show(chosen.text, opened, saved);
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    view.focus();
  }

  async function forget() {
    const answer = await asked(`Delete ${opened.name}?`, [make("p", { text: "All its versions are deleted, for good. The text stays in the editor." })],
      [["", "Keep it"], ["drop", "Delete all versions"]]);
    if (answer !== "drop") return;
    try {
      await shelves.drop(opened.shelf, opened.name);
      opened = { ...opened, name: "", seen: 0 };
      saved = "";
      await list();
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    told();
  }

  /** Hand in what is in the editor, after a question. */
  async function handOver() {
    try {
      const { allWork, handIn, takenWords } = await import("../panels/assignments.js");
      const taken = await handIn(await allWork(), store.now.room?.scene ?? "", text(), opened.name || fileName());
      if (taken) toasts.tell(takenWords(taken));
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    view.focus();
  }

  /** Say whether the text is kept. */
  function told() {
    const same = text() === saved;
    write(state, !same ? "not saved" : opened.seen ? `saved, version ${opened.seen}` : "");
    state.className = same ? "" : "unsaved";
    older.disabled = !opened.seen;
    drop.disabled = !opened.seen || (opened.shelf === "room" && !store.now.supervisor);
    may();
  }

  // --- running --------------------------------------------------------------------------------

  /** Load what is in the editor, and run it. @param {boolean} runs */
  async function toRobot(runs) {
    may();
    if (run.disabled) {
      toasts.warn(why.textContent ?? "");
      return;
    }
    const words = text();
    const found = programsIn(words.split("\n"));
    try {
      const done = await command({ type: "upload", name: fileName(), text: words });
      const loaded = found.map((one) => one.name.toUpperCase());
      const main = store.now.programs.find((one) => one.main && loaded.includes(one.name.toUpperCase()))?.name ?? found[0].name;
      const wrong = remarks(done.text);
      if (wrong) toasts.warn(wrong);
      if (runs) {
        const refused = remarks((await command({ type: "line", line: `EXECUTE ${main}` })).text);
        if (refused && refused !== wrong) toasts.warn(refused);
      } else if (!wrong) toasts.tell(/^\.PROGRAM/m.test(done.text) ? `${main} is in the robot's memory` : done.text);
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
    view.focus();
  }

  /** Say what may be done now, and else why not. */
  function may() {
    const refused = whyNoCommand(store.now);
    const busy = BUSY.includes(store.now.status?.mode ?? "");
    const reasons = [
      [refused, refused],
      [busy, "A program is running: abort it first."],
      [!programsIn(lines()).length, "A program begins with .PROGRAM and its name."],
      [text().length > LONGEST_PROGRAM, "It is too long for a program."],
    ];
    const reason = /** @type {string} */ (reasons.find(([holds]) => holds)?.[1] ?? "");
    allow(save, shelf.value === "room" ? whyNotForRoom(store.now) : "");
    load.disabled = run.disabled = Boolean(reason);
    stop.disabled = Boolean(refused) || !busy;
    write(why, reason || (mistakes ? "The robot refuses what has mistakes." : ""));
  }

  /** Light the line that is at work at the moment that is shown. */
  function follow() {
    const { shown, programs } = store.now;
    const program = programs.find((one) => one.name === shown?.program);
    const line = shown && program && shown.mode !== "idle" && !rehearsal.shown ? lineOf(lines(), program, shown.step) : 0;
    if (line !== lit) light(view, line);
    lit = line;
  }
  let lit = 0;

  // --- beginning ------------------------------------------------------------------------------

  let room = "";
  store.on(["room"], ({ room: now }) => {
    if (!now || now.id === room) return;
    const first = !room;
    room = now.id;
    const draft = keptDraft(room);
    const unsaved = text() !== saved;
    if (!first && (!draft || draft.text === text() || (unsaved && draft.text === draft.saved))) { // what one writes comes along
      along.add(room);
      if (opened.shelf === "room") opened = { ...opened, seen: 0 }; // it was another room's
      remember();
      told();
    } else {
      along = new Set([room]);
      show(draft?.text ?? NEW, draft?.opened ?? { shelf: "own", name: "", seen: 0 }, draft?.saved ?? NEW);
    }
    void list();
  });
  store.on(["programs"], listed);
  store.on(["shown", "programs"], follow);
  store.on([...COMMANDING, "status"], may);
  window.addEventListener("beforeunload", (event) => {
    if (text() !== saved) event.preventDefault(); // the browser asks
  });
  if (byId("tab-editor").getAttribute("aria-selected") === "true" && !matchMedia("(pointer: coarse)").matches) view.focus();
}

/**
 * Return what the monitor said more than that it took a line or a file; empty: nothing.
 * @param {string} said
 */
function remarks(said) {
  const lines = said.split("\n").map((line) => line.trim()).filter(Boolean);
  return lines.filter((line) => !/ uploaded$|^\.PROGRAM\b|^\.? ?EXECUTE\b/i.test(line)).slice(0, MOST_REMARKS).join("; ");
}

/** @param {number} count @param {string} word */
function plural(count, word) {
  return `${count || "no"} ${word}${count === 1 ? "" : "s"}`;
}
