// The locations of a program as handles over the picture: dragged or pushed, their numbers change.

import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Vector3 } from "three";
import { Screen } from "../live/pointing/screen.js";
import { place } from "../viewer/figures.js";
import { poseFrom } from "../viewer/poses.js";
import { pulled, pushed, written } from "./pulling.js";

/** @typedef {import("./pulling.js").Numbers} Numbers */
/**
 * @typedef {object} Row a location
 * @property {string} name as it is written, with subscripts
 * @property {string} of the variable
 * @property {number[]} subscripts
 * @property {string} file with its numbers
 * @property {number} line of them
 * @property {number[]} X pose in the world, twelve numbers
 * @property {number[]} numbers X Y Z of its line [mm]
 * @property {string} why it cannot be dragged; empty: it can
 */
/** @typedef {{row: Row, button: HTMLButtonElement, tag: HTMLElement, axes: Group, at: Numbers | null, wide: number}} Handle `at`: where it was put meanwhile [mm] */
/** @typedef {{handle: Handle, start: Numbers, from: import("../live/pointing/screen.js").Place, last: import("../live/pointing/screen.js").Place, pointer: number | null, upright: boolean}} Moving */
/** @typedef {{reach: (row: Row, at: Numbers) => void, move: (row: Row, at: Numbers) => void}} Told whoever asks the server, and changes the text */

const AXIS = 0.05; // [m]
const DOT = 8; // [px] radius that nothing covers
const HIGH = 18; // [px] of a name
const COLORS = [0xe03131, 0x2f9e44, 0x1c7ed6]; // X, Y, Z
const HELP = "Arrow keys move it along X and Y by 0.1 mm, with Shift along Z, with Ctrl by 1 mm. Enter writes it into the text, Escape gives up.";

/** The handles of one panel. */
export class Places {
  /** @param {HTMLElement} view around the canvas @param {HTMLInputElement} shown @param {Told} told */
  constructor(view, shown, told) {
    this.told = told;
    this.box = document.createElement("div");
    this.box.className = "places";
    this.box.setAttribute("role", "group");
    this.box.setAttribute("aria-label", "Locations of the program");
    this.said = document.createElement("p");
    this.said.className = "moving";
    this.said.setAttribute("role", "status");
    this.said.hidden = true;
    this.help = document.createElement("p");
    this.help.id = "places-help";
    this.help.hidden = true;
    this.help.textContent = HELP;
    view.append(this.box, this.said, this.help);
    /** @type {Map<string, Handle>} */
    this.handles = new Map();
    /** @type {import("../viewer/viewer.js").Viewer | null} */
    this.viewer = null;
    /** @type {Moving | null} */
    this.moving = null;
    this.asked = ""; // which question about reach has no answer yet
    this.reached = "";
    this.shown = shown;
    shown.addEventListener("change", () => this.show());
  }

  /** Be drawn over another viewer. @param {import("../viewer/viewer.js").Viewer | null} viewer */
  over(viewer) {
    if (this.viewer === viewer) return;
    this.viewer = viewer;
    this.axes = new Group();
    for (const { axes } of this.handles.values()) this.axes.add(axes);
    if (!viewer) return;
    viewer.scene.add(this.axes);
    viewer.drawn = () => this.draw();
    this.show();
  }

  /** Take the locations of another recording; one that is being moved stays in hand. @param {Row[]} rows */
  take(rows) {
    const names = new Set(rows.map((row) => row.name));
    for (const [name, handle] of this.handles) {
      if (names.has(name)) continue;
      if (this.moving?.handle === handle) this.giveUp();
      this.handles.delete(name);
      this.axes?.remove(handle.axes);
      handle.button.remove();
    }
    for (const row of rows) this.takeRow(row);
    if (this.shown.parentElement) this.shown.parentElement.hidden = !rows.length;
    this.show();
  }

  /** @param {Row} row */
  takeRow(row) {
    const handle = this.handles.get(row.name) ?? this.made(row);
    handle.row = row;
    if (this.moving?.handle !== handle) handle.at = null;
    const { button } = handle;
    const fixed = row.why !== "";
    button.setAttribute("aria-disabled", String(fixed));
    button.classList.toggle("fixed", fixed);
    button.title = fixed ? `${row.name} cannot be dragged: ${row.why}` : `${row.name}: drag it, or push it by arrow keys`;
    this.put(handle);
  }

