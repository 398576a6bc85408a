// Another future of the debugger, drawn translucent at the same time as the present one.

import { Group, LineSegments, Mesh, MeshBasicMaterial } from "three";
import { RobotFigure, ghost, place } from "../viewer/figures.js";
import { Replay } from "../viewer/replay.js";

/** @typedef {import("../viewer/replay.js").State} State */
/** @typedef {import("../viewer/viewer.js").Viewer} Viewer */
/** @typedef {{number: number, label: string, words: string, took: number, present: number, run: import("../viewer/replay.js").RunData}} Other a future; how long it takes, and the present one [s] */

const COLOR = 0xf08c00;
const SAME = 1e-4; // [rad, m] nearer than this nothing is to be told apart

/** The other future of one panel. */
export class Ghost {
  constructor() {
    /** @type {Replay | null} */
    this.replay = null;
    /** @type {Other | null} */
    this.other = null;
    /** @type {Viewer | null} */
    this.viewer = null;
    this.group = new Group();
    /** @type {RobotFigure | null} */
    this.robot = null;
    /** @type {Map<string, Group>} */
    this.bodies = new Map();
  }

  /** Be drawn in another viewer. @param {Viewer | null} viewer */
  over(viewer) {
    if (this.viewer === viewer) return;
    this.viewer = viewer;
    this.group = new Group();
    this.group.visible = false;
    this.bodies.clear();
    this.robot = null;
    viewer?.scene.add(this.group);
  }

  /** Take a future; null takes it away. @param {Other | null} other */
  async take(other) {
    this.other = other;
    this.replay = other && this.viewer ? await Replay.unpack(this.viewer.data.robot.arm, other.run) : null;
    if (!this.replay) this.group.visible = false;
    this.viewer?.requestDraw();
  }

  /**
   * Show the other future at a time; return how far both tools are apart [m], or null where there is none.
   * @param {number} t [s] @param {State} present
   * @returns {number | null}
   */
  show(t, present) {
    const { replay, viewer, group } = this;
    if (!replay || !viewer) return null;
    const state = replay.at(Math.min(t, replay.end));
    const arm = state.q.some((q, k) => Math.abs(q - present.q[k]) > SAME);
    this.robot ??= this.built(viewer);
    this.robot.group.visible = arm;
    this.robot.show(state);
    for (const [name, X] of state.bodies) {
      const before = present.bodies.get(name);
      const away = before !== undefined && X.some((x, k) => Math.abs(x - before[k]) > SAME);
      if (away && !this.bodies.has(name)) this.build(name, X);
      const figure = this.bodies.get(name);
      if (!figure) continue;
      figure.visible = away;
      place(figure, X);
    }
    group.visible = true;
    viewer.requestDraw();
    return Math.hypot(...[12, 13, 14].map((k) => state.X_WT[k] - present.X_WT[k]));
  }

  /** @param {Viewer} viewer */
  built(viewer) {
    const figure = new RobotFigure(viewer.data.robot);
    const skin = new MeshBasicMaterial({ color: COLOR, transparent: true, opacity: 0.34 });
    figure.group.traverse((part) => {
      if (part instanceof LineSegments) part.visible = false;
      else if (part instanceof Mesh) {
        part.material = skin;
        part.castShadow = part.receiveShadow = false;
        part.renderOrder = 5;
      }
    });
    this.group.add(figure.group);
    return figure;
  }

  /** @param {string} name of a body @param {import("../viewer/poses.js").Pose} X */
  build(name, X) {
    const body = this.viewer?.data.bodies.find((one) => one.name === name);
    if (!body) return;
    const figure = ghost(body, X, COLOR);
    this.bodies.set(name, figure);
    this.group.add(figure);
  }
}
