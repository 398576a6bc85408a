// What is known of the way to the pointer: the path of the tool, where something touches, and the arm at its end.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, OctahedronGeometry, RingGeometry, SphereGeometry, Sprite, Vector3 } from "three";
import { place } from "../../viewer/figures.js";
import { armFrames } from "../../viewer/kinematics.js";
import { label } from "../../viewer/labels.js";
import { pieceGeometry } from "../../viewer/shapes.js";

/** @typedef {import("../protocol.js").WayTouch} WayTouch */

const FREE = 0x1c7ed6;
const BAD = 0xe03131;
const DOT = 1.8; // radius of what marks the path [px]
const CROSS = 5; // half the size of what marks the path where it touches [px]
const TARGET = 11; // radius of the mark where it touches [px]
const TEXT = 19; // height of the words there [px]
const MOST = 4; // touches that are marked
const CROSSES = 16; // marks on the path at most

/** Marks that keep their size in the picture. */
export class WayFigure extends Group {
  /** @param {import("./screen.js").Screen} screen */
  constructor(screen) {
    super();
    this.screen = screen;
    this.line = new Line(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.95, depthTest: false }));
    this.line.renderOrder = 27;
    this.line.frustumCulled = false;
    this.marks = new Group();
    this.add(this.line, this.marks);
  }

  /** @param {number[]} path x y z of each point [m] @param {WayTouch[]} touches */
  show(path, touches) {
    this.free();
    const count = path.length / 3;
    this.visible = count > 1;
    if (!this.visible) return;
    const bad = (/** @type {number} */ i) => touches.some(({ start, end }) => i / (count - 1) >= start - 1e-9 && i / (count - 1) <= end + 1e-9);
    const colors = Array.from({ length: count }, (_, i) => new Color(bad(i) ? BAD : FREE).toArray()).flat();
    this.line.geometry = new BufferGeometry();
    this.line.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(path), 3));
    this.line.geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colors), 3));
    const at = (/** @type {number} */ share) => {
      const k = Math.min(Math.floor(share * (count - 1)), count - 2);
      const [a, b] = [k, k + 1].map((i) => new Vector3().fromArray(path, 3 * i));
      return a.clone().lerpVectors(a, b, share * (count - 1) - k);
    };
    for (let i = 0; i < count; i++) if (!bad(i)) this.mark(new SphereGeometry(DOT, 8, 6), new Vector3().fromArray(path, 3 * i), 0.9, FREE);
    for (const { start, end, point, parts } of touches.slice(0, MOST)) {
      const crosses = Math.max(Math.min(Math.round((end - start) * 2 * CROSSES), CROSSES), 1);
      for (let k = 0; k <= crosses; k++) this.mark(new OctahedronGeometry(CROSS), at(start + ((end - start) * k) / crosses), 0.95);
      this.mark(new SphereGeometry(CROSS, 16, 12), new Vector3(...point), 1);
      const ring = this.mark(new RingGeometry(TARGET - 2.5, TARGET, 32), new Vector3(...point), 1);
      ring.userData.faces = true;
      const words = label(`✕ ${parts.join(" touches ")}`, { height: 1, color: "#a51d1d", halo: "#ffffff", bold: true, onTop: true });
      words.position.set(...point);
      words.renderOrder = 40;
      words.center.set(-16 / (TEXT * words.scale.x), 0.5); // to the right of the mark
      words.userData.wide = words.scale.x;
      this.marks.add(words);
    }
  }

  /** @param {BufferGeometry} geometry one pixel to a unit @param {Vector3} point @param {number} opacity */
  mark(geometry, point, opacity, color = BAD) {
    const mesh = new Mesh(geometry, new MeshBasicMaterial({ color, transparent: true, opacity, depthTest: false, toneMapped: false, side: DoubleSide }));
    mesh.position.copy(point);
    mesh.renderOrder = 28;
    this.marks.add(mesh);
    return mesh;
  }

  /** Keep the size of all marks in the picture. */
  follow() {
    if (!this.visible) return;
    for (const mark of this.marks.children) {
      const pixel = this.screen.pixel(this.screen.depth(mark.position));
      if (mark instanceof Sprite) mark.scale.set(mark.userData.wide * TEXT * pixel, TEXT * pixel, 1);
      else mark.scale.setScalar(pixel);
      if (mark.userData.faces) mark.quaternion.copy(this.screen.camera.quaternion);
    }
  }

  /** Take away what was shown. */
  free() {
    this.line.geometry.dispose();
    for (const mark of [...this.marks.children]) {
      if (mark instanceof Mesh) mark.geometry.dispose();
      if (mark instanceof Sprite) mark.material.map?.dispose();
      if (mark instanceof Mesh || mark instanceof Sprite) mark.material.dispose();
      mark.removeFromParent();
    }
  }
}

/** The arm as it would stand at the pointer, see-through; what touches is red and has its edges drawn. */
export class GhostArm extends Group {
  /** @param {import("../../viewer/figures.js").RobotData} robot */
  constructor(robot) {
    super();
    this.robot = robot;
    this.visible = false;
    this.links = robot.links.filter(({ joint }) => joint > 0).map(({ name, joint, pieces }) => {
      const group = new Group();
      const skin = new MeshBasicMaterial({ color: FREE, transparent: true, opacity: 0.07, depthWrite: false });
      const line = new LineBasicMaterial({ color: FREE, transparent: true, opacity: 0.22 });
      for (const piece of pieces) {
        const geometry = pieceGeometry(piece);
        group.add(new Mesh(geometry, skin), new LineSegments(new EdgesGeometry(geometry, 32), line));
      }
      this.add(group);
      return { name, joint, group, skin, line };
    });
  }

  /** @param {number[] | null} joints [rad]; null: it cannot get there @param {WayTouch[]} touches there */
  show(joints, touches) {
    this.visible = joints !== null;
    if (!joints) return;
    const { X_BL } = armFrames(this.robot.arm, joints);
    const bad = new Set(touches.filter((touch) => touch.at_goal).flatMap((touch) => touch.parts));
    for (const { name, joint, group, skin, line } of this.links) {
      place(group, X_BL[joint]);
      const hit = bad.has(name);
      skin.color.setHex(hit ? BAD : FREE);
      line.color.setHex(hit ? BAD : FREE);
      skin.opacity = hit ? 0.4 : 0.07;
      line.opacity = hit ? 1 : 0.22;
    }
  }
}
