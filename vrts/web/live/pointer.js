// The virtual pointer: a ghost gripper on an arrow says where the tool is to go, and Go sends it there.

import { Vector3 } from "three";
import { compose, identity } from "../viewer/poses.js";
import { PointerDrag } from "./pointer_drag.js";
import { PointerFigure } from "./pointer_figure.js";
import { PointerPanel } from "./pointer_panel.js";
import { aligned, along, numbersOf, pointerAt, shifted, tip, turned, withBase, withNumbers, withTip } from "./pointer_pose.js";
import { ReachAsker } from "./pointer_reach.js";
import { DragNote } from "./pointing/note.js";

/** @typedef {import("./pointer_pose.js").PointerPose} PointerPose */
/** @typedef {import("./pointer_pose.js").Vector} Vector */
/** @typedef {import("../viewer/replay.js").State} State */

const AWAY = "the picture does not show what is now: ways begin where the arm is now";
const LENGTH = 0.2; // of the arrow at first [m]
const TOUCHED = 0.06; // [m] opening of the ghost where the hand's own is smaller

/**
 * @typedef {object} Surroundings
 * @property {import("../viewer/viewer.js").Viewer} viewer
 * @property {HTMLElement} panel is filled
 * @property {() => Pick<State, "X_WT"|"X_WF"|"q"> | null} state that is shown now
 * @property {() => boolean} [past] whether something else than what is now is shown: ways begin at what is now
 * @property {(question: import("./pointer_reach.js").Question) => Promise<import("./pointer_reach.js").Reached>} ask
 * @property {(action: {type: "go", position_m: number[], oat_rad: number[], straight: boolean}) => Promise<any>} go
 *   rejects with what to say when it is refused
 */

/** One pointer in one view. */
export class VirtualPointer {
  /** @param {Surroundings} surroundings */
  constructor({ viewer, panel, state, ask, go, past = () => false }) {
    this.viewer = viewer;
    this.state = state;
    this.past = past;
    this.send = go;
    /** @type {PointerPose} */
    this.pose = pointerAt(identity(), LENGTH);
    /** @type {1|2} */
    this.stage = 1;
    this.straight = false;
    this.visible = false;
    this.wanted = true; // where its tab is open
    this.fresh = true; // never shown: begins at the gripper
    this.figure = new PointerFigure(viewer.data, viewer.camera, viewer.canvas);
    this.figure.visible = false;
    viewer.scene.add(this.figure);
    this.asker = new ReachAsker(ask, (answer) => this.showReach(answer));
    this.panel = new PointerPanel(panel, {
      type: (numbers) => this.change(withNumbers(this.pose, numbers)),
      stage: (stage) => this.setStage(stage),
      align: () => this.change(aligned(this.pose)),
      snap: () => this.snap(),
      along: (distance) => this.change(along(this.pose, distance)),
      turn: (angle) => this.change(turned(this.pose, angle)),
      shift: (end, seen) => this.shift(end, this.inWorld(seen)),
      straight: (straight) => this.setStraight(straight),
      show: (on) => {
        this.wanted = on;
        this.show(on);
      },
      go: () => void this.go(),
    });
    this.note = new DragNote();
    this.drag = new PointerDrag({
      canvas: viewer.canvas, camera: viewer.camera, figure: this.figure,
      now: () => ({ pose: this.pose, stage: this.stage }),
      steps: () => ({ m: this.panel.distance, rad: this.panel.angle }),
      change: (pose) => this.change(pose),
      grab: (handle) => { viewer.controls.enabled = handle === null; },
      tell: (text, at) => this.note.tell(text, at),
    });
    this.panel.showStage(1);
    this.panel.showVisible(false);
    this.panel.showNumbers(numbersOf(this.pose));
    this.enable(true, "");
  }

  /** @param {boolean} on whether the pointer is in the scene */
  show(on) {
    this.visible = this.figure.visible = on;
    this.panel.showVisible(on);
    if (on && this.fresh) this.snap();
    if (on) this.change(this.pose);
    else this.asker.stop();
    this.viewer.requestDraw();
  }

  /** Allow Go, or say why not. @param {boolean} on @param {string} [why] */
  enable(on, why = "") {
    this.panel.enableGo(on, why);
  }

