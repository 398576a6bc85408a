// A scene as it stands at one moment, drawn from the same place as the 3D view that will take over.

import { ALUMINIUM, STEEL, THEMES, linkColor } from "../../viewer/colors.js";
import { armFrames } from "../../viewer/kinematics.js";
import { compose, poseFrom, translation } from "../../viewer/poses.js";
import { FIELD_OF_VIEW } from "../../viewer/views.js";
import { Bodies } from "../bodies.js";
import { aimed, worthSeeing } from "../layout/framing.js";
import { clear, lit, rgb } from "./light.js";
import { Raster } from "./raster.js";
import { cornersOf, facesOf, normalOf, placed } from "./solids.js";

/** @typedef {import("../../viewer/viewer.js").SceneData} SceneData */
/** @typedef {{time_s: number, joints_rad: number[], hand_m: number, tool: number[], bodies: import("../protocol.js").Placed[]}} Posture */
/** @typedef {import("../../viewer/poses.js").Pose} Pose */
/** @typedef {{X: Pose, faces: import("./solids.js").Face[], color: number[]}} Part */

const METAL = 0.55; // what is left of a metal's colour where it reflects nothing

/**
 * Return the picture.
 * @param {SceneData} scene @param {Posture} now @param {string} look name of the view point
 * @param {number} width [px] @param {number} height [px] @param {"light"|"dark"} theme
 * @returns {Uint8ClampedArray<ArrayBuffer>} its bytes: red, green, blue and alpha
 */
export function drawn(scene, now, look, width, height, theme) {
  const { X_BL, X_BF } = armFrames(scene.robot.arm, now.joints_rad);
  const arm = armParts(scene, X_BL, X_BF, now.hand_m);
  const corners = () => arm.flatMap(({ X, faces }) => cornersOf(faces).map((point) => placed(X, point)));
  const hand = now.tool.length ? compose(X_BF, poseFrom(now.tool)) : X_BF;
  const fov = (FIELD_OF_VIEW * Math.PI) / 180;
  const aim = aimed(look, fov, width / height, () => worthSeeing(corners(), scene), [hand[12], hand[13], hand[14]]);
  const colors = THEMES[theme];
  const raster = new Raster(width, height, aim, fov);
  const [sky, floor] = [screen(colors.sky), lit([0, 0, 1], rgb(colors.floor), colors.sun)];
  raster.fill(scene.floor, (depth) => sky.map((part, k) => part + clear(depth) * (floor[k] - part)));
  for (const { X, faces, color } of [...arm, ...bodyParts(scene, now, X_BF)]) {
    for (const face of faces) {
      const there = face.map((point) => placed(X, point));
      const normal = normalOf(there);
      if (raster.sees(there[0], normal)) raster.draw(there, lit(normal, color, colors.sun));
    }
  }
  return raster.bytes;
}

/** @param {SceneData} scene @param {Pose[]} X_BL @param {Pose} X_BF @param {number} opening [m] @returns {Part[]} */
function armParts({ robot }, X_BL, X_BF, opening) {
  const links = robot.links.flatMap(({ name, joint, pieces }) => pieces.map((piece) => {
    const color = linkColor(name, piece.shape);
    return { X: X_BL[joint], faces: facesOf(piece), color: color === STEEL ? metal(color) : rgb(color) };
  }));
  const body = robot.gripper.body.map((piece) => ({ X: X_BF, faces: facesOf(piece), color: metal(ALUMINIUM) }));
  const fingers = robot.gripper.fingers.flatMap(({ side, pieces }) => {
    const X = compose(X_BF, translation(0, (side * opening) / 2, 0));
    return pieces.map((piece) => ({ X, faces: facesOf(piece), color: metal(STEEL) }));
  });
  return [...links, ...body, ...fingers];
}

/** @param {SceneData} scene @param {Posture} now @param {Pose} X_BF @returns {Part[]} */
function bodyParts(scene, now, X_BF) {
  const bodies = new Bodies();
  bodies.reset(now.bodies);
  const { poses } = bodies.at(now.time_s, X_BF);
  return scene.bodies.filter(({ kind }) => kind !== "floor").flatMap(({ name, color, pieces, X }) => {
    const here = poses.get(name) ?? poseFrom(X);
    return pieces.map((piece) => ({ X: here, faces: facesOf(piece), color: piece.color ?? color }));
  });
}

/** @param {number} hex */
function metal(hex) {
  return rgb(hex).map((part) => part * METAL);
}

/** @param {number} hex @returns {number[]} red, green and blue, 0..255 */
function screen(hex) {
  return [hex >> 16, (hex >> 8) & 255, hex & 255];
}
