// The handles of the pointer as three.js objects: as large in the picture at every zoom, and apart.

import { ConeGeometry, CylinderGeometry, DoubleSide, Group, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry,
  Quaternion, SphereGeometry, TorusGeometry, Vector3 } from "three";
import { approach, matrixOf, tip } from "../pointer_pose.js";
import { APART, placesOf } from "./handle_places.js";

/** @typedef {import("../pointer_pose.js").PointerPose} PointerPose */
/** @typedef {"base"|"base-z"|"tip"|"tip-z"|"shaft"|"hand"|"turn"} Handle */

const BALL = 9; // radius [px]
const RIM = 10.5; // of the dark rim of a ball [px]
const SQUARE = 36; // side of the square that says: level [px]
const AXIS = 30; // length of the level axes [px]
const RING = 62; // radius of the ring about the arrow [px]
const [RED, GREEN, BLUE, YELLOW, WHITE, DARK] = [0xe8590c, 0x37a33c, 0x1c7ed6, 0xffd43b, 0xffffff, 0x1d2228];
const COARSE = window.matchMedia("(pointer: coarse)");
const UP = new Vector3(0, 1, 0); // of cylinders and cones
const Z = new Vector3(0, 0, 1);

/** @param {number} color @param {number} opacity */
function paint(color, opacity = 1) {
  return new MeshBasicMaterial({ color, transparent: true, opacity, depthTest: false, depthWrite: false, toneMapped: false, side: DoubleSide });
}

/** @param {import("three").BufferGeometry} geometry @param {MeshBasicMaterial} material @param {number} order */
function drawn(geometry, material, order) {
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = order;
  return mesh;
}

/** A ball with a dark rim, one pixel to a unit. @param {number} color */
function ball(color) {
  const group = new Group();
  group.add(drawn(new SphereGeometry(RIM, 24, 16), paint(DARK, 0.85), 33), drawn(new SphereGeometry(BALL, 24, 16), paint(color), 34));
  return group;
}

/** A head with a dark rim, one pixel to a unit; it points along its y. */
function head() {
  const group = new Group();
  group.add(drawn(new ConeGeometry(10.5, 24, 24), paint(DARK, 0.85), 33), drawn(new ConeGeometry(9, 20, 24), paint(BLUE), 34));
  return group;
}

/** A rod from one point to another. */
class Rod extends Mesh {
  /** @param {number} color @param {number} opacity */
  constructor(color, opacity) {
    super(new CylinderGeometry(1, 1, 1, 10), paint(color, opacity));
    this.renderOrder = 31;
  }

  /** @param {Vector3} from @param {Vector3} to @param {number} thick [m] */
  between(from, to, thick) {
    const way = to.clone().sub(from);
    const length = way.length();
    this.visible = length > 1e-6;
    if (!this.visible) return;
    this.position.lerpVectors(from, to, 0.5);
    this.quaternion.setFromUnitVectors(UP, way.multiplyScalar(1 / length));
    this.scale.set(thick, length, thick);
  }
}

/** The ball of one end with what belongs to it. */
class End {
  /** @param {number} color */
  constructor(color) {
    this.ball = ball(color);
    this.head = head();
    this.axis = new Rod(BLUE, 0.9);
    this.leader = new Rod(DARK, 0.6);
    this.level = new Group();
    this.level.add(drawn(new PlaneGeometry(SQUARE, SQUARE), paint(BLUE, 0.28), 30));
    for (const [x, y, color] of [[1, 0, RED], [0, 1, GREEN]]) {
      const rod = new Rod(color, 0.9);
      rod.between(new Vector3(), new Vector3(x, y, 0).multiplyScalar(AXIS), 1.4);
      this.level.add(rod);
    }
    this.parts = [this.level, this.leader, this.axis, this.head, this.ball];
  }
}

/** All handles of a pointer; they follow the camera by themselves. */
export class Handles extends Group {
  /** @param {import("./screen.js").Screen} screen */
  constructor(screen) {
    super();
    this.screen = screen;
    /** @type {1|2} */
    this.stage = 1;
    /** @type {PointerPose | null} */
    this.pose = null;
    this.base = new End(WHITE);
    this.tip = new End(YELLOW);
    this.ring = new Group();
    this.ring.add(drawn(new TorusGeometry(RING, 2, 12, 96), paint(BLUE, 0.95), 31));
    this.knobs = [ball(WHITE), ball(YELLOW)];
    this.placing = new Group();
    this.placing.add(...this.base.parts, ...this.tip.parts);
    this.turning = new Group();
    this.turning.add(this.ring, ...this.knobs);
    this.add(this.placing, this.turning);
  }

