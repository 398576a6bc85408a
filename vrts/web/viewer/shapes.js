// Convex pieces as triangles, with rounded edges and normals that make them look machined.

import {
  BufferAttribute, BufferGeometry, BoxGeometry, CylinderGeometry, LatheGeometry, Matrix4, Vector2,
  Vector3,
} from "three";
import { poseFrom } from "./poses.js";

/**
 * @typedef {object} PieceData
 * @property {"box"|"cylinder"|"hull"} shape
 * @property {number[]} [half] box: half extents [m]
 * @property {number} [radius] cylinder [m]
 * @property {number} [halfLength] cylinder, along z [m]
 * @property {number[]} [vertices] hull: x y z of every corner [m]
 * @property {number[]} [triangles] hull: three corners each, seen counter-clockwise from outside
 * @property {number[]} [color] linear RGB, where it is not the body's
 * @property {number[]} X pose of the piece in its body, twelve numbers
 */

const ROUNDING = 0.006; // radius of edges [m]
const SMOOTH = Math.cos((38 * Math.PI) / 180); // faces that meet flatter than this look curved

/**
 * Return the triangles of a piece in its body's frame.
 * @param {PieceData} piece
 * @returns {BufferGeometry}
 */
export function pieceGeometry(piece) {
  const geometry = rawGeometry(piece);
  geometry.applyMatrix4(new Matrix4().fromArray(Array.from(poseFrom(piece.X))));
  return geometry;
}

/**
 * @param {PieceData} piece
 * @returns {BufferGeometry}
 */
function rawGeometry(piece) {
  if (piece.shape === "box") return roundedBox(...triple(piece.half ?? [0, 0, 0]));
  if (piece.shape === "cylinder") return roundedCylinder(piece.radius ?? 0, piece.halfLength ?? 0);
  return creased(piece.vertices ?? [], piece.triangles ?? []);
}

/**
 * @param {number[]} values
 * @returns {[number, number, number]}
 */
function triple(values) {
  return [values[0], values[1], values[2]];
}

/**
 * Return a box whose edges are rounded: a finely cut cube pulled onto the rounded surface.
 * @param {number} hx @param {number} hy @param {number} hz half extents [m]
 */
function roundedBox(hx, hy, hz) {
  const radius = Math.min(ROUNDING, hx / 3, hy / 3, hz / 3);
  const cuts = 3;
  const geometry = new BoxGeometry(2, 2, 2, cuts * 2 + 1, cuts * 2 + 1, cuts * 2 + 1);
  const position = geometry.getAttribute("position");
  const normal = geometry.getAttribute("normal");
  const half = new Vector3(hx, hy, hz);
  const step = 1 / (cuts * 2 + 1);
  for (let i = 0; i < position.count; i++) {
    const corner = new Vector3().fromBufferAttribute(position, i);
    const outward = new Vector3();
    const inner = new Vector3();
    for (const axis of /** @type {const} */ (["x", "y", "z"])) {
      // grid index from the middle: 0 is the last flat row, `cuts` the edge of the cube
      const beyond = Math.max(0, Math.abs(corner[axis]) / (2 * step) - 0.5) / cuts;
      outward[axis] = Math.sign(corner[axis]) * Math.tan((Math.min(beyond, 1) * Math.PI) / 4);
      inner[axis] = Math.sign(corner[axis]) * (half[axis] - radius);
    }
    outward.normalize();
    position.setXYZ(i, inner.x + radius * outward.x, inner.y + radius * outward.y,
      inner.z + radius * outward.z);
    normal.setXYZ(i, outward.x, outward.y, outward.z);
  }
  geometry.deleteAttribute("uv");
  return geometry;
}

/**
 * Return a cylinder along z whose rims are rounded.
 * @param {number} radius @param {number} half half the length [m]
 */
function roundedCylinder(radius, half) {
  const edge = Math.min(ROUNDING, radius / 3, half / 3);
  const profile = [new Vector2(0, -half)];
  for (const [sign, from] of [[-1, 0], [1, 1]]) {
    for (let k = 0; k <= 4; k++) {
      const angle = ((from ? 4 - k : k) / 4) * (Math.PI / 2);
      profile.push(new Vector2(radius - edge + edge * Math.sin(angle),
        sign * (half - edge + edge * Math.cos(angle))));
    }
  }
  profile.push(new Vector2(0, half));
  const geometry = new LatheGeometry(profile, 56);
  geometry.rotateX(Math.PI / 2); // the lathe turns about y
  geometry.deleteAttribute("uv");
  return geometry;
}

/**
 * Return triangles whose corners share a normal only where the surface is nearly flat.
 * @param {number[]} vertices @param {number[]} triangles
 */
function creased(vertices, triangles) {
  const faces = triangles.length / 3;
  const corner = (/** @type {number} */ i) => new Vector3().fromArray(vertices, 3 * triangles[i]);
  const normals = [];
  /** @type {Map<number, number[]>} */
  const around = new Map();
  for (let face = 0; face < faces; face++) {
    const [a, b, c] = [corner(3 * face), corner(3 * face + 1), corner(3 * face + 2)];
    normals.push(b.sub(a).cross(c.sub(a))); // its length weighs large faces more
    for (let k = 0; k < 3; k++) {
      const vertex = triangles[3 * face + k];
      around.set(vertex, [...(around.get(vertex) ?? []), face]);
    }
  }
  const unit = normals.map((n) => n.clone().normalize());
  const position = new Float32Array(9 * faces);
  const normal = new Float32Array(9 * faces);
  for (let i = 0; i < 3 * faces; i++) {
    const face = Math.floor(i / 3);
    const sum = new Vector3();
    for (const other of around.get(triangles[i]) ?? []) {
      if (unit[other].dot(unit[face]) > SMOOTH) sum.add(normals[other]);
    }
    corner(i).toArray(position, 3 * i);
    sum.normalize().toArray(normal, 3 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("normal", new BufferAttribute(normal, 3));
  return geometry;
}

/**
 * Return the cylinder geometry of a thin ring, for rims of cans.
 * @param {number} radius @param {number} height [m]
 */
export function ring(radius, height) {
  return new CylinderGeometry(radius, radius, height, 48, 1, false).rotateX(Math.PI / 2);
}
