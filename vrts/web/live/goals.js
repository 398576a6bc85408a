// What a task wants, drawn in the scene: ghosts in the colours of their objects, via points, zones, and lines between things that belong together.

import {
  ArrowHelper, BoxGeometry, BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, Group, Line, LineBasicMaterial, LineDashedMaterial,
  LineSegments, Mesh, MeshBasicMaterial, SphereGeometry, Vector3,
} from "three";
import { place } from "../viewer/figures.js";
import { poseFrom } from "../viewer/poses.js";
import { pieceGeometry } from "../viewer/shapes.js";
import { topOf } from "./selection.js";

const EDGE_ANGLE = 32; // [degrees]
const SKIN = 0.2; // opacity of a ghost; more where its object is selected
const CHOSEN = 0.45;
const VIA = 0x7048e8;
const PASSED = 0x2f9e44;
const KEPT_OUT = 0xd6336c;
const ARROW = 0.16; // [m]
const LIGHTEST = 0.2; // luminance: ghosts of nearly white things are hard to see on a light ground

/** @typedef {import("./protocol.js").TaskView} TaskView */
/** @typedef {{text: string, body: string, kind: "goal"|"via"|"zone", point: () => number[], color: string}} Name what is written at it */

/** The goals of one task in one view. */
export class Goals {
  /** @param {import("../viewer/viewer.js").Viewer} viewer @param {TaskView} task */
  constructor(viewer, task) {
    this.viewer = viewer;
    this.task = task;
    this.group = new Group();
    /** @type {{body: string, skins: MeshBasicMaterial[]}[]} */
    this.ghosts = [];
    /** @type {{from: string, to: string, line: Line}[]} */
    this.ties = [];
    /** @type {Map<string, MeshBasicMaterial>} */
    this.balls = new Map();
    /** @type {Name[]} */
    this.names = [];
    this.draw();
    viewer.scene.add(this.group);
    viewer.requestDraw();
  }

  draw() {
    const { task, group } = this;
    for (const goal of task.goals) {
      const several = goal.places.length > 1;
      for (const spot of goal.places) {
        const body = this.viewer.data.bodies.find(({ name }) => name === spot.body);
        if (body) this.ghost(body, poseFrom(spot.X), several ? `a goal of ${spot.body}` : `goal of ${spot.body}`);
      }
      if (goal.box) this.box(goal.box, colorOf(this.viewer, goal.bodies[0]), { text: goal.title, body: goal.bodies[0], kind: "zone" });
      if (goal.other) this.tie(goal.bodies[0], goal.other);
    }
    for (const via of task.vias) {
      const skin = new MeshBasicMaterial({ color: VIA, transparent: true, opacity: 0.28, depthWrite: false });
      const ball = new Mesh(new SphereGeometry(via.radius, 32, 16), skin);
      ball.position.fromArray(via.point);
      this.balls.set(via.check, skin);
      group.add(ball);
      if (via.approach) {
        const way = new Vector3().fromArray(via.approach);
        group.add(new ArrowHelper(way, ball.position.clone().addScaledVector(way, -ARROW), ARROW, VIA, 0.04, 0.025));
      }
      this.names.push({ text: via.name, body: "", kind: "via", point: () => [via.point[0], via.point[1], via.point[2] + via.radius], color: "#7048e8" });
    }
    for (const zone of task.zones) this.box(zone, new Color(KEPT_OUT), { text: `keep out: ${zone.name}`, body: "", kind: "zone" });
  }

  /** @param {import("../viewer/figures.js").BodyData} body @param {import("../viewer/poses.js").Pose} X @param {string} text */
  ghost(body, X, text) {
    const color = colorOf(this.viewer, body.name);
    const group = new Group();
    const skins = body.pieces.map((piece) => {
      const geometry = pieceGeometry(piece);
      const skin = new MeshBasicMaterial({ color, transparent: true, opacity: SKIN, depthWrite: false, side: DoubleSide });
      group.add(new Mesh(geometry, skin), new LineSegments(new EdgesGeometry(geometry, EDGE_ANGLE), new LineBasicMaterial({ color, transparent: true, opacity: 0.85 })));
      return skin;
    });
    place(group, X);
    this.group.add(group);
    this.ghosts.push({ body: body.name, skins });
    const top = topOf(group);
    this.names.push({ text, body: body.name, kind: "goal", point: () => top, color: color.getStyle() });
  }

  /** @param {{lower: number[], upper: number[]}} corners @param {Color} color @param {{text: string, body: string, kind: "zone"}} name */
  box({ lower, upper }, color, name) {
    const size = upper.map((high, axis) => high - lower[axis]);
    const geometry = new BoxGeometry(size[0], size[1], size[2]);
    const box = new Group();
    box.add(new Mesh(geometry, new MeshBasicMaterial({ color, transparent: true, opacity: 0.12, depthWrite: false, side: DoubleSide })),
      new LineSegments(new EdgesGeometry(geometry), new LineBasicMaterial({ color, transparent: true, opacity: 0.8 })));
    box.position.set(...middle(lower, upper));
    this.group.add(box);
    const top = [(lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2, upper[2]];
    this.names.push({ ...name, point: () => top, color: color.getStyle() });
  }

  /** A dashed line from an object to the one that it is to stand by. @param {string} from @param {string} to names of bodies */
  tie(from, to) {
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(6), 3));
    const look = { color: colorOf(this.viewer, from), dashSize: 0.025, gapSize: 0.018, transparent: true, opacity: 0.9, depthTest: false };
    const line = new Line(geometry, new LineDashedMaterial(look));
    line.renderOrder = 12;
    line.frustumCulled = false; // its ends move
    this.group.add(line);
    this.ties.push({ from, to, line });
  }

  /** Follow the objects that lines lead from and to. */
  follow() {
    for (const { from, to, line } of this.ties) {
      const [a, b] = [from, to].map((name) => this.viewer.bodies.get(name)?.group);
      if (!a || !b) continue;
      const position = line.geometry.getAttribute("position");
      [a, b].forEach((group, end) => {
        const [x, y, z] = group.matrix.elements.slice(12, 15);
        position.setXYZ(end, x, y, z);
      });
      position.needsUpdate = true;
      line.computeLineDistances();
    }
  }

  /** @param {boolean} on */
  show(on) {
    this.group.visible = on;
    this.viewer.requestDraw();
  }

  /** Make the goals of what is selected stand out. @param {string} name */
  choose(name) {
    for (const { body, skins } of this.ghosts) for (const skin of skins) skin.opacity = body === name ? CHOSEN : SKIN;
    this.viewer.requestDraw();
  }

  /** Paint the via points that were passed. @param {Set<string>} checks */
  pass(checks) {
    for (const [check, skin] of this.balls) skin.color.setHex(checks.has(check) ? PASSED : VIA);
    this.viewer.requestDraw();
  }

  dispose() {
    this.group.removeFromParent();
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) {
        part.geometry.dispose();
        part.material.dispose();
      }
    });
    this.viewer.requestDraw();
  }
}

/** Return the colour of a body, dark enough for a ghost. @param {import("../viewer/viewer.js").Viewer} viewer @param {string} name */
export function colorOf(viewer, name) {
  const [r, g, b] = viewer.data.bodies.find((body) => body.name === name)?.color ?? [0.5, 0.5, 0.5];
  const light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const share = light > LIGHTEST ? LIGHTEST / light : 1;
  return new Color().setRGB(r * share, g * share, b * share);
}

/** @param {number[]} lower @param {number[]} upper @returns {[number, number, number]} */
function middle(lower, upper) {
  return [(lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2, (lower[2] + upper[2]) / 2];
}
