// Dragging the virtual pointer by mouse, pen or finger: what lies under it, and how far it is pulled.

import { Plane, Raycaster, Vector2, Vector3 } from "three";
import { figure as written } from "./dom.js";
import { along as slid, approach, shifted, tip, turned, withBase, withTip } from "./pointer_pose.js";
import { along, FINER, level, stepped } from "./pointing/gain.js";

/** @typedef {import("./pointer_pose.js").PointerPose} PointerPose */
/** @typedef {import("./pointer_pose.js").Vector} Vector */
/** @typedef {import("./pointing/handles.js").Handle} Handle */
/** @typedef {import("./pointing/screen.js").Place} Place */

export const NEAR = { mouse: 14, pen: 16, touch: 23 }; // [px] how far from a handle it is still taken: less than half of what they are apart
const SHAFT = 8; // [px] from the arrow between its ends
const EDGE_ON = 0.25; // a ring seen flatter than this (sine) is dragged along, and not around
const ALONG = 1 / 62; // [rad] by which it turns then, for each pixel
const DEG = 180 / Math.PI;

/** Takes the pointer events of a canvas that fall on a handle; the camera keeps all others. */
export class PointerDrag {
  /**
   * @param {object} to
   * @param {HTMLCanvasElement} to.canvas
   * @param {import("three").PerspectiveCamera} to.camera
   * @param {import("./pointer_figure.js").PointerFigure} to.figure
   * @param {() => {pose: PointerPose, stage: 1|2}} to.now
   * @param {() => {m: number, rad: number}} to.steps in which things move
   * @param {(pose: PointerPose) => void} to.change
   * @param {(handle: Handle | null) => void} to.grab told when a drag begins and ends
   * @param {(text: string, at: Place) => void} to.tell how far it has gone, and where on the page; empty: nothing is dragged
   */
  constructor({ canvas, camera, figure, now, steps, change, grab, tell }) {
    this.canvas = canvas;
    this.camera = camera;
    this.figure = figure;
    this.now = now;
    this.steps = steps;
    this.change = change;
    this.grab = grab;
    this.tell = tell;
    this.screen = figure.screen;
    this.ray = new Raycaster();
    /** @type {{id: number, handle: Handle, from: Place, last: Place, angle: number | null, pose: PointerPose, start: PointerPose, fine: boolean, seen: Seen} | null} */
    this.drag = null;
    this.stop = new AbortController();
    const on = { capture: true, signal: this.stop.signal };
    canvas.addEventListener("pointerdown", (event) => this.down(event), on);
    canvas.addEventListener("pointermove", (event) => this.move(event), on);
    canvas.addEventListener("pointerup", (event) => this.up(event), on);
    canvas.addEventListener("pointercancel", (event) => this.up(event), on);
  }

  /** Listen no more. */
  dispose() {
    this.stop.abort();
    this.tell("", { x: 0, y: 0 });
  }

  /** @param {PointerEvent} event */
  down(event) {
    if (this.drag || !this.figure.visible || event.button !== 0) return;
    this.aim(event);
    const handle = this.under(event);
    if (!handle) return;
    const { pose } = this.now();
    event.stopImmediatePropagation();
    event.preventDefault();
    this.canvas.setPointerCapture(event.pointerId);
    this.begin(event, { x: event.clientX, y: event.clientY }, handle, pose);
    this.grab(handle);
  }

  /** Count from a place on. @param {PointerEvent} event @param {Place} from where the ray was pointed last @param {Handle} handle @param {PointerPose} start when it was grabbed */
  begin(event, from, handle, start) {
    const { pose } = this.now();
    const angle = handle === "turn" ? this.angle(pose) : null;
    this.drag = { id: event.pointerId, handle, from, last: from, angle, pose, start, fine: event.shiftKey, seen: this.seen(handle, pose) };
  }

