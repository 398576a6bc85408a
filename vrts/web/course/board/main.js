// The board: asked for once, then told what changes.

import { byId, write } from "../../live/dom.js";
import { applyTheme, chosenTheme } from "../../live/themes.js";
import { Causes } from "./causes.js";
import { Grades } from "./grades.js";
import { Marks } from "./marks.js";
import { showStudent } from "./student.js";
import { showWaits } from "./waits.js";
import { counted } from "./words.js";

const EVERY = 30_000; // [ms] in which times such as "5 min" are written anew

/** @type {import("./types.js").Board | null} */
let board = null;
let behind = 0; // [s] of this machine's clock against the server's
const marks = new Marks({ student: (id) => board && void showStudent(id, board) });
const grades = new Grades();
const causes = new Causes((students) => marks.narrow(students));

function show() {
  if (!board) return;
  document.title = `Board · ${board.title}`;
  write(byId("title"), board.title);
  const here = board.students.filter(({ room }) => room).length;
  write(byId("counted"), `${counted(board.students.length, "student")}, ${here} here`);
  marks.show(board);
  causes.show(board);
  grades.show(board.columns);
  tick();
  byId("alone").hidden = true;
  byId("main").hidden = false;
}

function tick() {
  if (board) showWaits(board.waits, Date.now() / 1000 + behind);
}

/** @param {import("./types.js").Changed} news */
function take(news) {
  if (!board) return;
  const rows = new Map(board.students.map((one) => [one.id, one]));
  for (const id of news.gone ?? []) rows.delete(id);
  for (const one of news.students ?? []) rows.set(one.id, one);
  const names = new Intl.Collator().compare;
  board = {
    ...board, now: news.now, columns: news.columns ?? board.columns, causes: news.causes ?? board.causes, waits: news.waits ?? board.waits,
    students: [...rows.values()].sort((a, b) => names(a.name, b.name)),
  };
  show();
}

async function load() {
  const answer = await fetch("/course/board/now");
  const told = await answer.json();
  if (!answer.ok) throw new Error(told.help ? `${told.text}: ${told.help}` : told.text);
  board = /** @type {import("./types.js").Board} */ (told);
  behind = (Date.parse(answer.headers.get("date") ?? "") - Date.now()) / 1000 || 0;
  show();
}

function follow() {
  const events = new EventSource("/course/board/events");
  const state = byId("link-state");
  let lost = false;
  events.addEventListener("changed", (event) => take(JSON.parse(event.data)));
  events.addEventListener("open", () => {
    write(state, "");
    state.className = "chip";
    if (lost) void load().catch(refuse); // what came meanwhile is missing
    lost = false;
  });
  events.addEventListener("error", () => {
    lost = true;
    write(state, "the server does not answer");
    state.className = "chip ended";
  });
  window.setInterval(tick, EVERY);
}

/** @param {Error} problem */
function refuse(problem) {
  byId("main").hidden = true;
  byId("alone").hidden = false;
  write(byId("alone"), `The board cannot be shown: ${problem.message}`);
}

applyTheme(chosenTheme());
void load().then(follow).catch(refuse);
void fetch("/me").then(async (answer) => {
  if (answer.ok) byId("people").hidden = !(await answer.json()).supervisor; // assistants see the board, and no list of people
});