  /** @param {Row} row @returns {Handle} */
  made(row) {
    const button = document.createElement("button");
    const [dot, tag] = [document.createElement("span"), document.createElement("span")];
    button.type = "button";
    button.className = "place";
    dot.className = "dot";
    tag.className = "tag";
    tag.textContent = row.name;
    button.append(dot, tag);
    button.setAttribute("aria-describedby", this.help.id);
    this.box.append(button);
    /** @type {Handle} */
    const handle = { row, button, tag, axes: axes(), at: null, wide: 0 };
    this.handles.set(row.name, handle);
    this.axes?.add(handle.axes);
    button.addEventListener("pointerdown", (event) => this.down(handle, event));
    button.addEventListener("pointermove", (event) => this.pull(event));
    button.addEventListener("pointerup", (event) => this.up(event));
    button.addEventListener("pointercancel", (event) => event.pointerId === this.moving?.pointer && this.giveUp());
    button.addEventListener("lostpointercapture", (event) => event.pointerId === this.moving?.pointer && this.giveUp());
    button.addEventListener("keydown", (event) => this.key(handle, event));
    button.addEventListener("focus", () => this.sayFixed(handle));
    button.addEventListener("blur", () => this.left(handle));
    return handle;
  }

  /** Where a location stands now [mm]. @param {Handle} handle @returns {Numbers} */
  at({ row, at }) {
    return at ?? /** @type {Numbers} */ (row.numbers.length ? row.numbers : row.X.slice(9).map((x) => x * 1e3));
  }

  /** Let axes and words of a handle be those of its place. @param {Handle} handle */
  put(handle) {
    const { row, button } = handle;
    const at = this.at(handle);
    const X = poseFrom(row.X);
    if (handle.at) for (const i of [0, 1, 2]) X[12 + i] = at[i] / 1e3;
    place(handle.axes, X);
    button.setAttribute("aria-label", `location ${row.name}, ${written(at)} mm${row.why ? `; it cannot be dragged: ${row.why}` : ""}`);
    this.viewer?.requestDraw();
  }

  show() {
    const on = this.shown.checked;
    this.box.hidden = !on;
    if (this.axes) this.axes.visible = on;
    if (!on) this.giveUp();
    this.viewer?.requestDraw();
  }

  /** @returns {Screen | null} */
  get screen() {
    return this.viewer && new Screen(this.viewer.camera, this.viewer.canvas);
  }

  /** Put the handles where their places are seen; names that would lie on others are left out. */
  draw() {
    const { screen } = this;
    if (!screen || this.box.hidden) return;
    const { clientWidth, clientHeight } = screen.canvas;
    screen.camera.updateMatrixWorld();
    const seen = [...this.handles.values()].map((handle) => {
      const point = new Vector3().fromArray(this.at(handle)).multiplyScalar(1e-3);
      if (!handle.at) point.fromArray(handle.row.X.slice(9));
      return { handle, depth: screen.depth(point), ...screen.place(point) };
    });
    const dots = seen.map(({ x, y }) => /** @type {[number, number, number]} */ ([x - DOT, y, x + DOT]));
    /** @type {[number, number, number][]} left, height, right of dots and names */
    const taken = [...dots];
    for (const { handle, depth, x, y } of seen.sort((a, b) => a.depth - b.depth)) {
      const { button, tag } = handle;
      const away = depth < 0.05 || x < 0 || y < 0 || x > clientWidth || y > clientHeight;
      button.hidden = away && this.moving?.handle !== handle && document.activeElement !== button;
      if (button.hidden) continue;
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      handle.wide ||= tag.offsetWidth;
      const free = (/** @type {number} */ left) => left >= 0 && !taken.some(([a, height, b]) => Math.abs(height - y) < HIGH && left < b && a < left + handle.wide);
      const [right, left] = [x + DOT + 2, x - DOT - 2 - handle.wide];
      const aside = !free(right) && free(left);
      const covered = !aside && !free(right);
      button.classList.toggle("short", covered);
      button.classList.toggle("aside", aside);
      if (!covered) taken.push([aside ? left : right, y, (aside ? left : right) + handle.wide]);
    }
  }

  // --- moved by whoever sits there ---

  /** @param {Handle} handle @param {PointerEvent} event */
  down(handle, event) {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.button.focus({ preventScroll: true });
    if (handle.row.why || this.moving?.pointer != null) return;
    this.finish();
    handle.button.setPointerCapture(event.pointerId);
    this.begin(handle, event.pointerId);
    const moving = /** @type {Moving} */ (this.moving);
    moving.from = moving.last = { x: event.clientX, y: event.clientY };
    moving.upright = event.shiftKey;
  }

  /** @param {Handle} handle @param {number | null} pointer */
  begin(handle, pointer) {
    const start = this.at(handle);
    const nowhere = { x: 0, y: 0 };
    this.moving = { handle, start, from: nowhere, last: nowhere, pointer, upright: false };
    this.reached = "";
    handle.button.classList.add("busy");
    this.goTo(start);
  }

