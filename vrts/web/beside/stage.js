// The arm on its stage: a recording shown at a time, with lanes under the time bar.

import { Player } from "../viewer/player.js";
import { components } from "../viewer/poses.js";
import { Replay } from "../viewer/replay.js";
import { Viewer } from "../viewer/viewer.js";
import { bindControls, bindKeys, showPlaying } from "../report/controls.js";
import { sampleTimes, speed, toolPath } from "../report/curves.js";
import { Lanes, lanesOf } from "../report/lanes.js";
import { showGoals } from "./goals.js";

/** @typedef {{start: number, end: number, parts: string[], second: string, text: string, point: number[]}} Contact */
/** @typedef {{scene: import("../viewer/viewer.js").SceneData, run: any, contacts: Contact[], grazes: Contact[], doubtful: Contact[], near: Contact[], clearance: [number, number][], moment: number | null} & import("./goals.js").Times} Recording */

const byId = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const SAMPLES = 400; // of the speed in its lane
const SAME = 5e-4; // [s]

/** One replay that can be exchanged for another; view point and time stay. */
export class Stage {
  /** @param {(t: number, line: number) => void} tell called when the reader goes to another time */
  constructor(tell) {
    this.tell = tell;
    this.player = new Player(0, (t) => this.draw(t));
    /** @type {Replay | null} */
    this.replay = null;
    /** @type {Viewer | null} */
    this.viewer = null;
    /** @type {Recording | null} */
    this.data = null;
    /** @type {Lanes | null} */
    this.lanes = null;
    this.scene = "";
    this.quiet = false; // what is shown now was asked for by the editor
    /** @type {(t: number, state: import("../viewer/replay.js").State) => void} */
    this.shown = () => {}; // called whenever another time is shown
    const slider = /** @type {HTMLInputElement} */ (byId("time"));
    this.slider = slider;
    const jump = (/** @type {number} */ t) => this.jump(t);
    const events = { before: (/** @type {number} */ t) => this.event(t, -1), after: (/** @type {number} */ t) => this.event(t, 1) };
    /** @type {any} */
    const viewer = new Proxy({}, { get: (_, name) => (/** @type {any[]} */ ...rest) => /** @type {any} */ (this.viewer)?.[name](...rest) });
    bindControls(this.player, viewer, /** @type {any} */ (events), jump);
    bindKeys(this.player, /** @type {any} */ (events), jump);
    new MutationObserver(() => this.viewer?.setTheme(theme())).observe(document.body, { attributeFilter: ["class"] });
  }

  /**
   * Show another recording, at the same time as before.
   * @param {Recording} data
   * @param {number | null} t [s]; null: where it stands, or at the moment of what went wrong
   */
  async take(data, t) {
    const replay = await Replay.unpack(data.scene.robot.arm, data.run);
    const first = this.data === null;
    this.data = data;
    this.replay = replay;
    this.takeScene(data.scene);
    this.player.playing = false;
    this.player.end = replay.end;
    this.slider.max = String(replay.end);
    const times = sampleTimes(replay);
    const touching = (/** @type {number} */ i) => data.contacts.some((c) => c.start <= times[i] && times[i] <= c.end);
    this.viewer?.setTrace(toolPath(replay, times), touching);
    this.viewer?.showTrace(/** @type {HTMLInputElement} */ (byId("show-trace")).checked);
    this.viewer?.showGoals(/** @type {HTMLInputElement} */ (byId("show-goals")).checked);
    byId("goals-check").hidden = !data.scene.goals.length && !data.scene.vias.length;
    const box = byId("lanes");
    const fresh = /** @type {HTMLElement} */ (box.cloneNode(false)); // without whom the lanes before told
    box.replaceWith(fresh);
    this.lanes = new Lanes(fresh, [...lanesOf(replay, data), { name: "Speed", curve: speeds(replay) }], replay.end, (at) => this.jump(at));
    this.stand(t ?? (first ? data.moment ?? 0 : Math.min(this.player.t, replay.end)));
  }

  /** Put up a scene, with the view point of the one before. @param {import("../viewer/viewer.js").SceneData} scene */
  takeScene(scene) {
    const key = JSON.stringify(scene);
    if (key === this.scene) return;
    this.scene = key;
    const before = this.viewer;
    let canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
    if (before) {
      before.dispose();
      const next = /** @type {HTMLCanvasElement} */ (canvas.cloneNode(false));
      canvas.replaceWith(next);
      canvas = next;
    }
    this.viewer = opened(canvas, scene);
    byId("no-view").hidden = this.viewer !== null;
    canvas.hidden = this.viewer === null;
    if (!before) this.viewer?.look("overview"); // again: now the shape of its place is known
    if (!before || !this.viewer) return;
    this.viewer.camera.position.copy(before.camera.position);
    this.viewer.controls.target.copy(before.controls.target);
    this.viewer.following = before.following;
    this.viewer.controls.update();
  }

  /** Stand at a time because the editor says so; the editor is not told. @param {number} t [s] */
  stand(t) {
    this.player.playing = false;
    this.quiet = true;
    this.player.seek(t);
    this.quiet = false;
  }

