// The report page: one replay, shown by the viewer, the program, the events and the charts alike.

import { components } from "../viewer/poses.js";
import { Player } from "../viewer/player.js";
import { Replay } from "../viewer/replay.js";
import { Viewer } from "../viewer/viewer.js";
import { Charts } from "./charts.js";
import { Comments, ofPage } from "./comments.js";
import { toldComments } from "./comments_read.js";
import { charts, sampleTimes, speed, toolPath } from "./curves.js";
import { EventList } from "./events.js";
import { obeyDesk } from "./in_desk.js";
import { Lanes, lanesOf } from "./lanes.js";
import { drawSnapshots } from "./snapshots.js";
import { voiceLanes } from "./voices.js";
import { bindKeys, bindControls, showPlaying } from "./controls.js";

const byId = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const LEAD = 0.6; // "watch" starts this much before the moment [s]

const which = new URLSearchParams(location.hash.slice(1)).get("future"); // of a page with several runs
const data = JSON.parse((document.getElementById(`data-${which}`) ?? byId("data")).textContent ?? "{}");
const replay = await Replay.unpack(data.scene.robot.arm, data.run);
const dark = matchMedia("(prefers-color-scheme: dark)");
const theme = () => (dark.matches ? "dark" : "light");
const viewer = openViewer();
const slider = /** @type {HTMLInputElement} */ (byId("time"));
const player = new Player(replay.end, show);
const events = new EventList(byId("events"), data, (t) => jump(t));
const times = sampleTimes(replay);
const path = toolPath(replay, times);
const plots = new Charts(byId("chart-list"), times, charts(replay, times, path, data.clearance), data.contacts, (t) => jump(t));
const lanes = new Lanes(byId("lanes"), [...lanesOf(replay, data), ...voiceLanes(data.voices)], replay.end, (t) => jump(t));
/** @type {Record<string, HTMLElement | null>} */
const lit = { lit: null, "lit-process": null };
const comments = new Comments({ jump, watch, end: replay.end });
const tellDesk = obeyDesk({ show: jump, showLine: jumpToLine, comment: (told) => say(toldComments(told)), end: replay.end });

slider.max = String(replay.end);
viewer?.setTrace(path, (i) => data.contacts.some((/** @type {Contact} */ c) => c.start <= times[i] && times[i] <= c.end));
byId("goals-check").hidden = !data.scene.goals.length && !data.scene.vias.length;
dark.addEventListener("change", () => viewer?.setTheme(theme()));
bindControls(player, viewer, events, jump);
bindKeys(player, events, jump);
const program = document.getElementById("source");
program?.setAttribute("title", "Double-click a line to go to the time when it runs");
program?.addEventListener("dblclick", (event) => {
  const line = /** @type {HTMLElement} */ (event.target).closest("li")?.id.slice(1);
  if (line) jumpToLine(Number(line));
});
for (const button of document.querySelectorAll("button.seek")) {
  button.addEventListener("click", () => watch(Number(/** @type {HTMLElement} */ (button).dataset.t)));
}
if (viewer) drawSnapshots(viewer, replay, data.contacts, mark);
say(ofPage());
jump(askedTime() ?? data.moment ?? 0);
addEventListener("hashchange", () => {
  const t = askedTime();
  if (t !== null) jump(t);
});

/** @typedef {{start: number, end: number, first: string, second: string, parts: string[], text: string, point: number[], deepest: number, held: string | null, line: number}} Contact */

/** @returns {Viewer | null} null where the browser has no WebGL */
function openViewer() {
  const canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
  const probe = document.createElement("canvas").getContext("webgl2");
  if (!probe) {
    byId("no-view").hidden = false;
    canvas.hidden = true;
    return null;
  }
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  return new Viewer(canvas, data.scene, theme());
}

/** What the page's address asks for, as page.html#t=3.2. @returns {number | null} a time of the run [s]; null: nothing */
function askedTime() {
  const asked = new URLSearchParams(location.hash.slice(1)).get("t");
  return asked === null ? null : Math.min(Math.max(Number(asked) || 0, 0), replay.end);
}

/** Stand still at a time. */
function jump(/** @type {number} */ t) {
  player.playing = false;
  player.seek(t);
}

/** Show what graders say, and nothing else of them. @param {import("./comments_read.js").Comment[]} said */
function say(said) {
  comments.set(said);
  events.comment(comments.timed);
  show(player.t);
}

/** Go to the next time a line of the program is at work. */
function jumpToLine(/** @type {number} */ line) {
  const times = data.run.lines.filter((/** @type {[number, number]} */ row) => row[1] === line).map((/** @type {[number, number]} */ row) => row[0]);
  if (times.length) jump(times.find((/** @type {number} */ t) => t > player.t + 1e-3) ?? times[0]);
}

