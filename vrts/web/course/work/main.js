// Assignments of a course: what is asked for, until when, handing in, and what became of it.

import { byId, button, make, write } from "../../live/dom.js";
import { allWork, handIn, takenWords } from "../../live/panels/assignments.js";
import { LONGEST_PROGRAM } from "../../live/protocol.js";
import { applyTheme, chosenTheme } from "../../live/themes.js";
import { attemptList } from "./attempts.js";
import { finalOf } from "./final.js";
import { drawn, long, when } from "./words.js";

const SOON = 1_500; // [ms] between looks while something waits
const LATER = 30_000; // [ms] else

/** @typedef {import("../../live/panels/assignments.js").Work} Work */

/** @type {import("../../live/panels/assignments.js").AllWork | null} */
let all = null;
let behind = 0; // [s] of this machine's clock against the server's
let shown = ""; // what is drawn, as text
/** @type {Map<string, {blocks: import("./words.js").Block[], start: string, problem: string}>} */
const texts = new Map();
let next = 0;
let room = ""; // one that one may enter: programs are asked for through it
let robots = false; // whether the course has robots of one's own

function chosen() {
  const id = decodeURIComponent(location.hash.slice(1));
  return all?.assignments.find((one) => one.id === id) ?? all?.assignments[0];
}

async function load() {
  window.clearTimeout(next);
  try {
    all = await allWork();
    byId("alone").hidden = true;
    byId("main").hidden = false;
    show();
  } catch (problem) {
    if (!all) write(byId("alone"), /** @type {Error} */ (problem).message);
    else say(/** @type {Error} */ (problem).message, true);
  }
  const waits = all?.assignments.some(({ attempts }) => attempts?.some(({ state }) => state === "waiting"));
  next = window.setTimeout(() => void load(), waits ? SOON : LATER);
}

function show() {
  if (!all) return;
  document.title = `Assignments · ${all.title}`;
  write(byId("title"), all.title);
  write(byId("who"), [all.name, all.team].filter(Boolean).join(", "));
  const work = chosen();
  const key = JSON.stringify([all, work?.id]);
  if (key === shown) return tick();
  shown = key;
  const held = document.activeElement?.getAttribute("data-keep");
  byId("list").replaceChildren(...all.assignments.map((one) => row(one, one === work)));
  if (work) one(work);
  else byId("one").replaceChildren(make("p", { class: "alone soft", text: "No assignment is open yet." }));
  if (held) /** @type {HTMLElement | null} */ (document.querySelector(`[data-keep="${CSS.escape(held)}"]`))?.focus();
}

/** @param {Work} work @param {boolean} current */
function row(work, current) {
  const best = work.attempts?.find(({ mark }) => mark);
  const line = make("span", { class: "line" }, make("small", { text: work.due ? until(work) : "no deadline" }),
    make("small", { text: work.final ? work.final.mark : best ? `${best.mark} of ${best.total}` : "" }));
  return make("li", {}, make("button", {
    type: "button", "data-keep": `list ${work.id}`, ...(current ? { "aria-current": "true" } : {}),
    click: () => { location.hash = encodeURIComponent(work.id); },
  }, make("b", { text: work.title }), line));
}

/** @param {Work} work */
function until(work) {
  const left = work.due - now();
  return left > 0 ? `${long(left)} left` : "the deadline is over";
}

function now() {
  return Date.now() / 1000 + behind;
}

/** Draw an assignment. @param {Work} work */
function one(work) {
  const facts = make("dl", { class: "facts" });
  const add = (/** @type {string} */ name, /** @type {string} */ value, kind = "") => facts.append(make("dt", { text: name }), make("dd", { text: value, class: kind }));
  const own = work.own_due ? "; your own, later deadline" : "";
  if (work.due) add(work.exam ? "Closes" : "Due", `${when(work.due)} (${until(work)}${own})`);
  if (work.excused) add("Excused", "you need not hand this in");
  if (work.closes && !work.exam) add("Closes", `${when(work.closes)}: nothing is taken after that`);
  if (work.late) add("Late", `handing in now is ${work.late}`, "late");
  add("Attempts", work.most === null ? "as many as you like" : `${work.left} of ${work.most} left`);
  add("What counts", work.best ? "your best attempt" : "your latest attempt");
  const marks = (work.attempts ?? []).filter(({ mark }) => mark);
  if (marks.length) {
    const best = marks.reduce((a, b) => (Number(b.mark) > Number(a.mark) ? b : a));
    const said = (/** @type {{mark?: string, total?: string, number: number}} */ { mark, total, number }) => `${mark} of ${total}, attempt ${number}`;
    add("Public mark", work.best ? said(best) : said(marks[0]));
    if (!work.best && best !== marks[0]) add("Best so far", said(best));
  }
  if (work.team) add("Team", all?.team ? `you hand in together: ${all.team}` : "teams hand in together, and you are in none");
  if (work.refusal) add("Closed", [work.refusal, work.refusal_help].filter(Boolean).join("; "), "closed");
  byId("one").replaceChildren(
    make("section", { "aria-labelledby": "work-title" }, make("h2", { id: "work-title", text: work.title }), facts, ...robot(work), handing(work)),
    ...finalOf(work),
    make("section", { "aria-labelledby": "work-attempts" }, make("h3", { id: "work-attempts", text: "Your attempts" }), ...attemptList(work.id, work.attempts ?? [])),
    words(work),
  );
}