  /** @param {PointerEvent} event */
  pull(event) {
    const { moving, screen } = this;
    if (!moving || !screen || event.pointerId !== moving.pointer) return;
    if (event.shiftKey !== moving.upright) { // what has been done stays
      moving.start = this.at(moving.handle);
      moving.from = moving.last;
      moving.upright = event.shiftKey;
    }
    moving.last = { x: event.clientX, y: event.clientY };
    const { left, top } = screen.canvas.getBoundingClientRect();
    const onCanvas = (/** @type {{x: number, y: number}} */ p) => ({ x: p.x - left, y: p.y - top });
    this.goTo(pulled(screen, moving.start, onCanvas(moving.from), onCanvas(moving.last), moving.upright));
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (event.pointerId === this.moving?.pointer) this.finish();
  }

  /** @param {Handle} handle @param {KeyboardEvent} event */
  key(handle, event) {
    const { moving } = this;
    const next = pushed(this.at(handle), event);
    if (event.key === "Escape" && moving) this.giveUp();
    else if ((event.key === "Enter" || event.key === " ") && moving?.pointer === null) this.finish();
    else if (event.key === "Enter" || event.key === " ") this.sayFixed(handle);
    else if (!next) return;
    else if (handle.row.why) this.sayFixed(handle);
    else {
      if (moving && moving.pointer !== null) return;
      if (!moving) this.begin(handle, null);
      this.goTo(next);
    }
    event.preventDefault();
    event.stopPropagation(); // the time stays, and so do the keys
  }

  /** The keys go elsewhere: what was pushed is kept. @param {Handle} handle */
  left(handle) {
    if (this.moving?.handle === handle && this.moving.pointer === null) this.finish();
    else if (!this.moving) this.said.hidden = true;
  }

  /** @param {Numbers} at [mm] */
  goTo(at) {
    if (!this.moving) return;
    const { handle } = this.moving;
    handle.at = at;
    this.put(handle);
    this.say();
    this.ask();
  }

  /** Ask whether the arm gets there; one question at a time, the newest next. */
  ask() {
    if (!this.moving || this.asked) return;
    const { row, at } = this.moving.handle;
    if (!at) return;
    this.asked = `${row.name} ${at}`;
    this.told.reach(row, at);
  }

  /** Take an answer. @param {{name: string, at: Numbers, reached: boolean | null, text: string}} answer */
  answered({ name, at, reached, text }) {
    this.asked = "";
    const handle = this.moving?.handle;
    if (!handle || handle.row.name !== name) return this.ask();
    this.reached = text;
    this.said.classList.toggle("bad", reached === false);
    handle.button.classList.toggle("bad", reached === false);
    this.say();
    if (String(handle.at) !== String(at)) this.ask();
  }

  say() {
    if (!this.moving) return;
    const { handle } = this.moving;
    this.said.hidden = false;
    this.said.textContent = `${handle.row.name}  ${written(this.at(handle))} mm${this.reached ? `: ${this.reached}` : ""}`;
  }

  /** Say why a handle cannot be dragged. @param {Handle} handle */
  sayFixed({ row }) {
    if (!row.why || this.moving) return;
    this.said.classList.remove("bad");
    this.said.hidden = false;
    this.said.textContent = `${row.name} cannot be dragged: ${row.why}`;
  }

  /** Leave a location where it is: the text changes. */
  finish() {
    const moved = this.end();
    if (!moved) return;
    const { row, at } = moved.handle;
    if (!at || at.every((value, i) => Math.abs(value - row.numbers[i]) < 0.05)) this.back(moved.handle);
    else this.told.move(row, at);
  }

  /** Let a location be where the text has it. */
  giveUp() {
    const moved = this.end();
    if (moved) this.back(moved.handle);
  }

  /** @param {Handle} handle */
  back(handle) {
    handle.at = null;
    this.put(handle);
  }

  /** @returns {Moving | null} */
  end() {
    const { moving } = this;
    this.moving = null;
    this.said.hidden = true;
    this.said.classList.remove("bad");
    if (!moving) return null;
    const { button } = moving.handle;
    button.classList.remove("busy", "bad");
    if (moving.pointer !== null && button.hasPointerCapture(moving.pointer)) button.releasePointerCapture(moving.pointer);
    return moving;
  }

  /** The text was not changed: the location goes back. @param {string} name */
  refused(name) {
    const handle = this.handles.get(name);
    if (handle && this.moving?.handle !== handle) this.back(handle);
  }
}

/** Return the axes of a location: red X, green Y, blue Z. */
function axes() {
  const group = new Group();
  COLORS.forEach((color, k) => {
    const ends = new Float32Array(6);
    ends[3 + k] = AXIS;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(ends, 3));
    group.add(new LineSegments(geometry, new LineBasicMaterial({ color, transparent: true, opacity: 0.9 })));
  });
  return group;
}