  /** @param {PointerEvent} event */
  move(event) {
    if (!this.drag) {
      if (event.pointerType === "mouse" && !event.buttons && this.figure.visible) {
        this.aim(event);
        this.canvas.style.cursor = this.under(event) ? "grab" : "";
      }
      return;
    }
    if (event.pointerId !== this.drag.id) return;
    event.stopImmediatePropagation();
    const { handle, start, fine, last } = this.drag;
    if (event.shiftKey !== fine) this.begin(event, last, handle, start); // how far it has gone stays
    this.aim(event);
    this.drag.last = { x: event.clientX, y: event.clientY };
    const by = { x: event.clientX - this.drag.from.x, y: event.clientY - this.drag.from.y };
    const next = handle === "turn" ? this.turn(by, event.shiftKey) : this.pull(by, event.shiftKey);
    this.change(next);
    this.tell(told(handle, start, next), { x: event.clientX, y: event.clientY });
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (event.pointerId !== this.drag?.id) return;
    event.stopImmediatePropagation();
    this.drag = null;
    this.canvas.style.cursor = "";
    this.tell("", { x: 0, y: 0 });
    this.grab(null);
  }

  /** Point the ray where the event is. @param {PointerEvent} event */
  aim(event) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    this.camera.updateMatrixWorld();
    this.ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.camera);
  }

  /**
   * Return where a point of the world is on the page.
   * @param {Vector3} point @returns {Place} [px]
   */
  onPage(point) {
    const box = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const { x, y } = this.screen.place(point);
    return { x: box.left + x, y: box.top + y };
  }

  /** Return where the handles are now, in the world. @returns {[Handle, Vector3][]} */
  handles() {
    this.figure.updateMatrixWorld(true);
    return this.figure.handles.list();
  }

  /** @param {PointerEvent} event @returns {Handle | null} */
  under(event) {
    const near = NEAR[/** @type {keyof typeof NEAR} */ (event.pointerType)] ?? NEAR.mouse;
    /** @type {Handle | null} */
    let best = null;
    let least = near;
    for (const [handle, point] of this.handles()) {
      const { x, y } = this.onPage(point);
      const distance = Math.hypot(event.clientX - x, event.clientY - y);
      if (distance < least) [best, least] = [handle, distance];
    }
    if (best) return best;
    const { pose, stage } = this.now();
    const ends = [pose.point, tip(pose)].map((end) => this.onPage(new Vector3().fromArray(end)));
    if (fromSegment(event.clientX, event.clientY, ends[0], ends[1]) < SHAFT) return "shaft";
    if (this.ray.intersectObject(this.figure.ghost, true).length) return stage === 1 ? "hand" : "turn";
    return stage === 2 && this.ray.intersectObject(this.figure.handles.ring, true).length ? "turn" : null;
  }

  /**
   * Return how things are seen when a drag begins: it goes by that, whatever happens on the way.
   * @param {Handle} handle @param {PointerPose} pose @returns {Seen}
   */
  seen(handle, pose) {
    const { screen, camera } = this;
    const end = new Vector3().fromArray(handle.startsWith("tip") ? tip(pose) : pose.point);
    const line = handle === "shaft" ? new Vector3().fromArray(approach(pose)) : new Vector3(0, 0, 1);
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).setZ(0).normalize();
    return {
      pixel: screen.pixel(screen.depth(end)),
      right: /** @type {Vector} */ (right.toArray()),
      away: [-right.y, right.x, 0],
      line: this.headward(handle) ?? screen.direction(end, line) ?? { x: 0, y: -1 },
    };
  }

  /** Where the handle for a height stands seen from its ball, as the upward direction. @param {Handle} handle @returns {Place | null} */
  headward(handle) {
    if (!handle.endsWith("-z")) return null;
    const ends = this.figure.handles;
    const { ball, head } = handle === "tip-z" ? ends.tip : ends.base;
    const [a, b] = [this.screen.place(ball.position), this.screen.place(head.position)];
    const up = approach(this.now().pose)[2] > 0.3 === (handle === "tip-z") ? 1 : -1;
    const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
    return { x: (up * (b.x - a.x)) / length, y: (up * (b.y - a.y)) / length };
  }

  /** @param {Place} by [px] @param {boolean} fine @returns {PointerPose} */
  pull(by, fine) {
    const { handle, pose, seen } = /** @type {NonNullable<typeof this.drag>} */ (this.drag);
    const share = fine ? FINER : 1;
    const [pixel, step] = [seen.pixel * share, this.steps().m * share];
    if (handle === "shaft") return slid(pose, along(by, pixel, seen.line, step));
    /** @type {Vector} */
    const moved = handle.endsWith("-z") ? [0, 0, along(by, pixel, seen.line, step)] : level(by, pixel, seen.right, seen.away, step);
    if (handle === "hand") return shifted(pose, moved);
    const end = handle.startsWith("tip") ? tip(pose) : pose.point;
    const next = /** @type {Vector} */ (end.map((value, i) => value + moved[i]));
    return handle.startsWith("tip") ? withTip(pose, next) : withBase(pose, next);
  }

  /** @param {Place} by [px] @param {boolean} fine @returns {PointerPose} */
  turn(by, fine) {
    const { pose, angle } = /** @type {NonNullable<typeof this.drag>} */ (this.drag);
    const now = this.angle(pose);
    const share = fine ? FINER : 1;
    const turnedBy = angle !== null && now !== null ? Math.atan2(Math.sin(now - angle), Math.cos(now - angle)) : this.around(by, pose);
    return turned(pose, stepped(turnedBy * share, this.steps().rad * share));
  }

  /** Return the angle about the arrow at which the ray meets the ring's plane; null: it is seen from its edge. @param {PointerPose} pose */
  angle(pose) {
    const [base, ahead] = [new Vector3().fromArray(pose.point), new Vector3().fromArray(approach(pose))];
    if (Math.abs(this.ray.ray.direction.dot(ahead)) < EDGE_ON) return null;
    const hit = this.ray.ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(ahead, base), new Vector3());
    if (!hit) return null;
    const out = hit.sub(base);
    const [x, y] = [new Vector3(pose.R[0], pose.R[3], pose.R[6]), new Vector3(pose.R[1], pose.R[4], pose.R[7])];
    return Math.atan2(out.dot(y), out.dot(x));
  }

  /** Return how far a ring seen from its edge is turned, as if its near side were pulled. @param {Place} by [px] @param {PointerPose} pose */
  around(by, pose) {
    const [base, ahead] = [new Vector3().fromArray(pose.point), new Vector3().fromArray(approach(pose))];
    const side = ahead.clone().cross(this.camera.position.clone().sub(base)).normalize();
    const seen = this.screen.direction(base, side) ?? { x: 1, y: 0 };
    return (by.x * seen.x + by.y * seen.y) * ALONG;
  }
}

