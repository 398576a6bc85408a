// Names over the picture: of the things that stand there and of what a task wants, none over another.

import { Vector3 } from "three";
import { byId, make } from "./dom.js";
import { placed } from "./name_places.js";
import { alsoPicks, onSelect, selected, topOf } from "./selection.js";

const UNNAMED = ["floor", "table"]; // kinds of bodies that need no name in the picture
const WEIGHTS = { chosen: 4, object: 3, goal: 2, via: 1, zone: 1 }; // what is written first where there is little room

/** @typedef {{text: string, body: string, kind: "object"|"goal"|"via"|"zone", point: () => number[], color: string}} Name */
/** @typedef {{name: Name, element: HTMLElement, width: number, height: number, left: number, top: number}} Tag */

/** Writes names where their things are seen. */
export class Signs {
  /** @param {import("./world.js").World} world */
  constructor(world) {
    this.world = world;
    this.shown = true;
    this.box = make("div", { class: "picture-names", id: "picture-names", "aria-hidden": "true" });
    byId("overlay").before(this.box);
    /** @type {Tag[]} */
    this.tags = [];
    this.key = "";
    alsoPicks((x, y) => this.at(x, y));
    onSelect(() => (this.key = ""));
    world.watchers.push(() => this.follow());
  }

  /** Name the movable and fixed things of a scene, and more. @param {import("../viewer/viewer.js").Viewer | null} viewer @param {Name[]} more */
  list(viewer, more) {
    /** @type {Name[]} */
    const things = (viewer?.data.bodies ?? []).filter(({ kind }) => !UNNAMED.includes(kind)).map(({ name }) => {
      const group = viewer?.bodies.get(name)?.group;
      return { text: name, body: name, kind: "object", point: () => (group ? topOf(group) : [0, 0, 0]), color: "" };
    });
    this.tags = [...things, ...more].map((name) => {
      const element = make("span", { class: name.kind, text: name.text });
      if (name.color) element.style.setProperty("--own", name.color);
      return { name, element, width: 0, height: 0, left: 0, top: 0 };
    });
    this.box.replaceChildren(...this.tags.map(({ element }) => element));
    this.measure();
  }

  /** See how large the names are: hidden ones have no size. */
  measure() {
    for (const tag of this.tags) [tag.width, tag.height] = [tag.element.offsetWidth, tag.element.offsetHeight];
    this.key = "";
  }

  /** @param {boolean} on */
  show(on) {
    this.shown = on;
    this.box.hidden = !on;
    this.measure();
  }

  /** Write the names where their things are now. */
  follow() {
    const viewer = this.world.viewer;
    if (!viewer || !this.shown || !this.tags.length) return;
    const { clientWidth: width, clientHeight: height } = viewer.canvas;
    viewer.camera.updateMatrixWorld();
    const things = [...viewer.bodies.values()].map((figure) => figure.group.matrix.elements.slice(12, 15).map((n) => n.toFixed(4)).join());
    const key = [width, height, selected(), viewer.camera.matrixWorld.elements.map((n) => n.toFixed(4)).join(), ...things].join(" ");
    if (key === this.key) return;
    this.key = key;
    const wanted = this.tags.map((tag) => {
      const seen = new Vector3().fromArray(tag.name.point()).project(viewer.camera);
      const inFront = seen.z < 1;
      const weight = tag.name.body && tag.name.body === selected() ? WEIGHTS.chosen : WEIGHTS[tag.name.kind];
      return { x: inFront ? ((seen.x + 1) / 2) * width : -1, y: ((1 - seen.y) / 2) * height, width: tag.width, height: tag.height, weight };
    });
    placed(wanted, { width, height }).forEach((spot, index) => {
      const { element, name } = this.tags[index];
      element.style.visibility = spot ? "visible" : "hidden";
      element.classList.toggle("chosen", name.body !== "" && name.body === selected());
      [this.tags[index].left, this.tags[index].top] = spot ? [Math.round(spot.left), Math.round(spot.top)] : [-1e4, -1e4];
      if (spot) element.style.transform = `translate(${this.tags[index].left}px, ${this.tags[index].top}px)`;
    });
  }

  /** Return the body whose name is written at a place of the window; empty: none. @param {number} x @param {number} y [px] */
  at(x, y) {
    if (!this.shown) return "";
    this.follow();
    const area = this.box.getBoundingClientRect();
    const [left, top] = [x - area.left, y - area.top];
    return this.tags.find((tag) => left >= tag.left && left < tag.left + tag.width && top >= tag.top && top < tag.top + tag.height)?.name.body ?? "";
  }
}
