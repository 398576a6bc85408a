// How far it is from one point to another: of objects, the tool and the pointer, or where somebody clicks.

import { BufferGeometry, Line, LineBasicMaterial, Mesh, Raycaster, Vector2, Vector3 } from "three";
import { button, choice, figure, make, write } from "../dom.js";
import { poseFrom } from "../../viewer/poses.js";

const COLOR = 0xd6336c;
const CLICKED = "clicked";

/** @typedef {[number, number, number]} Point [m] */

/**
 * Return a distance in words.
 * @param {Point} a @param {Point} b
 */
export function measured(a, b) {
  const by = a.map((value, i) => (b[i] - value) * 1000);
  const parts = ["dx", "dy", "dz"].map((name, i) => `${name} ${figure(by[i], 1)}`);
  return `${figure(Math.hypot(...by), 1)} mm: ${parts.join(", ")}`;
}

/** @param {import("./tools.js").Around} around @returns {HTMLElement} */
export function mountMeasure({ store, world, pointer }) {
  /** @type {(Point | null)[]} */
  const clicked = [null, null];
  /** @type {number | null} */
  let waits = null; // for which end a click counts
  /** @type {Line<LineBasicMaterial> | null} */
  let line = null;
  const ends = ["From", "To"].map((name, i) => {
    const list = choice([], { id: `measure-${name.toLowerCase()}`, change: show });
    const pick = button("Pick", () => wait(waits === i ? null : i), { "aria-label": `Pick in the picture: ${name}`, "aria-pressed": "false" });
    return { list, pick, row: make("div", { class: "row" }, make("label", { for: list.id }, name, list), pick) };
  });
  const said = make("output", { class: "measured", id: "measured", for: "measure-from measure-to", "aria-live": "off" });
  const box = make("details", { class: "block", toggle: show }, make("summary", { text: "Measure" }), ...ends.map(({ row }) => row), said);

  /** @param {number | null} end */
  function wait(end) {
    waits = end;
    ends.forEach(({ pick }, i) => pick.setAttribute("aria-pressed", String(i === end)));
  }

  /** Offer what can be measured. */
  function offer() {
    const bodies = world.viewer?.data.bodies.filter(({ kind }) => kind !== "floor") ?? [];
    ends.forEach(({ list }, i) => {
      const chosen = list.value || ["tool", "pointer"][i];
      list.replaceChildren(...[["tool", "the tool's point"], ["pointer", "the pointer"], ...bodies.map(({ name }) => [`body ${name}`, `${name} (foot)`]),
        ...(clicked[i] ? [[CLICKED, "the point picked"]] : [])].map(([value, text]) => make("option", { value, text })));
      list.value = chosen;
      if (!list.value) list.value = "tool";
    });
  }

  /** @param {number} end @returns {Point | null} */
  function pointOf(end) {
    const what = ends[end].list.value;
    if (what === CLICKED) return clicked[end];
    if (what === "pointer") return pointer()?.pose.point ?? null;
    if (what === "tool") return world.state ? at(world.state.X_WT) : null;
    const name = what.replace(/^body /, "");
    const data = world.viewer?.data.bodies.find((body) => body.name === name);
    const X = world.state?.bodies.get(name) ?? (data && poseFrom(data.X));
    return X ? at(X) : null;
  }

  function show() {
    line?.removeFromParent();
    line?.geometry.dispose();
    line?.material.dispose();
    line = null;
    const [a, b] = [pointOf(0), pointOf(1)];
    write(said, a && b ? measured(a, b) : "choose two points");
    if (a && b && box.open && world.viewer) {
      line = new Line(new BufferGeometry().setFromPoints([new Vector3(...a), new Vector3(...b)]),
        new LineBasicMaterial({ color: COLOR, depthTest: false, transparent: true }));
      line.renderOrder = 36;
      world.viewer.scene.add(line);
    }
    world.viewer?.requestDraw();
  }

  let shown = "";
  world.watchers.push(() => { // what is measured may move
    if (!box.open) return;
    const key = JSON.stringify([pointOf(0), pointOf(1)]);
    if (key !== shown) show();
    shown = key;
  });
  const renew = () => {
    clicked.fill(null);
    offer();
    show();
  };
  store.on(["places"], renew);
  world.sceneWatchers.push((viewer) => viewer && renew());
  document.addEventListener("panel", () => wait(null)); // who goes elsewhere picks nothing
  document.addEventListener("pointerdown", (event) => {
    const { viewer } = world;
    if (waits === null || !viewer || event.target !== viewer.canvas || event.button !== 0) return;
    const hit = hitAt(viewer, event.clientX, event.clientY);
    if (!hit) return;
    event.preventDefault();
    event.stopPropagation(); // neither a drag nor a selection
    const end = waits;
    clicked[end] = hit;
    wait(null);
    offer();
    ends[end].list.value = CLICKED;
    show();
  }, true);
  return box;
}

/** @param {ArrayLike<number>} X @returns {Point} */
function at(X) {
  return [X[12], X[13], X[14]];
}

/**
 * Return the point of a surface that is seen at a place of the window; null: nothing is there.
 * @param {import("../../viewer/viewer.js").Viewer} viewer @param {number} x @param {number} y [px]
 * @returns {Point | null}
 */
function hitAt(viewer, x, y) {
  const area = viewer.canvas.getBoundingClientRect();
  const caster = new Raycaster();
  viewer.camera.updateMatrixWorld();
  caster.setFromCamera(new Vector2((2 * (x - area.left)) / area.width - 1, 1 - (2 * (y - area.top)) / area.height), viewer.camera);
  /** @type {import("three").Object3D[]} */
  const solids = [];
  for (const group of [viewer.robot.group, ...[...viewer.bodies.values()].map((figure) => figure.group)]) {
    group.traverse((part) => { if (part instanceof Mesh) solids.push(part); });
  }
  const [first] = caster.intersectObjects(solids, false);
  return first ? first.point.toArray() : null;
}
