// Which thing of the scene is selected on this page: by a click in the picture, from a list, or by whoever else wants to.

import { Box3, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, Raycaster, Vector2 } from "three";
import { pieceGeometry } from "../viewer/shapes.js";

const STILL = 5; // so far a click may wander, else it is a drag [px]
const QUICK = 600; // what takes longer is no click [ms]
const EDGE_ANGLE = 32; // [degrees]
const CHOSEN = 0x1c7ed6;

let name = ""; // empty: nothing
/** @type {((name: string) => void)[]} */
const watchers = [];
/** @type {((x: number, y: number) => string)[]} */
const pickers = [];

/** Select a thing of the scene, or nothing. @param {string} wanted name of a body; empty: nothing */
export function select(wanted) {
  if (wanted === name) return;
  name = wanted;
  for (const tell of watchers) tell(name);
}

/** Return the name of the body that is selected; empty: none. */
export function selected() {
  return name;
}

/** Be told now, and whenever another thing is selected. @param {(name: string) => void} tell */
export function onSelect(tell) {
  watchers.push(tell);
  tell(name);
}

/** Let something over the picture, such as a label, stand for a body. @param {(x: number, y: number) => string} at name at a place of the window [px], or nothing */
export function alsoPicks(at) {
  pickers.push(at);
}

/**
 * Return the body that is seen at a place of the window: what is in front counts; empty: none.
 * @param {import("../viewer/viewer.js").Viewer} viewer @param {number} x @param {number} y [px]
 */
export function bodyAt(viewer, x, y) {
  const area = viewer.canvas.getBoundingClientRect();
  const caster = new Raycaster();
  viewer.scene.updateMatrixWorld(); // what is seen now, drawn or not
  viewer.camera.updateMatrixWorld();
  caster.setFromCamera(new Vector2((2 * (x - area.left)) / area.width - 1, 1 - (2 * (y - area.top)) / area.height), viewer.camera);
  /** @type {import("three").Object3D[]} */
  const solids = [];
  for (const group of [viewer.robot.group, ...[...viewer.bodies.values()].map((figure) => figure.group)]) {
    group.traverse((part) => { if (part instanceof Mesh) solids.push(part); }); // edges would be hit from far off
  }
  const [first] = caster.intersectObjects(solids, false);
  if (!first) return "";
  for (const figure of viewer.bodies.values()) {
    for (let part = /** @type {import("three").Object3D | null} */ (first.object); part; part = part.parent) if (part === figure.group) return figure.name;
  }
  return "";
}

/** Select by clicks in the picture, and draw what is selected with bright edges. @param {import("./world.js").World} world */
export function mountSelection(world) {
  /** @type {Group | null} */
  let drawn = null;
  const draw = () => {
    drawn?.removeFromParent();
    drawn?.traverse((part) => {
      if (part instanceof LineSegments) {
        part.geometry.dispose();
        part.material.dispose();
      }
    });
    drawn = null;
    const viewer = world.viewer;
    const figure = viewer?.bodies.get(name);
    const data = viewer?.data.bodies.find((body) => body.name === name);
    if (!viewer) return;
    if (figure && data) {
      drawn = new Group();
      for (const piece of data.pieces) {
        const edges = new LineSegments(new EdgesGeometry(pieceGeometry(piece), EDGE_ANGLE), new LineBasicMaterial({ color: CHOSEN, depthTest: false, transparent: true }));
        edges.renderOrder = 15;
        drawn.add(edges);
      }
      figure.group.add(drawn);
    }
    viewer.requestDraw();
  };
  onSelect(draw);
  world.sceneWatchers.push((viewer) => {
    if (!viewer) return;
    if (!viewer.bodies.has(name)) select("");
    draw();
    bindClicks(viewer);
  });
}

/** @param {import("../viewer/viewer.js").Viewer} viewer */
function bindClicks(viewer) {
  let [x, y, since] = [0, 0, -Infinity];
  viewer.canvas.addEventListener("pointerdown", (event) => {
    [x, y, since] = [event.clientX, event.clientY, event.isPrimary && event.button === 0 ? event.timeStamp : -Infinity];
  });
  viewer.canvas.addEventListener("pointerup", (event) => {
    const still = Math.hypot(event.clientX - x, event.clientY - y) < STILL && event.timeStamp - since < QUICK;
    since = -Infinity;
    if (!still || !viewer.controls.enabled) return; // a drag, or a handle of the pointer is held
    select(pickers.map((at) => at(event.clientX, event.clientY)).find(Boolean) || bodyAt(viewer, event.clientX, event.clientY));
  });
}

/** Return the middle of a body's upper side [m], for what is written above it. @param {import("three").Object3D} group */
export function topOf(group) {
  group.updateMatrixWorld(true);
  const box = new Box3().setFromObject(group);
  return [(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.max.z];
}
