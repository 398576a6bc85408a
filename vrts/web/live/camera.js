// What dragging in the picture does, without a drag: by keys, and by buttons that are pressed.

import { Vector3 } from "three";

const TURN = 0.15; // [rad]
const NEARER = 0.85; // times the distance
const FARTHER = 1.18;
const SHIFT = 0.08; // of the distance
const POLE = 0.03; // nearest to straight above or below [rad]

/** @typedef {import("../viewer/viewer.js").Viewer} Viewer */

/** Look from higher, or from lower. @param {Viewer} viewer @param {number} angle upward [rad] */
export function tilt({ camera, controls }, angle) {
  const away = camera.position.clone().sub(controls.target);
  const high = Math.atan2(away.z, Math.hypot(away.x, away.y));
  const wanted = Math.min(Math.max(high + angle, POLE - Math.PI / 2), Math.PI / 2 - POLE);
  camera.updateMatrixWorld();
  const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).setZ(0).normalize();
  camera.position.copy(controls.target).add(away.applyAxisAngle(right, high - wanted));
  controls.update();
}

/** Look at what is beside, from as far away. @param {Viewer} viewer @param {number} right @param {number} up as seen, in steps */
export function shift({ camera, controls }, right, up) {
  camera.updateMatrixWorld();
  const step = SHIFT * camera.position.distanceTo(controls.target);
  const by = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(right * step)
    .add(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1).multiplyScalar(up * step));
  camera.position.add(by);
  controls.target.add(by);
  controls.update();
}

/** What can be done with the camera, by key: sign, name, and how. @type {Record<string, Record<string, [string, string, (viewer: Viewer) => void]>>} */
export const MOVES = {
  Turn: {
    ArrowLeft: ["⟲", "Turn left", (viewer) => viewer.turn(TURN)],
    ArrowRight: ["⟳", "Turn right", (viewer) => viewer.turn(-TURN)],
  },
  Tilt: {
    ArrowUp: ["↥", "From higher", (viewer) => tilt(viewer, TURN)],
    ArrowDown: ["↧", "From lower", (viewer) => tilt(viewer, -TURN)],
  },
  Zoom: {
    "+": ["+", "Nearer", (viewer) => viewer.zoom(NEARER)],
    "-": ["−", "Farther", (viewer) => viewer.zoom(FARTHER)],
  },
  Shift: {
    "Shift ArrowLeft": ["←", "Shift left", (viewer) => shift(viewer, -1, 0)],
    "Shift ArrowRight": ["→", "Shift right", (viewer) => shift(viewer, 1, 0)],
    "Shift ArrowUp": ["↑", "Shift up", (viewer) => shift(viewer, 0, 1)],
    "Shift ArrowDown": ["↓", "Shift down", (viewer) => shift(viewer, 0, -1)],
  },
};
const BY_KEY = Object.assign({}, ...Object.values(MOVES));

/** Return what a key does. @param {KeyboardEvent} event @returns {((viewer: Viewer) => void) | undefined} */
export function moveOf({ key, shiftKey }) {
  return BY_KEY[shiftKey && key.startsWith("Arrow") ? `Shift ${key}` : key]?.[2];
}
