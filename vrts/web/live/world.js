// The 3D world of a room: the viewer of the reports, fed by frames.

import { armFrames } from "../viewer/kinematics.js";
import { compose, identity, poseFrom } from "../viewer/poses.js";
import { FIELD_OF_VIEW } from "../viewer/views.js";
import { Viewer } from "../viewer/viewer.js";
import { worked } from "./layout/corners.js";
import { aimed } from "./layout/framing.js";
import { isLive } from "./looking.js";
import { Motion } from "./motion.js";
import { carried } from "./still/carried.js";
import { endStill } from "./still/ended.js";
import { onTheme, theme } from "./themes.js";

const AFTERGLOW = 2.5; // how long a contact stays lit after its end, or after it was heard of [s]
const LATER = 2_000; // after the first picture reflections are worked out [ms]

/** @typedef {import("../viewer/replay.js").State} State */
/** @typedef {import("../viewer/viewer.js").SceneData} SceneData */
/** @typedef {{state: State, outputs: number, flags: number}} Seen */
/** @typedef {{seen: () => Seen | null, contacts: import("./protocol.js").Contact[], near: import("./protocol.js").Contact[]}} Instead */

/** Shows what the last frames say, at the screen's own rate. */
export class World {
  /** @param {HTMLCanvasElement} canvas @param {import("./bodies.js").Bodies} bodies */
  constructor(canvas, bodies) {
    this.canvas = canvas;
    this.bodies = bodies;
    this.motion = new Motion();
    /** @type {Viewer | null} */
    this.viewer = null;
    /** @type {State | null} */
    this.state = null;
    /** @type {import("./protocol.js").Contact[]} */
    this.contacts = [];
    this.showContacts = true;
    this.outputs = 0; // that are shown, as bits
    this.X_FT = identity();
    this.frames = 0; // that have come
    this.heard = 0; // session time of the last one [s]
    /** @type {((state: State, outputs: number, flags: number) => void)[]} */
    this.watchers = [];
    /** @type {((viewer: Viewer | null) => void)[]} */
    this.sceneWatchers = [];
    this.beginning = "overview"; // view point from which a scene is seen at first
    /** @type {((name: string, chosen: boolean) => void)[]} */
    this.lookWatchers = [];
    this.now = 0; // session time that is shown where nobody looks at the past [s]
    /** @type {(() => Seen | null) | null} what to show instead of what is now */
    this.elsewhere = null;
    /** @type {Instead | null} what is shown instead of the room and its past */
    this.instead = null;
    this.other = false; // whether `state` is of that
    /** @type {(() => void)[]} told when session time jumps */
    this.jumpWatchers = [];
    this.url = "";
    onTheme(() => this.viewer?.setTheme(theme()));
    const tick = () => {
      this.tick(performance.now() / 1000);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  /**
   * Draw another scene, once it has come.
   * @param {string} url empty: none
   */
  async load(url) {
    if (url === this.url) return;
    this.url = url;
    if (!url) return;
    const brought = carried()?.still;
    if (brought?.scene_url === url) {
      this.begin(brought.scene);
      return;
    }
    const answer = await fetch(url);
    if (this.url !== url) return; // another one by now
    if (!answer.ok) throw new Error(`the scene could not be fetched (${answer.status})`);
    this.begin(await answer.json());
  }

  /** Draw nothing: what was there is of another room, or of one that is closed. */
  clear() {
    this.url = "";
    this.end();
  }

  /** End the picture. */
  end() {
    const old = this.viewer;
    this.viewer = this.state = null;
    for (const tell of this.sceneWatchers) tell(null);
    if (!old) return;
    old.dispose();
    const fresh = /** @type {HTMLCanvasElement} */ (this.canvas.cloneNode());
    this.canvas.replaceWith(fresh);
    this.canvas = fresh;
  }

  /** @param {SceneData} data */
  begin(data) {
    this.end();
    const viewer = new Viewer(this.canvas, data, theme(), { reflections: false });
    this.viewer = viewer;
    window.setTimeout(() => this.viewer === viewer && !viewer.software && viewer.reflect(), LATER);
    look(this.viewer, this.beginning);
    for (const tell of this.sceneWatchers) tell(this.viewer);
  }

  /** Look from a preset view point, or follow the hand. @param {string} name */
  look(name) {
    this.lookFrom(name, true);
  }

  /** @param {string} name @param {boolean} chosen whether somebody wants it, and not the page */
  lookFrom(name, chosen) {
    if (!this.viewer) return;
    look(this.viewer, name);
    if (this.state) this.viewer.show(this.state); // a hand that rests is followed too
    for (const tell of this.lookWatchers) tell(name, chosen);
  }

  /** Learn from a status which tool is in force. @param {import("./protocol.js").Status} status */
  know(status) {
    this.X_FT = poseFrom(status.tool);
  }

  /** @param {import("./frame.js").PoseFrame} frame */
  take(frame) {
    this.frames++;
    this.heard = frame.time;
    this.motion.add(frame, performance.now() / 1000);
  }

  /** Session time has jumped. */
  forget() {
    this.motion.clear();
    for (const tell of this.jumpWatchers) tell();
  }

  /** @param {number} now [s] */
  tick(now) {
    const shown = this.motion.at(now);
    if (!shown || !this.viewer) return;
    this.now = shown.t;
    const { state, outputs, flags } = (this.instead ? this.instead.seen() : this.elsewhere?.()) ?? { state: this.live(shown, this.viewer), outputs: shown.outputs, flags: shown.flags };
    if (this.changed(state)) {
      this.viewer.show(state);
    }
    const first = !this.state;
    this.other = this.instead !== null;
    this.state = state;
    this.outputs = outputs;
    if (first) {
      this.lookFrom(this.beginning, false); // now that it is known how the arm stands
      requestAnimationFrame(endStill); // after it is drawn
    }
    const lit = this.lit(state.t);
    this.viewer.highlight(lit.length ? this.mark(lit) : null);
    for (const tell of this.watchers) tell(state, outputs, flags);
  }

  /** Return what is now. @param {import("./motion.js").Shown} shown @param {Viewer} viewer @returns {State} */
  live(shown, viewer) {
    const q = new Float64Array(7);
    q.set(shown.joints);
    q[6] = shown.hand;
    const { X_BL, X_BF } = armFrames(viewer.data.robot.arm, q);
    const { poses, held } = this.bodies.at(shown.t, X_BF);
    return { t: shown.t, q, v: new Float64Array(7), X_WL: X_BL, X_WF: X_BF, X_WT: compose(X_BF, this.X_FT), bodies: poses, held };
  }

  /** Whether there is anything new to draw. @param {State} state */
  changed(state) {
    const before = this.state;
    if (!before || before.q.some((q, joint) => q !== state.q[joint])) return true;
    for (const [name, X] of state.bodies) {
      const old = before.bodies.get(name);
      if (!old || X.some((x, index) => x !== old[index])) return true;
    }
    return false;
  }

  /** Return the contacts to be lit up at a time. @param {number} t [s] */
  lit(t) {
    if (!this.showContacts) return [];
    if (!isLive()) return (this.instead?.contacts ?? this.contacts).filter(({ start, end }) => start <= t && t <= end);
    return this.contacts.filter(({ start, end, heard }) => start <= t && t <= Math.max(end, heard ?? end) + AFTERGLOW);
  }

  /** @param {import("./protocol.js").Contact[]} touching @returns {import("../viewer/viewer.js").Mark} */
  mark(touching) {
    const known = new Set(this.viewer?.data.bodies.map((body) => body.name));
    const parts = touching.flatMap((contact) => contact.parts);
    return {
      bodies: [...parts, ...touching.map((contact) => contact.second)].filter((name) => known.has(name)),
      robot: parts.some((name) => !known.has(name)),
      point: touching[0].point,
    };
  }
}

/** Look from a preset view point, or follow the hand. @param {Viewer} viewer @param {string} name */
export function look(viewer, name) {
  viewer.look(name);
  if (viewer.following) return;
  const { camera, controls } = viewer;
  const { eye, target } = aimed(name, (FIELD_OF_VIEW * Math.PI) / 180, camera.aspect, () => worked(viewer), []);
  camera.position.fromArray(eye);
  controls.target.fromArray(target);
  controls.update();
}