  /** Go to a time because the reader says so. @param {number} t [s] */
  jump(t) {
    this.player.playing = false;
    this.player.seek(t);
  }

  /**
   * Stand where a line of the program is at work first; return whether it ever is.
   * @param {number} line
   */
  standAtLine(line) {
    const row = this.replay?.run.lines.find(([, at]) => at === line);
    if (row) this.stand(row[0]);
    return row !== undefined;
  }

  /** Return the time of the next event, or of the one before. @param {number} t [s] @param {number} way 1 or -1 */
  event(t, way) {
    const { run, contacts = [] } = this.data ?? {};
    const times = [...(run?.events ?? []).map((/** @type {{t: number}} */ one) => one.t), ...contacts.map((c) => c.start)].sort((a, b) => a - b);
    const found = way > 0 ? times.find((at) => at > t + 2 * SAME) : times.findLast((at) => at < t - 2 * SAME);
    return found ?? (way > 0 ? t : 0);
  }

  /** Show everything at a time. @param {number} t [s] */
  draw(t) {
    const { replay, data } = this;
    if (!replay || !data) return;
    const state = replay.at(t);
    const now = (/** @type {Contact[]} */ rows) => rows.filter((c) => c.start - SAME <= t && t <= c.end + SAME);
    const [touching, close] = [now(data.contacts), now([...data.grazes, ...data.doubtful, ...data.near])];
    this.viewer?.show(state);
    this.viewer?.highlight(mark(touching, data.scene));
    this.shown(t, state);
    this.slider.value = String(t);
    this.slider.setAttribute("aria-valuetext", `${t.toFixed(1)} seconds`);
    byId("clock").textContent = `${t.toFixed(3).padStart(7)} / ${replay.end.toFixed(1)} s`;
    this.lanes?.show(t);
    showPlaying(this.player);
    const goals = showGoals(this.viewer, data, t);
    if (goals.count) byId("goals-check").lastChild?.replaceWith(` goals ${goals.reached} of ${goals.count}`);
    showOverlay(touching, close, state.held, goals.said);
    showStatus(state, speed(replay, t));
    if (!this.quiet) this.tell(t, replay.line(t));
  }
}

/** Return the theme of the editor. @returns {"dark" | "light"} */
function theme() {
  const { classList } = document.body;
  return classList.contains("vscode-light") || classList.contains("vscode-high-contrast-light") ? "light" : "dark";
}

/** @param {HTMLCanvasElement} canvas @param {import("../viewer/viewer.js").SceneData} scene @returns {Viewer | null} null without WebGL */
function opened(canvas, scene) {
  const probe = document.createElement("canvas").getContext("webgl2");
  if (!probe) return null;
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  return new Viewer(canvas, scene, theme());
}

/** Return what glows: bodies that touch, and the hand where a part is one of the robot. @param {Contact[]} touching @param {{bodies: {name: string}[]}} scene */
function mark(touching, scene) {
  if (!touching.length) return null;
  const known = new Set(scene.bodies.map((body) => body.name));
  const parts = touching.flatMap((c) => c.parts);
  return {
    bodies: [...parts, ...touching.map((c) => c.second)].filter((name) => known.has(name)),
    robot: parts.some((name) => !known.has(name)),
    point: touching[0].point,
  };
}

/** @param {Contact[]} touching @param {Contact[]} close @param {string[]} held @param {string[]} goals that are lost or missed */
function showOverlay(touching, close, held, goals) {
  const rows = [...goals.map((text) => ["bad", text]), ...touching.map((c) => ["bad", c.text]), ...close.map((c) => ["warn", c.text]), ...held.map((name) => ["", `holds ${name}`])];
  byId("overlay").replaceChildren(...rows.map(([kind, text]) => {
    const row = document.createElement("span");
    row.className = kind;
    row.textContent = text;
    return row;
  }));
}

/** @param {import("../viewer/replay.js").State} state @param {number} velocity [mm/s] */
function showStatus(state, velocity) {
  const number = (/** @type {number} */ value, /** @type {number} */ decimals) => (value + 0).toFixed(decimals).replace(/^-(0\.?0*)$/, "$1").replace("-", "−");
  const [x, y, z, o, a, t] = components(state.X_WT);
  byId("joints").textContent = `${Array.from(state.q.subarray(0, 6), (q) => number((q * 180) / Math.PI, 2)).join("  ")} deg`;
  byId("tool").textContent = `${[x, y, z].map((v) => number(v, 1)).join("  ")} mm  ${[o, a, t].map((v) => number(v, 2)).join("  ")} deg`;
  byId("hand").textContent = `${number(state.q[6] * 1000, 1)} mm open; tool at ${number(velocity, 0)} mm/s`;
}

/** Return the speed of the tool as shares of the largest. @param {Replay} replay @returns {[number, number][]} */
function speeds(replay) {
  const rows = Array.from({ length: SAMPLES + 1 }, (_, i) => {
    const t = (i / SAMPLES) * replay.end;
    return /** @type {[number, number]} */ ([t, speed(replay, t)]);
  });
  const most = Math.max(...rows.map(([, value]) => value), 1e-9);
  return rows.map(([t, value]) => [t, value / most]);
}
