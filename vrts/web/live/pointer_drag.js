// Dragging the virtual pointer by mouse, pen or finger: what lies under it, and where it is pulled.

import { Plane, Raycaster, Vector2, Vector3 } from "three";
import { along, approach, shifted, tip, turned, withBase, withTip } from "./pointer_pose.js";

/** @typedef {import("./pointer_pose.js").PointerPose} PointerPose */
/** @typedef {import("./pointer_pose.js").Vector} Vector */
/** @typedef {"base"|"base-z"|"tip"|"tip-z"|"shaft"|"hand"|"turn"} Handle */

const NEAR = { mouse: 15, pen: 20, touch: 28 }; // [px] how far from a handle it is still taken
const SHAFT = 0.55; // share of that for the arrow between its ends
const EDGE_ON = 0.035; // a plane seen flatter than this (sine) is not dragged on
const FAR = 6; // [m] from the eye: where planes reach the horizon

/** Takes the pointer events of a canvas that fall on a handle; the camera keeps all others. */
export class PointerDrag {
  /**
   * @param {object} to
   * @param {HTMLCanvasElement} to.canvas
   * @param {import("three").PerspectiveCamera} to.camera
   * @param {import("./pointer_figure.js").PointerFigure} to.figure
   * @param {() => {pose: PointerPose, stage: 1|2}} to.now
   * @param {(pose: PointerPose) => void} to.change
   * @param {(handle: Handle | null) => void} to.grab told when a drag begins and ends
   */
  constructor({ canvas, camera, figure, now, change, grab }) {
    this.canvas = canvas;
    this.camera = camera;
    this.figure = figure;
    this.now = now;
    this.change = change;
    this.grab = grab;
    this.ray = new Raycaster();
    /** @type {{id: number, handle: Handle, from: Vector3 | number, pose: PointerPose} | null} */
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
  }

  /** @param {PointerEvent} event */
  down(event) {
    if (this.drag || !this.figure.visible || event.button !== 0) return;
    this.aim(event);
    const handle = this.under(event);
    if (!handle) return;
    const { pose } = this.now();
    const from = this.pulled(handle, pose);
    if (from === null) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    this.canvas.setPointerCapture(event.pointerId);
    this.drag = { id: event.pointerId, handle, from, pose };
    this.grab(handle);
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
    this.aim(event);
    const { handle, from, pose } = this.drag;
    const to = this.pulled(handle, pose);
    if (to !== null) this.change(moved(handle, pose, from, to));
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (event.pointerId !== this.drag?.id) return;
    event.stopImmediatePropagation();
    this.drag = null;
    this.canvas.style.cursor = "";
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
   * @param {Vector3} point @returns {{x: number, y: number}} [px]
   */
  onPage(point) {
    const box = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const { x, y } = point.clone().project(this.camera);
    return { x: box.left + ((x + 1) / 2) * box.width, y: box.top + ((1 - y) / 2) * box.height };
  }

  /** Return where the handles are now, in the world. @returns {[Handle, Vector3][]} */
  handles() {
    const { figure } = this;
    figure.updateMatrixWorld(true);
    if (this.now().stage === 2) return [["turn", figure.knobAt(0)], ["turn", figure.knobAt(1)]];
    return [["base", figure.base.position], ["tip", figure.tip.position],
      ["base-z", figure.base.top()], ["tip-z", figure.tip.top()]];
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
    if (fromSegment(event.clientX, event.clientY, ends[0], ends[1]) < near * SHAFT) return "shaft";
    if (this.ray.intersectObject(this.figure.ghost, true).length) return stage === 1 ? "hand" : "turn";
    return stage === 2 && this.ray.intersectObject(this.figure.ring, true).length ? "turn" : null;
  }

  /**
   * Return what the ray points at, as the handle sees it: a point, or an angle about the arrow.
   * @param {Handle} handle @param {PointerPose} pose when the drag began @returns {Vector3 | number | null}
   */
  pulled(handle, pose) {
    const base = new Vector3().fromArray(pose.point);
    const ahead = new Vector3().fromArray(approach(pose));
    const end = handle.startsWith("tip") ? new Vector3().fromArray(tip(pose)) : base;
    if (handle.endsWith("-z")) return this.onLine(end, new Vector3(0, 0, 1));
    if (handle === "shaft") return this.onLine(base, ahead);
    if (handle !== "turn") return this.onPlane(end, new Vector3(0, 0, 1));
    const hit = this.onPlane(base, ahead);
    if (!hit) return null;
    const away = hit.sub(base);
    const [x, y] = [new Vector3(pose.R[0], pose.R[3], pose.R[6]), new Vector3(pose.R[1], pose.R[4], pose.R[7])];
    return Math.atan2(away.dot(y), away.dot(x));
  }

  /** @param {Vector3} through @param {Vector3} normal */
  onPlane(through, normal) {
    if (Math.abs(this.ray.ray.direction.dot(normal)) < EDGE_ON) return null;
    const hit = this.ray.ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal, through), new Vector3());
    return hit && hit.distanceTo(this.ray.ray.origin) < FAR ? hit : null;
  }

  /** Return the point of a line that is nearest to the ray. @param {Vector3} through @param {Vector3} along */
  onLine(through, along) {
    const { origin, direction } = this.ray.ray;
    const slant = direction.dot(along);
    const parallel = 1 - slant * slant;
    if (parallel < EDGE_ON * EDGE_ON) return null;
    const between = origin.clone().sub(through);
    const share = (between.dot(along) - between.dot(direction) * slant) / parallel;
    return Math.abs(share) < FAR ? through.clone().addScaledVector(along, share) : null;
  }
}

/**
 * @param {Handle} handle @param {PointerPose} pose when the drag began
 * @param {Vector3 | number} from @param {Vector3 | number} to @returns {PointerPose}
 */
function moved(handle, pose, from, to) {
  if (typeof from === "number" || typeof to === "number") return turned(pose, Number(to) - Number(from));
  const by = /** @type {Vector} */ (to.clone().sub(from).toArray());
  if (handle === "hand") return shifted(pose, by);
  if (handle === "shaft") return along(pose, new Vector3(...by).dot(new Vector3(...approach(pose))));
  const end = handle.startsWith("tip") ? tip(pose) : pose.point;
  const next = /** @type {Vector} */ (end.map((value, i) => value + by[i]));
  return handle.startsWith("tip") ? withTip(pose, next) : withBase(pose, next);
}

/** @param {number} x @param {number} y @param {{x: number, y: number}} a @param {{x: number, y: number}} b */
function fromSegment(x, y, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const share = Math.min(Math.max(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - a.x - share * dx, y - a.y - share * dy);
}