/**
 * @typedef {object} Seen
 * @property {number} pixel what one is where the handle is [m]
 * @property {Vector} right level, of length 1
 * @property {Vector} away level, of length 1
 * @property {Place} line direction of the line along which the handle slides
 */

/**
 * Return how far a drag has gone, in words.
 * @param {Handle} handle @param {PointerPose} from @param {PointerPose} to
 */
function told(handle, from, to) {
  if (handle === "turn") {
    const [a, b] = [from.R, to.R];
    const [sine, cosine] = [b[0] * a[1] + b[3] * a[4] + b[6] * a[7], b[0] * a[0] + b[3] * a[3] + b[6] * a[6]];
    return `turned ${signed(Math.atan2(sine, cosine) * DEG)}°`;
  }
  const [a, b] = handle.startsWith("tip") ? [tip(from), tip(to)] : [from.point, to.point];
  const by = b.map((value, i) => (value - a[i]) * 1000);
  const parts = ["X", "Y", "Z"].map((name, i) => (Math.abs(by[i]) < 0.05 ? "" : `${name} ${signed(by[i])}`)).filter(Boolean);
  return `${written(Math.hypot(...by), 1)} mm${parts.length ? `: ${parts.join(", ")}` : ""}`;
}

/** @param {number} value */
function signed(value) {
  return `${value > 0.05 ? "+" : ""}${written(value, 1)}`;
}

/** @param {number} x @param {number} y @param {Place} a @param {Place} b */
function fromSegment(x, y, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const share = Math.min(Math.max(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - a.x - share * dx, y - a.y - share * dy);
}
