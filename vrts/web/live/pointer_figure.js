// The virtual pointer as three.js objects: a ghost gripper on an arrow, handles at its ends, a ring.

import { BufferGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Group, Line, LineBasicMaterial,
  LineDashedMaterial, LineSegments, Mesh, MeshBasicMaterial, RingGeometry, Vector3 } from "three";
import { place } from "../viewer/figures.js";
import { compose } from "../viewer/poses.js";
import { pieceGeometry } from "../viewer/shapes.js";
import { approach, matrixOf, tip } from "./pointer_pose.js";
import { Handles } from "./pointing/handles.js";
import { Screen } from "./pointing/screen.js";
import { GhostArm, WayFigure } from "./pointing/way_figure.js";

/** @typedef {import("./pointer_pose.js").PointerPose} PointerPose */
/** @typedef {import("./pointer_reach.js").ReachState} ReachState */

export const COLORS = { yes: 0x0ca678, way: 0xf08c00, touches: 0xe03131, no: 0x9c36b5, asking: 0x4c7fb8, unknown: 0x868e96 };
const UP = new Vector3(0, 1, 0); // of cylinders and cones

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

/** Everything that is drawn of the pointer. Keeps no pose. */
export class PointerFigure extends Group {
  /**
   * @param {import("../viewer/viewer.js").SceneData} data
   * @param {import("three").PerspectiveCamera} camera from which the handles keep their size
   * @param {HTMLCanvasElement} canvas
   */
  constructor(data, camera, canvas) {
    super();
    this.screen = new Screen(camera, canvas);
    this.data = data;
    /** @type {MeshBasicMaterial[]} */
    this.tinted = [];
    /** @type {{side: number, made: Group}[]} */
    this.fingers = [];
    this.ghost = this.makeGhost();
    this.shaft = drawn(new CylinderGeometry(0.0042, 0.0042, 1, 14), this.tint(0.95), 29);
    this.head = drawn(new ConeGeometry(0.0135, 0.04, 24), this.tint(1), 29);
    this.handles = new Handles(this.screen);
    this.way = new WayFigure(this.screen);
    this.arm = new GhostArm(data.robot);
    this.plumb = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, -1)]),
      new LineDashedMaterial({ color: 0x868e96, dashSize: 0.012, gapSize: 0.009, transparent: true, opacity: 0.9 }));
    this.spot = new Mesh(new RingGeometry(0.012, 0.017, 32), new MeshBasicMaterial({ color: 0x868e96, transparent: true, opacity: 0.8, depthWrite: false }));
    this.add(this.ghost, this.shaft, this.head, this.plumb, this.spot, this.arm, this.way, this.handles);
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
    const [base, end] = [new Vector3().fromArray(pose.point), new Vector3().fromArray(tip(pose))];
    const ahead = new Vector3().fromArray(approach(pose));
    this.shaft.position.lerpVectors(base, end, 0.5);
    this.shaft.quaternion.setFromUnitVectors(UP, ahead);
    this.shaft.scale.y = pose.length;
    this.head.quaternion.copy(this.shaft.quaternion);
    this.head.position.copy(end).addScaledVector(ahead, -0.02);
    this.handles.set(pose, stage);
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

  /** Show what is known of the way to where the pointer is. @param {import("./pointer_reach.js").Answer} answer */
  showWay({ state, reached }) {
    this.paintReach(state);
    this.arm.show(reached?.reachable ? reached.joints_rad : null, state === "touches" ? reached?.touches ?? [] : []);
    this.way.show(reached?.path_m ?? [], reached?.touches ?? []);
  }

  /**
   * Keep the handles as large as they look, whatever the distance.
   * @override
   */
  updateMatrixWorld(/** @type {boolean} */ force) {
    if (this.visible) {
      this.handles.follow();
      this.way.follow();
    }
    super.updateMatrixWorld(force);
  }

  /** Free what the graphics card holds. */
  dispose() {
    this.way.free();
    this.removeFromParent();
    this.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) {
        part.geometry.dispose();
        part.material.dispose();
      }
    });
  }
}