/** Return the way to one's own robot in the scene of an assignment, where there are such robots. @param {Work} work */
function robot(work) {
  if (!robots || !all?.hands_in) return [];
  const open = button("Work on it with my robot", async () => {
    try {
      const answer = await fetch("/course/robots", { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ scene: work.id }) });
      const told = await answer.json();
      if (!answer.ok) throw new Error(told.help ? `${told.text}: ${told.help}` : told.text);
      location.assign(`/?${new URLSearchParams({ room: told.room })}`);
    } catch (problem) {
      say(/** @type {Error} */ (problem).message, true);
    }
  }, { "data-keep": "robot" });
  return [make("div", { class: "row" }, open)];
}

/** Return what one hands in by. @param {Work} work */
function handing(work) {
  if (!all?.hands_in || work.refusal) return make("p", { class: "soft", text: all?.hands_in ? "" : "Only students on the list of the course hand in." });
  const file = make("input", { type: "file", id: "work-file", accept: ".v2,.pg,.lc,.txt,.val,text/plain", "data-keep": "file" });
  const pick = make("select", { "aria-label": "Program of mine", "data-keep": "pick" }, make("option", { value: "", text: "My programs …" }));
  void fill(pick);
  const press = button("Hand in …", () => void give(work, file, pick), { class: "main", "data-keep": "give" });
  return make("div", { class: "row" }, make("label", { class: "soft", for: "work-file", text: "A file, or a program that you saved in the editor:" }), file, pick, press);
}

/** @param {HTMLSelectElement} pick */
async function fill(pick) {
  if (!room) return;
  const answer = await fetch(`/programs?${new URLSearchParams({ room })}`);
  if (!answer.ok) return;
  const { own } = await answer.json();
  pick.append(...own.map((/** @type {{name: string, number: number}} */ one) => make("option", { value: JSON.stringify([one.name, one.number]), text: `${one.name} (version ${one.number})` })));
}

/** @param {Work} work @param {HTMLInputElement} file @param {HTMLSelectElement} pick */
async function give(work, file, pick) {
  try {
    const picked = file.files?.[0];
    let text = "";
    let called = "";
    if (picked) {
      if (picked.size > 4 * LONGEST_PROGRAM) throw new Error(`${picked.name} is too long for a program`);
      text = await picked.text();
      called = picked.name;
    } else if (pick.value) {
      const [name, number] = JSON.parse(pick.value);
      const answer = await fetch(`/programs/text?${new URLSearchParams({ shelf: "own", name, number })}`);
      const read = await answer.json();
      if (!answer.ok) throw new Error(read.text);
      text = read.text;
      called = name;
    } else throw new Error("Choose a file or one of your programs first.");
    if (!all) return;
    const taken = await handIn(all, work.id, text, called);
    if (!taken) return;
    say(takenWords(taken), false);
  } catch (problem) {
    say(/** @type {Error} */ (problem).message, true);
  }
  await load();
}

/** Return what is asked for. @param {Work} work */
function words(work) {
  const known = texts.get(work.id);
  const box = make("div", { class: "words" });
  if (known) box.append(...told(known));
  else {
    box.append(make("p", { class: "soft", role: "status", text: "The text is being read …" }));
    void text(work.id).then((found) => box.replaceChildren(...told(found))).catch((problem) => box.replaceChildren(make("p", { class: "soft", text: problem.message })));
  }
  return make("section", { "aria-label": "What is asked for" }, box);
}

/** @param {{blocks: import("./words.js").Block[], problem: string}} found */
function told({ blocks, problem }) {
  return problem ? [make("p", { class: "soft", text: problem })] : drawn(blocks);
}

/** @param {string} id */
async function text(id) {
  const answer = await fetch(`/course/work/text/${encodeURIComponent(id)}`);
  const found = await answer.json();
  if (!answer.ok) throw new Error(found.text);
  texts.set(id, found);
  return found;
}

/** @param {string} message @param {boolean} bad */
function say(message, bad) {
  const place = byId("said");
  place.className = bad ? "said bad" : "said";
  write(place, message);
}

/** Write times anew that pass by themselves. */
function tick() {
  const work = chosen();
  for (const [index, one] of (all?.assignments ?? []).entries()) {
    const small = byId("list").children[index]?.querySelector("small");
    if (small && one.due) write(small, until(one));
  }
  void work;
}

window.addEventListener("hashchange", () => show());
window.addEventListener("focus", () => void load());
applyTheme(chosenTheme());
void fetch("/me").then(async (answer) => {
  behind = (Date.parse(answer.headers.get("date") ?? "") - Date.now()) / 1000 || 0;
  if (answer.ok) {
    const me = await answer.json();
    room = me.rooms[0]?.id ?? "";
    robots = me.robots;
  }
  return load();
});
