// The task beside the arm: what it asks for, how far that is done, what every lost point was lost by, and the things of the scene.

import { components, poseFrom } from "../../viewer/poses.js";
import { byId, figure, make, prose, write } from "../dom.js";
import { missing } from "../goal_distance.js";
import { colorOf, Goals } from "../goals.js";
import { settle } from "../focus.js";
import { isLive, look, onLive } from "../looking.js";
import { ofNow } from "../past/shown.js";
import { onSelect, select, selected } from "../selection.js";
import { Signs } from "../signs.js";

const PAUSE = 200; // between figures that change with the picture [ms]
const SHOWN = { names: "vrts names", goals: "vrts goals" }; // where it is remembered what is drawn
const UNKNOWN = "not known of this moment";
const PHONE = window.matchMedia("(max-width: 700px) and (orientation: portrait)");
const chosenBefore = sessionStorage.getItem("vrts panel"); // of this tab of the browser, before any panel is shown

/** @typedef {import("../protocol.js").TaskView} TaskView */
/** @typedef {import("../protocol.js").GoalView} GoalView */
/** @typedef {import("../../viewer/poses.js").Pose} Pose */
/** @typedef {{state: HTMLElement, earned: HTMLElement, goal: GoalView | null, check: string}} Row */

/** @param {import("../pages/room.js").App} app */
export function mountTask(app) {
  const { store, world } = app;
  const panel = byId("panel-task");
  const head = make("h2", { id: "task-title" });
  const mark = make("p", { class: "task-mark", id: "task-mark", role: "status", "aria-label": "Mark by the public checks" });
  const points = make("b");
  const total = make("span");
  mark.append(ofNow(), points, total);
  const text = make("p", { class: "task-text", tabindex: "0", role: "region", "aria-label": "What is asked for" });
  const goals = make("ul", { class: "goal-list", id: "goal-list" });
  const losses = make("tbody");
  const nothing = make("p", { class: "soft", text: "None." });
  const lostBox = make("div", { class: "lost-box", id: "lost", tabindex: "0", role: "region", "aria-label": "Points lost so far" },
    make("table", { class: "lost-list", "aria-label": "Points lost, costliest first" }, losses), nothing);
  const rules = make("ul", { class: "rule-list" });
  const asked = make("div", {}, make("div", { class: "task-head" }, head, mark), text, goals, make("h2", {}, "Points lost so far ", ofNow()), lostBox,
    make("details", { open: true, class: "other-rules" }, make("summary", { text: "What else counts" }), rules));
  const things = make("ul", { class: "thing-list", id: "thing-list" });
  const facts = make("div", { class: "thing-facts", role: "region", "aria-label": "What is selected" });
  panel.append(asked, make("h2", { text: "Things" }), things, facts,
    make("div", { class: "task-shown" },
      shown("Names in the picture", SHOWN.names, (on) => names.show(on)),
      shown("Goals in the picture", SHOWN.goals, (on) => drawn?.show(on))));

  const names = new Signs(world);
  names.show(remembered(SHOWN.names));
  /** @type {Goals | null} */
  let drawn = null;
  /** @type {Row[]} */
  let rows = [];
  /** @type {TaskView | null} */
  let task = null;
  let chosen = Boolean(chosenBefore); // whether somebody has chosen a panel, or the task was shown

  store.on(["task"], ({ task: now }) => {
    if (JSON.stringify(now) === JSON.stringify(task)) return;
    task = now;
    ask();
    draw();
  });
  world.sceneWatchers.push(draw);
  store.on(["marked", "status"], tell);
  onLive(tell);
  onSelect((name) => {
    drawn?.choose(name);
    for (const button of panel.querySelectorAll("button[data-body]")) button.setAttribute("aria-pressed", String(name !== "" && button.dataset.body === name));
    figures();
  });
  let due = 0;
  world.watchers.push((state) => {
    drawn?.follow();
    if (panel.hidden || performance.now() < due) return;
    due = performance.now() + PAUSE;
    figures(state);
  });
  document.addEventListener("panel", () => {
    chosen = true;
    figures();
  });

  /** Write what is asked for. */
  function ask() {
    asked.hidden = !task;
    byId("tab-task").textContent = task ? "Task" : "Things";
    if (!task) return;
    write(head, task.title);
    write(text, task.text);
    text.hidden = !task.text;
    rows = [];
    goals.replaceChildren(...task.goals.map((goal) => row(goal.title, goal.words, goal.check, goal.bodies[0], goal)),
      ...task.vias.map((via, index) => row(`via point ${via.name}`, (task?.ordered ? `number ${index + 1} in order: ` : "") + via.words, via.check, "", null)));
    rules.replaceChildren(...task.rules.map(({ text: words, worth }) => make("li", {}, ...prose(words), " ", make("small", { text: worth }))));
    if (!chosen && !PHONE.matches && panel.hidden) byId("tab-task").click(); // the task is what one came for
    chosen = true;
  }

  /** Return the row of one thing that is asked for. @param {string} title @param {string} words @param {string} check @param {string} body @param {GoalView | null} goal */
  function row(title, words, check, body, goal) {
    const state = make("span", { class: "state" });
    const earned = make("span", { class: "earned" });
    rows.push({ state, earned, goal, check });
    const swatch = make("span", { class: body ? "swatch" : "swatch round", "data-color": body });
    if (!body) swatch.style.setProperty("--own", "#7048e8");
    const parts = [swatch, make("span", { class: "title", text: title }), earned, make("span", { class: "asked", text: words }), state];
    return make("li", {}, body ? make("button", { type: "button", class: "goal-row", "data-body": body, click: () => toggle(body) }, ...parts) : make("div", { class: "goal-row" }, ...parts));
  }

  /** Draw goals and names anew: the scene or the task is another one. */
  function draw() {
    drawn?.dispose();
    drawn = null;
    const viewer = world.viewer;
    if (!viewer) {
      names.list(null, []);
      return;
    }
    viewer.showGoals(false); // green for all; these have the colours of their objects
    if (task) drawn = new Goals(viewer, task);
    drawn?.show(remembered(SHOWN.goals));
    drawn?.choose(selected());
    names.list(viewer, drawn?.names ?? []);
    for (const swatch of /** @type {NodeListOf<HTMLElement>} */ (panel.querySelectorAll(".swatch[data-color]"))) paint(swatch, swatch.dataset.color ?? "");
    settle(things, viewer.data.bodies.filter(({ kind }) => kind !== "floor").map(({ name }) => {
      const swatch = make("span", { class: "swatch" });
      paint(swatch, name);
      return make("li", {}, make("button", { type: "button", "data-body": name, "aria-pressed": String(name === selected()), click: () => toggle(name) }, swatch, name));
    }));
    tell();
  }

  /** @param {HTMLElement} swatch @param {string} body */
  function paint(swatch, body) {
    if (world.viewer && body) swatch.style.setProperty("--own", colorOf(world.viewer, body).getStyle());
  }

  /** Tell the mark and what is lost. */
  function tell() {
    const { marked, status } = store.now;
    const known = marked && status && status.mark !== null && status.mark !== undefined;
    write(points, known ? figure(marked.mark, 1) : "–");
    write(total, ` / ${figure(marked?.total ?? task?.total ?? 10, 1).replace(/\.0$/, "")}`);
    const lost = known ? marked.lost : [];
    nothing.hidden = !known || lost.length > 0;
    const key = JSON.stringify(lost);
    if (lostBox.dataset.key !== key) {
      lostBox.dataset.key = key;
      settle(losses, lost.map(({ points, text: why, at_s: at, kind }) => make("tr", { class: kind },
        make("td", { class: "points", text: points }), make("td", { class: "why" }, ...prose(why)), make("td", { class: "when" }, ...moment(at)))));
    }
    const parts = new Map((known ? marked.parts : []).map((part) => [part.check, part]));
    for (const { earned, check } of rows) {
      const part = parts.get(check);
      write(earned, part ? `${isLive() ? "" : "now "}${part.points} of ${part.most}` : "");
      earned.classList.toggle("whole", part?.answer === "holds");
    }
    drawn?.pass(new Set([...parts.values()].filter(({ answer }) => answer === "holds" && isLive()).map(({ check }) => check)));
    figures();
  }

  /** Tell what changes with the picture. @param {import("../../viewer/replay.js").State | null} [state] */
  function figures(state = world.state) {
    if (panel.hidden) return;
    const poseOf = (/** @type {string} */ name) => state?.bodies.get(name) ?? fixed(name);
    for (const { state: cell, goal, check } of rows) {
      const [words, there] = goal ? told(goal, poseOf, state?.held ?? []) : passed(check);
      write(cell, words.replaceAll("`", ""));
      cell.classList.toggle("there", there);
    }
    const name = selected();
    const X = name ? poseOf(name) : undefined;
    if (!X || !world.viewer) {
      if (facts.dataset.of !== "") facts.replaceChildren(make("p", { class: "soft", text: "Click a thing in the picture, or press its name here, to see where it is and where it should be." }));
      facts.dataset.of = "";
      facts.classList.remove("stays");
      return;
    }
    const [x, y, z, o, a, t] = components(X);
    const wanted = rows.filter(({ goal }) => goal?.bodies.includes(name)).map(({ goal }) => /** @type {GoalView} */ (goal));
    const values = {
      Name: name + (state?.held.includes(name) ? ", in the hand" : ""),
      Place: `${figure(x, 1)}, ${figure(y, 1)}, ${figure(z, 1)} mm`,
      "O, A, T": `${figure(o, 1)}, ${figure(a, 1)}, ${figure(t, 1)} degrees`,
      Goal: wanted.map((goal) => `${goal.title}: ${told(goal, poseOf, state?.held ?? [], name)[0]}`).join("; ") || "none",
    };
    if (facts.dataset.of !== name) facts.replaceChildren(make("dl", {}, ...Object.keys(values).flatMap((key) => [make("dt", { text: key }), make("dd")])));
    facts.dataset.of = name;
    facts.classList.add("stays");
    Object.values(values).forEach((value, index) => write(facts.querySelectorAll("dd")[index], value));
  }

  /** @param {string} name @returns {Pose | undefined} */
  function fixed(name) {
    const body = world.viewer?.data.bodies.find((one) => one.name === name);
    return body && poseFrom(body.X);
  }

  /**
   * Return how far a goal is from being reached, in words, and whether its object is there.
   * @param {GoalView} goal @param {(name: string) => Pose | undefined} poseOf @param {string[]} held @param {string} [only] the object to tell of
   * @returns {[string, boolean]}
   */
  function told(goal, poseOf, held, only) {
    if (goal.kind !== "goal") {
      if (!isLive()) return [UNKNOWN, false];
      const part = store.now.marked?.parts.find(({ check }) => check === goal.check);
      return part ? [part.text || "so it is", part.answer === "holds"] : ["", false];
    }
    const places = only ? goal.places.filter(({ body }) => body === only) : goal.places;
    const found = missing({ ...goal, places }, task?.zeroAt ?? 3, poseOf);
    if (!found) return ["", false];
    const carried = held.includes(found.place.body);
    const which = goal.places.length > 1 ? ` (${found.place.body} ${found.place.where})` : "";
    const off = [`${figure(found.positionMm, found.positionMm < 100 ? 1 : 0)} mm away`];
    if (found.orientationDeg > goal.orientationDeg) off.push(`turned by ${figure(found.orientationDeg, 0)} degrees`);
    if (found.share === 1) return [`${carried ? "in place, but still in the hand" : "in place"}, ${off[0]}${which}`, !carried];
    return [`${carried ? "in the hand, " : ""}${off.join(", ")}${which}`, false];
  }

  /** @param {string} check of a via point @returns {[string, boolean]} */
  function passed(check) {
    if (!isLive()) return [UNKNOWN, false];
    const part = store.now.marked?.parts.find((one) => one.check === check);
    return part ? [part.answer === "holds" ? "passed" : part.text || "not passed yet", part.answer === "holds"] : ["", false];
  }
}

/** Select a thing, or nothing where it is selected already. @param {string} name */
function toggle(name) {
  select(selected() === name ? "" : name);
}

/** Return the way to a moment. @param {number | null} at_s */
function moment(at_s) {
  if (at_s === null) return [];
  return [make("button", { type: "button", text: `${figure(at_s, 1)} s`, "aria-label": `${figure(at_s, 1)} s: look at this moment`, click: () => look(at_s) })];
}

/** @param {string} key */
function remembered(key) {
  return localStorage.getItem(key) !== "off";
}

/** Return a switch for something that is drawn. @param {string} text @param {string} key @param {(on: boolean) => void} show */
function shown(text, key, show) {
  const box = make("input", { type: "checkbox", change: () => {
    localStorage.setItem(key, box.checked ? "on" : "off");
    show(box.checked);
  } });
  box.checked = remembered(key);
  return make("label", { class: "check" }, box, text);
}