  /** Put the pointer where the gripper is. */
  snap() {
    const now = this.state();
    if (!now) return;
    this.fresh = false;
    this.change(pointerAt(now.X_WT, this.pose.length));
  }

  /** Ask again: the arm stands elsewhere, so the answer may be another one. */
  askAgain() {
    if (this.visible) this.inquire();
  }

  /** Ask for the way from where the arm is now; beside another picture it would mislead. */
  inquire() {
    if (!this.past()) {
      this.asker.want(this.question());
      return;
    }
    this.asker.stop();
    this.showReach({ state: "unknown", text: AWAY, reached: null });
  }

  /** @param {PointerPose} pose */
  change(pose) {
    this.pose = pose;
    this.fresh = false;
    this.figure.visible = this.visible = this.wanted = true;
    this.panel.showVisible(true);
    this.panel.showNumbers(numbersOf(pose));
    this.panel.say("");
    this.draw();
    this.inquire();
  }

  /** @param {1|2} stage place the arrow, or turn the gripper about it */
  setStage(stage) {
    this.stage = stage;
    this.panel.showStage(stage);
    this.draw();
  }

  /** @param {boolean} straight along a line, or joint-interpolated */
  setStraight(straight) {
    this.straight = straight;
    this.askAgain();
  }

  /** Move one end, or the whole. @param {"base"|"tip"|"hand"} end @param {Vector} by [m] */
  shift(end, by) {
    const moved = (/** @type {Vector} */ from) => /** @type {Vector} */ (from.map((n, i) => n + by[i]));
    if (end === "hand") this.change(shifted(this.pose, by));
    else if (end === "tip") this.change(withTip(this.pose, moved(tip(this.pose))));
    else this.change(withBase(this.pose, moved(this.pose.point)));
  }

  /** Send the arm to the pointer. */
  async go() {
    this.panel.say("");
    try {
      await this.send({ type: "go", ...this.question() });
    } catch (problem) {
      this.panel.say(problem instanceof Error ? problem.message : String(problem));
    }
  }

  /** @returns {import("./pointer_reach.js").Question} */
  question() {
    const [, , , o, a, t] = numbersOf(this.pose);
    return {
      position_m: [...this.pose.point],
      oat_rad: [o, a, t].map((degrees) => (degrees * Math.PI) / 180),
      straight: this.straight,
    };
  }

  /** @param {import("./pointer_reach.js").Answer} answer */
  showReach(answer) {
    this.panel.showReach(answer);
    if (answer.state === "asking") return; // the colour of the answer before stays until the next
    this.figure.showWay(answer);
    this.viewer.requestDraw();
  }

  /** Draw the pointer as it is. */
  draw() {
    const now = this.state();
    const X_TF = now ? compose(inverse(now.X_WT), now.X_WF) : identity();
    this.figure.draw(this.pose, X_TF, Math.max(now ? now.q[6] : 0, TOUCHED), this.stage);
    this.viewer.requestDraw();
  }

  /**
   * Return a shift as it is seen, along the axes of the world that come nearest.
   * @param {number[]} seen to the right, away, up [m] @returns {Vector}
   */
  inWorld([right, away, up]) {
    const ahead = this.viewer.camera.getWorldDirection(new Vector3());
    const quarter = Math.round(Math.atan2(ahead.y, ahead.x) / (Math.PI / 2)) * (Math.PI / 2);
    const [c, s] = [Math.round(Math.cos(quarter)), Math.round(Math.sin(quarter))];
    return [away * c + right * s, away * s - right * c, up];
  }

  /** Take the pointer out of the view and empty its panel. */
  dispose() {
    this.asker.stop();
    this.drag.dispose();
    this.note.remove();
    this.figure.dispose();
    this.panel.box.remove();
    this.viewer.controls.enabled = true;
    this.viewer.requestDraw();
  }
}

/** @param {import("../viewer/poses.js").Pose} X @returns {import("../viewer/poses.js").Pose} */
function inverse(X) {
  const Y = identity();
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 3; column++) Y[row + 4 * column] = X[column + 4 * row];
    Y[12 + row] = -(X[4 * row] * X[12] + X[4 * row + 1] * X[13] + X[4 * row + 2] * X[14]);
  }
  return Y;
}