  /** @param {PointerPose} pose @param {1|2} stage */
  set(pose, stage) {
    this.pose = pose;
    this.stage = stage;
    this.placing.visible = stage === 1;
    this.turning.visible = stage === 2;
  }

  /** @returns {"fine"|"coarse"} */
  get by() {
    return COARSE.matches ? "coarse" : "fine";
  }

  /** Return where the handles are, in the world. @returns {[Handle, Vector3][]} */
  list() {
    if (this.stage === 2) return this.knobs.map((knob) => ["turn", knob.position]);
    const { base, tip: end } = this;
    return [["base", base.ball.position], ["tip", end.ball.position], ["base-z", base.head.position], ["tip-z", end.head.position]];
  }

  /** Put everything where it belongs for the camera as it is. */
  follow() {
    if (!this.pose || !this.visible) return;
    this.screen.camera.updateMatrixWorld();
    if (this.stage === 1) this.followEnds(this.pose);
    else this.followRing(this.pose);
  }

  /** @param {PointerPose} pose */
  followEnds(pose) {
    const { screen } = this;
    const [base, end] = [new Vector3().fromArray(pose.point), new Vector3().fromArray(tip(pose))];
    const depths = [screen.depth(base), screen.depth(end)];
    this.placing.visible = Math.min(...depths) > screen.camera.near;
    if (!this.placing.visible) return;
    const way = approach(pose)[2] > 0.3 ? -1 : 1;
    const places = placesOf({ base: screen.place(base), tip: screen.place(end), up: screen.direction(base, Z), way }, this.by);
    const put = (/** @type {End} */ one, /** @type {Vector3} */ anchor, /** @type {number} */ depth,
      /** @type {import("./screen.js").Place} */ at, /** @type {import("./screen.js").Place} */ height) => {
      const pixel = screen.pixel(depth);
      one.ball.position.copy(screen.point(at, depth));
      one.head.position.copy(screen.point(height, depth));
      one.leader.between(anchor, one.ball.position, pixel);
      one.axis.between(one.ball.position, one.head.position, 1.6 * pixel);
      one.head.quaternion.copy(one.axis.quaternion);
      one.level.position.copy(anchor);
      for (const part of [one.ball, one.head, one.level]) part.scale.setScalar(pixel);
    };
    put(this.base, base, depths[0], places.base, places.baseHeight);
    put(this.tip, end, depths[1], places.tip, places.tipHeight);
  }

  /** @param {PointerPose} pose */
  followRing(pose) {
    const { screen } = this;
    const centre = new Vector3().fromArray(pose.point);
    const depth = screen.depth(centre);
    this.turning.visible = depth > screen.camera.near;
    if (!this.turning.visible) return;
    const pixel = screen.pixel(depth);
    const X = new Matrix4().fromArray(Array.from(matrixOf(pose)));
    this.ring.position.copy(centre);
    this.ring.quaternion.copy(new Quaternion().setFromRotationMatrix(X));
    this.ring.scale.setScalar(pixel);
    const at = (/** @type {number} */ angle) => new Vector3(Math.cos(angle) * RING * pixel, Math.sin(angle) * RING * pixel, 0)
      .applyQuaternion(this.ring.quaternion).add(centre);
    const seen = (/** @type {number} */ angle) => {
      const [a, b] = [screen.place(at(angle)), screen.place(at(angle + Math.PI))];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    let angle = -Math.PI / 2; // where the fingers are, unless that is seen from its edge
    if (seen(angle) < APART[this.by]) {
      for (let k = 0; k < 12; k++) if (seen((k * Math.PI) / 12) > seen(angle)) angle = (k * Math.PI) / 12;
    }
    this.knobs.forEach((knob, k) => {
      knob.position.copy(at(angle + k * Math.PI));
      knob.scale.setScalar(screen.pixel(screen.depth(knob.position)));
    });
  }
}
