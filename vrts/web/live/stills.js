// Stills of many rooms: one hidden viewer for each scene draws them onto plain canvases.

import { armFrames } from "../viewer/kinematics.js";
import { Viewer } from "../viewer/viewer.js";
import { Bodies } from "./bodies.js";
import { make } from "./dom.js";
import { theme } from "./themes.js";
import { look } from "./world.js";

const MOST_VIEWERS = 6; // browsers allow a limited number of WebGL contexts

/** Remembers scenes and what was drawn of each room. */
export class Stills {
  constructor() {
    /** @type {Map<string, Promise<Viewer | null>>} by id of the scene */
    this.viewers = new Map();
    /** @type {WeakMap<HTMLCanvasElement, string>} */
    this.drawn = new WeakMap();
  }

  /** @param {HTMLCanvasElement} canvas @param {import("./protocol.js").WallRow} row */
  async draw(canvas, row) {
    const key = JSON.stringify([row.scene_url, row.joints_rad.map((q) => q.toFixed(3)), row.hand_m.toFixed(3), row.bodies, theme()]);
    if (!row.scene_url || !row.joints_rad.length || this.drawn.get(canvas) === key) return;
    this.drawn.set(canvas, key);
    const viewer = await this.viewer(row.scene, row.scene_url);
    if (!viewer) return;
    const q = new Float64Array(7);
    q.set(row.joints_rad);
    q[6] = row.hand_m;
    const { X_BL, X_BF } = armFrames(viewer.data.robot.arm, q);
    const bodies = new Bodies();
    bodies.reset(row.bodies);
    const { poses, held } = bodies.at(row.time_s, X_BF);
    viewer.snapshot(canvas, { t: row.time_s, q, v: new Float64Array(7), X_WL: X_BL, X_WF: X_BF, X_WT: X_BF, bodies: poses, held }, null);
  }

  /** Return the viewer of a scene; null when there are too many already. @param {string} scene @param {string} url */
  viewer(scene, url) {
    const known = this.viewers.get(scene);
    if (known) return known;
    const fresh = this.viewers.size < MOST_VIEWERS ? this.begin(url) : Promise.resolve(null);
    this.viewers.set(scene, fresh);
    return fresh;
  }

  /** @param {string} url */
  async begin(url) {
    const answer = await fetch(url);
    if (!answer.ok) return null;
    const canvas = make("canvas", { class: "hidden-view", "aria-hidden": "true" });
    document.body.append(canvas);
    const viewer = new Viewer(canvas, await answer.json(), theme());
    viewer.resize();
    look(viewer, "overview");
    return viewer;
  }
}
