// Floor and measures: a grid in hundreds of millimetres, numbers along the axes, the base frame.

import {
  BufferAttribute, BufferGeometry, CircleGeometry, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, Vector3, ArrowHelper,
} from "three";
import { label } from "./labels.js";
import { THEMES } from "./colors.js";

const MINOR = 0.1; // [m]
const MAJOR = 0.5; // [m]
const REACH = 2.5; // half the side of the floor's grid [m]

/**
 * Return floor, grid and the base frame's axes.
 * @param {number} z height of the floor [m]
 * @param {keyof typeof THEMES} theme
 */
export function ground(z, theme) {
  const colors = THEMES[theme];
  const group = new Group();
  const floor = new Mesh(new CircleGeometry(9, 64), new MeshStandardMaterial({ color: colors.floor, roughness: 1 }));
  floor.receiveShadow = true;
  floor.position.z = z - 0.002;
  group.add(floor, grid(extent(-REACH, REACH, -REACH, REACH), z, MINOR, colors.minor, 0.45),
    grid(extent(-REACH, REACH, -REACH, REACH), z, MAJOR, colors.major, 0.9));
  for (let mm = 500; mm <= 2000; mm += 500) {
    group.add(number(`${mm} mm`, mm / 1000, -0.07, z + 0.01, theme, 0.085));
    group.add(number(`${mm} mm`, 0.09, mm / 1000, z + 0.01, theme, 0.085));
  }
  for (const [axis, color, name] of /** @type {const} */ ([
    [new Vector3(1, 0, 0), 0xd0453e, "x"], [new Vector3(0, 1, 0), 0x3f9142, "y"], [new Vector3(0, 0, 1), 0x3b6fd4, "z"],
  ])) {
    const length = name === "z" ? 0.25 : 0.55;
    group.add(new ArrowHelper(axis, new Vector3(0, 0, z + 0.004), length, color, 0.06, 0.03));
    const sign = label(name, { height: 0.08, color: `#${color.toString(16)}`, halo: colors.halo, bold: true });
    sign.position.copy(axis.clone().multiplyScalar(length + 0.05)).add(new Vector3(0, 0, z + 0.02));
    if (name !== "z") group.add(sign);
  }
  return group;
}

/**
 * Return the measures on a table top: lines every 100 mm of the world's x and y, numbers at its rim.
 * @param {{x0: number, x1: number, y0: number, y1: number, z: number}} top [m]
 * @param {keyof typeof THEMES} theme
 */
export function ruler(top, theme) {
  const group = new Group();
  const { x0, x1, y0, y1, z } = top;
  group.add(grid(extent(x0, x1, y0, y1), z + 0.0008, MINOR, 0x000000, 0.13));
  group.add(grid(extent(x0, x1, y0, y1), z + 0.0009, MAJOR, 0x000000, 0.25));
  for (let x = Math.ceil(x0 / MINOR + 0.3); x * MINOR <= x1 - 0.02; x++) {
    if (x % 2 === 0) group.add(number(`${x * 100}`, x * MINOR, y0 + 0.05, z + 0.02, theme, 0.055));
  }
  for (let y = Math.ceil(y0 / MINOR + 0.3); y * MINOR <= y1 - 0.02; y++) {
    if (y % 2 === 0) group.add(number(`${y * 100}`.replace("-", "−"), x0 + 0.05, y * MINOR, z + 0.02, theme, 0.055));
  }
  return group;
}

/** @returns {[number, number, number, number]} */
function extent(/** @type {number} */ x0, /** @type {number} */ x1, /** @type {number} */ y0, /** @type {number} */ y1) {
  return [x0, x1, y0, y1];
}

/** @param {keyof typeof THEMES} theme */
function number(/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z,
  theme, /** @type {number} */ height) {
  const sprite = label(text, { height, color: THEMES[theme].text, halo: THEMES[theme].halo });
  sprite.position.set(x, y, z);
  return sprite;
}

/** @param {[number, number, number, number]} area */
function grid(area, /** @type {number} */ z, /** @type {number} */ step, /** @type {number} */ color,
  /** @type {number} */ opacity) {
  const [x0, x1, y0, y1] = area;
  const points = [];
  for (let k = Math.ceil(x0 / step - 1e-9); k * step <= x1 + 1e-9; k++) points.push(k * step, y0, z, k * step, y1, z);
  for (let k = Math.ceil(y0 / step - 1e-9); k * step <= y1 + 1e-9; k++) points.push(x0, k * step, z, x1, k * step, z);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color, transparent: true, opacity, depthWrite: false }));
}
