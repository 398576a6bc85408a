// The robot and the bodies as three.js objects, moved by poses.

import { DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial,
  MeshStandardMaterial, Object3D } from "three";
import { bodyMaterial, gripperMaterial, linkMaterial, metal } from "./look.js";
import { poseFrom } from "./poses.js";
import { pieceGeometry, ring } from "./shapes.js";

/** @typedef {import("./shapes.js").PieceData} PieceData */
/** @typedef {import("./poses.js").Pose} Pose */

/**
 * @typedef {object} BodyData
 * @property {string} name
 * @property {string} title
 * @property {string} kind
 * @property {boolean} movable
 * @property {number[]} color linear RGB
 * @property {PieceData[]} pieces
 * @property {number[]} X pose in the world at the start, twelve numbers
 */

/**
 * @typedef {object} RobotData
 * @property {import("./kinematics.js").Arm} arm
 * @property {{name: string, joint: number, pieces: PieceData[]}[]} links
 * @property {{openingMin: number, openingMax: number, body: PieceData[], fingers: {name: string, side: number, pieces: PieceData[]}[]}} gripper
 */

const EDGE_ANGLE = 32; // [deg]

/** @param {Pose} X @param {Object3D} object */
export function place(object, X) {
  object.matrixAutoUpdate = false;
  object.matrix.fromArray(X);
  object.matrixWorldNeedsUpdate = true;
}

/** The arm with its gripper. */
export class RobotFigure {
  /** @param {RobotData} data */
  constructor(data) {
    this.group = new Group();
    this.links = data.links.map((link) => {
      const group = new Group();
      for (const piece of link.pieces) group.add(solid(piece, linkMaterial(link.name, piece.shape)));
      this.group.add(group);
      return { joint: link.joint, group };
    });
    this.hand = new Group();
    for (const piece of data.gripper.body) this.hand.add(solid(piece, gripperMaterial("body")));
    this.fingers = data.gripper.fingers.map((finger) => {
      const group = new Group();
      for (const piece of finger.pieces) group.add(solid(piece, gripperMaterial("finger")));
      this.hand.add(group);
      return { side: finger.side, group };
    });
    this.group.add(this.hand);
  }

  /** @param {import("./replay.js").State} state */
  show(state) {
    for (const { joint, group } of this.links) place(group, state.X_WL[joint]);
    place(this.hand, state.X_WF);
    for (const { side, group } of this.fingers) group.position.y = (side * state.q[6]) / 2;
  }
}

/** One body of the scene. */
export class BodyFigure {
  /** @param {BodyData} data */
  constructor(data) {
    this.name = data.name;
    this.group = new Group();
    for (const piece of data.pieces) {
      this.group.add(solid(piece, bodyMaterial(data.kind, piece.color ?? data.color)));
      if (data.kind === "can" && piece.shape === "cylinder") this.group.add(...lids(piece));
    }
  }

  /** @param {Pose} X */
  show(X) {
    place(this.group, X);
  }
}

/**
 * Return a see-through copy of a body: where a goal wants it.
 * @param {BodyData} data @param {Pose} X @param {number} color
 */
export function ghost(data, X, color) {
  const group = new Group();
  for (const piece of data.pieces) {
    const geometry = pieceGeometry(piece);
    const skin = new MeshBasicMaterial({ color, transparent: true, opacity: 0.16, depthWrite: false, side: DoubleSide });
    group.add(new Mesh(geometry, skin), edges(geometry, color, 0.7));
  }
  place(group, X);
  return group;
}

/**
 * Paint an object in one glowing colour, or give it its own back.
 * @param {Object3D} object @param {number | null} color
 */
export function tint(object, color) {
  object.traverse((part) => {
    const material = part instanceof Mesh ? part.material : null;
    if (!(material instanceof MeshStandardMaterial)) return;
    part.userData.own ??= material.color.clone();
    if (color === null) material.color.copy(part.userData.own);
    else material.color.setHex(color);
    material.emissive.setHex(color ?? 0);
    material.emissiveIntensity = color === null ? 0 : 0.35;
  });
}

/** @param {PieceData} piece @param {import("three").Material} material */
function solid(piece, material) {
  const geometry = pieceGeometry(piece);
  const mesh = new Mesh(geometry, material);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  if (piece.shape === "hull") mesh.add(edges(geometry, 0x000000, 0.16));
  return mesh;
}

/** @param {import("three").BufferGeometry} geometry */
function edges(geometry, /** @type {number} */ color, /** @type {number} */ opacity) {
  return new LineSegments(new EdgesGeometry(geometry, EDGE_ANGLE),
    new LineBasicMaterial({ color, transparent: true, opacity }));
}

/**
 * Return the bright lids of a can: they tell its ends from its side.
 * @param {PieceData} piece
 */
function lids(piece) {
  const radius = piece.radius ?? 0;
  const half = piece.halfLength ?? 0;
  return [-1, 1].map((side) => {
    const lid = new Mesh(ring(radius * 0.93, 0.0016), metal(0xd9dcdf, 0.25));
    lid.position.z = side * half;
    const holder = new Group();
    holder.add(lid);
    holder.applyMatrix4(new Matrix4().fromArray(Array.from(poseFrom(piece.X))));
    return holder;
  });
}