/** Show a moment from shortly before, playing, with the replay on screen. */
function watch(/** @type {number} */ t) {
  byId("replay").scrollIntoView();
  byId("stage").focus({ preventScroll: true });
  jump(Math.max(0, t - LEAD));
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) jump(t);
  else player.play(1);
}

/** Show everything at a time. */
function show(/** @type {number} */ t) {
  const state = replay.at(t);
  viewer?.show(state);
  const touching = data.contacts.filter((/** @type {Contact} */ c) => c.start <= t && t <= c.end);
  const close = [...data.grazes, ...data.doubtful, ...data.near].filter((/** @type {Contact} */ c) => c.start <= t && t <= c.end);
  viewer?.highlight(mark(touching));
  slider.value = String(t);
  slider.setAttribute("aria-valuetext", `${t.toFixed(1)} seconds`);
  byId("clock").textContent = `${t.toFixed(3).padStart(7)} / ${replay.end.toFixed(1)} s`;
  showOverlay(state, touching, close);
  showStatus(state);
  lightLine("lit-process", replay.line(t, data.run.processLines));
  lightLine("lit", replay.line(t));
  lanes.show(t);
  comments.show(t, player);
  events.show(t);
  plots.show(t);
  tellDesk(t, replay.line(t));
  showPlaying(player);
}

/**
 * Name what touches: the parts that are bodies; the hand where a part is one of the robot.
 * @param {Contact[]} touching @returns {import("../viewer/viewer.js").Mark | null}
 */
function mark(touching) {
  if (!touching.length) return null;
  const known = new Set(data.scene.bodies.map((/** @type {{name: string}} */ body) => body.name));
  const parts = touching.flatMap((c) => c.parts);
  return {
    bodies: [...parts, ...touching.map((c) => c.second)].filter((name) => known.has(name)),
    robot: parts.some((name) => !known.has(name)),
    point: touching[0].point,
  };
}

/** @param {import("../viewer/replay.js").State} state @param {Contact[]} touching @param {Contact[]} close */
function showOverlay(state, touching, close) {
  const rows = [
    ...touching.map((c) => ["bad", c.text]),
    ...close.map((c) => ["warn", c.text]),
    ...state.held.map((name) => ["", `holds ${name}`]),
  ];
  byId("overlay").replaceChildren(...rows.map(([kind, text]) => {
    const row = document.createElement("span");
    row.className = kind;
    row.textContent = text;
    return row;
  }));
}

/** @param {import("../viewer/replay.js").State} state */
function showStatus(state) {
  const number = (/** @type {number} */ value, /** @type {number} */ width, /** @type {number} */ decimals) =>
    (value + 0).toFixed(decimals).replace(/^-(0\.?0*)$/, "$1").replace("-", "−").padStart(width);
  const joints = Array.from(state.q.subarray(0, 6), (q) => number((q * 180) / Math.PI, 8, 2));
  byId("joints").textContent = `${joints.join(" ")} deg`;
  const [x, y, z, o, a, t] = components(state.X_WT);
  const tool = [number(x, 8, 1), number(y, 8, 1), number(z, 8, 1), number(o, 8, 2), number(a, 8, 2), number(t, 8, 2)];
  byId("tool").textContent = `${tool.join(" ")}  X Y Z mm, O A T deg`;
  byId("hand").textContent = `${number(state.q[6] * 1000, 8, 1)} mm open${state.held.length ? `, holds ${state.held.join(", ")}` : ""};` +
    ` tool at ${number(speed(replay, state.t), 1, 0)} mm/s`;
}

/**
 * Light the line at work; the process control program has a colour of its own.
 * @param {string} kind @param {number} line
 */
function lightLine(kind, line) {
  const before = lit[kind];
  const next = line ? document.getElementById(`L${line}`) : null;
  if (next === before) return;
  before?.classList.remove(kind);
  if (kind === "lit") before?.removeAttribute("aria-current");
  lit[kind] = next;
  if (!next) return;
  next.classList.add(kind);
  if (kind !== "lit") return;
  next.setAttribute("aria-current", "step");
  const box = /** @type {HTMLElement} */ (next.parentElement);
  const above = next.offsetTop - box.scrollTop;
  if (above < 40 || above > box.clientHeight - 60) box.scrollTop = next.offsetTop - box.clientHeight / 2;
}

// For tests and for the curious: the replay and what shows it.
Object.assign(window, { vrts: { replay, player, viewer } });
