// The virtual pointer as three.js objects: a ghost gripper on an arrow, handles at its ends, a ring.

import { BufferGeometry, CircleGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, EdgesGeometry,
  Group, Line, LineBasicMaterial, LineDashedMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial,
  PlaneGeometry, Quaternion, RingGeometry, SphereGeometry, TorusGeometry, Vector3 } from "three";
import { place } from "../viewer/figures.js";
import { compose } from "../viewer/poses.js";
import { pieceGeometry } from "../viewer/shapes.js";
import { approach, matrixOf, tip } from "./pointer_pose.js";

/** @typedef {import("./pointer_pose.js").PointerPose} PointerPose */
/** @typedef {"asking"|"yes"|"no"|"unknown"} ReachState */

export const COLORS = { yes: 0x0ca678, no: 0xe03131, asking: 0x4c7fb8, unknown: 0x868e96 };
const RED = 0xe8590c, GREEN = 0x37a33c, BLUE = 0x1c7ed6;
const HANDLE = 0.013; // radius of a handle, as a share of the distance from the eye
const AXIS = 0.075; // length of the axes at the ends, in the same way
export const RING = 0.11; // radius of the ring about the arrow [m]
const UP = new Vector3(0, 1, 0); // of cylinders and cones
const Z = new Vector3(0, 0, 1);

/** @param {number} color @param {number} opacity */
function paint(color, opacity = 1) {
  return new MeshBasicMaterial({ color, transparent: true, opacity, depthTest: false, depthWrite: false,
    toneMapped: false, side: DoubleSide });
}

/** @param {BufferGeometry} geometry @param {MeshBasicMaterial} material @param {number} order */
function drawn(geometry, material, order) {
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = order;
  return mesh;
}

/** The frame at one end of the arrow: a ball with a square for the plane, an axis for the height. */
class EndFrame extends Group {
  /** @param {number} way of the axis for the height: 1 up, -1 down @param {number} color of the ball */
  constructor(way, color) {
    super();
    this.way = way;
    this.ball = drawn(new SphereGeometry(HANDLE, 24, 16), paint(color), 32);
    this.square = drawn(new PlaneGeometry(0.062, 0.062), paint(BLUE, 0.28), 30);
    this.add(this.square, this.ball);
    this.add(arm(new Vector3(1, 0, 0), RED, 0.75), arm(new Vector3(0, 1, 0), GREEN, 0.75));
    this.axis = arm(new Vector3(0, 0, way), BLUE, 1);
    this.add(this.axis);
  }

  /** Return where the handle for the height is, in the world. */
  top() {
    return this.position.clone().addScaledVector(Z, this.way * AXIS * this.scale.x);
  }
}

/** An axis with a head. @param {Vector3} direction @param {number} color @param {number} share */
function arm(direction, color, share) {
  const group = new Group();
  const rod = drawn(new CylinderGeometry(0.0032, 0.0032, AXIS * share, 10), paint(color), 31);
  rod.position.y = (AXIS * share) / 2;
  const head = drawn(new ConeGeometry(0.0095, 0.024, 20), paint(color), 31);
  head.position.y = AXIS * share;
  group.add(rod, head);
  group.quaternion.setFromUnitVectors(UP, direction);
  return group;
}

