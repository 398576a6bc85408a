// The grading desk: puts the parts together, and fetches the class.

import { button, byId, make, write } from "../live/dom.js";
import { inText } from "../live/names.js";
import { nextOpen } from "./filters.js";
import { Desk } from "./desk.js";
import { Replay } from "./frame.js";
import { bindKeys, leave, showKeys } from "./keys.js";
import { WorkList } from "./list.js";
import { Notes } from "./notes.js";
import { settings } from "./settings.js";
import { capital, counted } from "./words.js";
import { ByHand, finish, Student } from "./work/by_hand.js";
import { Comments } from "./work/comments.js";
import { Head } from "./work/head.js";
import { Reasons } from "./work/reasons.js";
import { Rubric } from "./work/rubric.js";
import { Source } from "./work/source.js";
import { tabs } from "./work/tabs.js";
import { Causes } from "./views/causes.js";
import { Conflicts } from "./views/conflicts.js";
import { StatisticsView } from "./views/statistics.js";

const VIEWS = /** @type {const} */ (["work", "conflicts", "causes", "statistics"]);

const desk = new Desk(new Notes(byId("notes")));
const replay = new Replay(desk);
const list = new WorkList(desk);
new Head(desk, () => void finish(desk));
const source = new Source(desk, replay);
const comments = new Comments(desk, replay);
const causes = new Causes(desk);
new Reasons(desk, replay, source, (cause) => causes.open(cause));
const rubric = new Rubric(desk);
const hand = new ByHand(desk);
const student = new Student(desk);
const decide = tabs("Decide", [["rubric", "Rubric", rubric.panel], ["hand", "By hand", hand.panel], ["student", "Student", student.panel]]);
byId("decide").append(decide.bar, ...decide.panels);
new Conflicts(desk);
new StatisticsView(desk, (cause) => causes.open(cause));
settings(desk);
bindViews();
bindPanes();
bindKeys({
  desk, replay,
  item: (key) => rubric.press(key),
  comment: () => {
    pane("source");
    comments.write();
  },
  hand: () => {
    pane("decide");
    decide.choose("hand");
    hand.value.focus();
  },
  newItem: () => {
    pane("decide");
    decide.choose("rubric");
    rubric.edit(null);
    rubric.title.focus();
  },
  lines: () => {
    pane("source");
    source.enter();
  },
  reasons: () => {
    pane("reasons");
    byId("tab-lost").focus();
  },
  student: () => {
    pane("decide");
    decide.choose("student");
    student.first.focus();
  },
  causes: () => {
    causes.open(desk.view === "work" ? (desk.row?.causes[0] ?? "") : "");
    leave(desk);
  },
  finish: () => void finish(desk),
  search: () => {
    pane("list");
    list.search?.focus();
    list.search?.select();
  },
});
byId("trouble").addEventListener("click", tellProblems);
byId("keys-button").addEventListener("click", showKeys);
desk.on(["class", "link"], showTop);
desk.on(["marking"], showMarking);
desk.on(["chosen"], remember);
desk.on(["detail"], lookAhead);
void begin();

async function begin() {
  try {
    await desk.begin();
  } catch (problem) {
    desk.failed(problem, () => void begin());
    return;
  } finally {
    document.body.classList.remove("waiting");
  }
  const asked = decodeURIComponent(location.hash.match(/^#s=(.+)$/)?.[1] ?? "");
  const first = desk.rows.get(asked) ?? nextOpen([...desk.rows.values()], undefined, desk.me) ?? desk.listed[0];
  if (first) await desk.choose(first.id);
}

/** Ask for the rows that are likely wanted next, when the page is at rest. */
function lookAhead() {
  const { listed } = desk;
  const after = listed[listed.findIndex((row) => row.id === desk.chosen) + 1];
  window.setTimeout(() => {
    desk.askAhead(nextOpen([...desk.rows.values()], desk.row, desk.me)?.id);
    desk.askAhead(after?.id);
  }, 400);
}

/** The address says which row is looked at: a reload comes back to it. */
function remember() {
  history.replaceState(null, "", `#s=${encodeURIComponent(desk.chosen)}`);
}

function showTop() {
  const { data, online } = desk;
  if (data) {
    write(byId("title"), data.title);
    document.title = `${data.title} · grading desk`;
    write(byId("me"), inText(data.me.name || data.me.id));
    const problems = data.problems ?? [];
    if (problems.join() !== showTop.told) {
      showTop.told = problems.join();
      tellProblems();
    }
    const trouble = byId("trouble");
    trouble.hidden = !problems.length;
    write(trouble, counted(problems.length, "problem"));
  }
  const state = byId("link-state");
  write(state, online ? "" : "no answer from the desk");
  state.className = online ? "chip" : "chip ended";
}

showTop.told = "";

/** Say what is wrong with files; the button in the bar says it again. */
function tellProblems() {
  const problems = desk.data?.problems ?? [];
  tellProblems.note?.remove(); // what it says is over, or said anew
  if (problems.length) tellProblems.note = desk.notes.problem(problems.length === 1 ? "There is a problem with the files of this marking:" : "There are problems with the files of this marking:", problems.map(capital));
}

/** @type {HTMLElement | null} */
tellProblems.note = null;

function showMarking() {
  const place = byId("marking");
  const marking = desk.data?.marking;
  if (marking?.running) {
    const bar = place.querySelector("progress") ?? make("progress", { "aria-label": "Programs marked again" });
    bar.max = Math.max(marking.all, 1);
    bar.value = marking.done;
    if (!bar.parentElement) place.replaceChildren(bar, make("span", { class: "soft" }), button("Stop", () => void desk.stopMarking(), { title: "Stop marking: what has been marked stays" }));
    write(/** @type {Element} */ (place.children[1]), `${marking.done} of ${marking.all} marked`);
  } else {
    if (place.firstChild && !marking?.problem) desk.notes.done(`Marked again: ${marking?.done ?? 0} of ${marking?.all ?? 0}.`);
    place.replaceChildren();
    if (marking?.problem && marking.problem !== showMarking.told) desk.notes.problem(`Marking again did not work: ${marking.problem}`);
    showMarking.told = marking?.problem ?? "";
  }
}
showMarking.told = "";

function bindViews() {
  const heads = /** @type {HTMLElement[]} */ ([...byId("views").querySelectorAll("[data-go]")]);
  for (const head of heads) head.addEventListener("click", () => desk.show(/** @type {import("./desk.js").View} */ (head.dataset.go)));
  desk.on(["view"], () => {
    document.body.dataset.view = desk.view;
    for (const view of VIEWS) byId(`view-${view}`).hidden = view !== desk.view;
    for (const head of heads) {
      if (head.dataset.go === desk.view) head.setAttribute("aria-current", "page");
      else head.removeAttribute("aria-current");
    }
  });
}

/** On a small screen one part is shown at a time. @param {string} name */
function pane(name) {
  document.body.dataset.pane = name;
  for (const one of /** @type {HTMLElement[]} */ ([...byId("panes").querySelectorAll("[data-to]")])) one.setAttribute("aria-pressed", String(one.dataset.to === name));
}

function bindPanes() {
  for (const one of /** @type {HTMLElement[]} */ ([...byId("panes").querySelectorAll("[data-to]")])) one.addEventListener("click", () => pane(one.dataset.to ?? "list"));
  pane("list");
  byId("list").addEventListener("click", () => pane("reasons"));
}