/** Everything that is drawn of the pointer. Keeps no pose. */
export class PointerFigure extends Group {
  /**
   * @param {import("../viewer/viewer.js").SceneData} data
   * @param {import("three").Camera} camera from which the handles keep their size
   */
  constructor(data, camera) {
    super();
    this.camera = camera;
    this.data = data;
    /** @type {MeshBasicMaterial[]} */
    this.tinted = [];
    /** @type {{side: number, made: Group}[]} */
    this.fingers = [];
    /** @type {Mesh[]} */
    this.knobs = [];
    this.ghost = this.makeGhost();
    this.shaft = drawn(new CylinderGeometry(0.0042, 0.0042, 1, 14), this.tint(0.95), 29);
    this.head = drawn(new ConeGeometry(0.0135, 0.04, 24), this.tint(1), 29);
    this.base = new EndFrame(1, 0xffffff);
    this.tip = new EndFrame(-1, 0xffd43b);
    this.ring = this.makeRing();
    this.plumb = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, -1)]),
      new LineDashedMaterial({ color: 0x868e96, dashSize: 0.012, gapSize: 0.009, transparent: true, opacity: 0.9 }));
    this.spot = new Mesh(new RingGeometry(0.012, 0.017, 32), new MeshBasicMaterial({ color: 0x868e96, transparent: true, opacity: 0.8, depthWrite: false }));
    this.add(this.ghost, this.shaft, this.head, this.plumb, this.spot, this.base, this.tip, this.ring);
    this.paintReach("unknown");
  }

  /** @param {number} opacity @returns {MeshBasicMaterial} that has the colour of the reach */
  tint(opacity) {
    const material = paint(COLORS.unknown, opacity);
    this.tinted.push(material);
    return material;
  }

  /** The gripper, see-through. */
  makeGhost() {
    const group = new Group();
    const skin = this.tint(0.22);
    skin.depthTest = true;
    const line = new LineBasicMaterial({ color: COLORS.unknown, transparent: true, opacity: 0.85 });
    this.outline = line;
    const part = (/** @type {import("../viewer/shapes.js").PieceData[]} */ pieces) => {
      const made = new Group();
      for (const piece of pieces) {
        const geometry = pieceGeometry(piece);
        made.add(new Mesh(geometry, skin), new LineSegments(new EdgesGeometry(geometry, 32), line));
      }
      group.add(made);
      return made;
    };
    const { body, fingers } = this.data.robot.gripper;
    part(body);
    this.fingers = fingers.map((finger) => ({ side: finger.side, made: part(finger.pieces) }));
    return group;
  }

  /** A ring with two knobs where the fingers are, and a faint disc. */
  makeRing() {
    const group = new Group();
    group.add(drawn(new CircleGeometry(RING, 64), paint(BLUE, 0.1), 30));
    group.add(drawn(new TorusGeometry(RING, 0.0035, 12, 96), paint(BLUE, 0.95), 31));
    this.knobs = [-1, 1].map((side) => {
      const knob = drawn(new SphereGeometry(HANDLE, 24, 16), paint(side > 0 ? 0xffd43b : 0xffffff), 32);
      knob.position.y = side * RING;
      group.add(knob);
      return knob;
    });
    return group;
  }

  /**
   * Draw a pose.
   * @param {PointerPose} pose
   * @param {import("../viewer/poses.js").Pose} X_TF flange in the tool frame
   * @param {number} opening of the hand [m]
   * @param {1|2} stage
   */
  draw(pose, X_TF, opening, stage) {
    const X = matrixOf(pose);
    place(this.ghost, compose(X, X_TF));
    for (const { side, made } of this.fingers) made.position.y = (side * opening) / 2;
    this.base.position.fromArray(pose.point);
    this.tip.position.fromArray(tip(pose));
    const ahead = new Vector3().fromArray(approach(pose));
    this.shaft.position.lerpVectors(this.base.position, this.tip.position, 0.5);
    this.shaft.quaternion.setFromUnitVectors(UP, ahead);
    this.shaft.scale.y = pose.length;
    this.head.quaternion.copy(this.shaft.quaternion);
    this.head.position.copy(this.tip.position).addScaledVector(ahead, -0.02);
    this.base.visible = this.tip.visible = stage === 1;
    this.ring.visible = stage === 2;
    this.ring.position.copy(this.base.position);
    this.ring.quaternion.copy(new Quaternion().setFromRotationMatrix(new Matrix4().fromArray(Array.from(X))));
    this.tip.way = ahead.z > 0.3 ? 1 : -1;
    this.base.way = -this.tip.way;
    for (const end of [this.base, this.tip]) end.axis.quaternion.setFromUnitVectors(UP, new Vector3(0, 0, end.way));
    this.dropPlumb(pose.point);
  }

  /** Show what is below the tool point. @param {[number, number, number]} point */
  dropPlumb([x, y, z]) {
    const { table, floor } = this.data;
    const onTable = table && z >= table.z && x >= table.x0 && x <= table.x1 && y >= table.y0 && y <= table.y1;
    const ground = onTable ? table.z : floor;
    const drop = z - ground;
    this.plumb.visible = this.spot.visible = drop > 0.01;
    this.plumb.position.set(x, y, z);
    this.plumb.geometry.setFromPoints([new Vector3(), new Vector3(0, 0, -drop)]);
    this.plumb.computeLineDistances();
    this.spot.position.set(x, y, ground + 0.002);
  }

  /** @param {ReachState} state */
  paintReach(state) {
    this.reach = state;
    const color = new Color(COLORS[state]);
    for (const material of this.tinted) material.color.copy(color);
    this.outline?.color.copy(color);
  }

  /**
   * Keep the handles as large as they look, whatever the distance.
   * @override
   */
  updateMatrixWorld(/** @type {boolean} */ force) {
    const eye = this.camera.position;
    for (const end of [this.base, this.tip]) end.scale.setScalar(0.6 * eye.distanceTo(end.position));
    const share = 0.6 * eye.distanceTo(this.ring.position);
    for (const knob of this.knobs) knob.scale.setScalar(share);
    super.updateMatrixWorld(force);
  }

  /** Where a knob of the ring is, in the world. @param {number} index */
  knobAt(index) {
    this.ring.updateMatrixWorld(true);
    return this.knobs[index].getWorldPosition(new Vector3());
  }

  /** Free what the graphics card holds. */
  dispose() {
    this.removeFromParent();
    this.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) {
        part.geometry.dispose();
        part.material.dispose();
      }
    });
  }
}
