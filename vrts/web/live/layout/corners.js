// What the picture is to show of a scene, as the viewer has it.

import { Box3, Mesh, Vector3 } from "three";
import { worthSeeing } from "./framing.js";

/**
 * Return the corners of all meshes of something, in the world [m].
 * @param {import("three").Object3D} whole
 */
export function cornersOf(whole) {
  whole.updateMatrixWorld(true);
  /** @type {number[][]} */
  const found = [];
  whole.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.geometry.boundingBox ?? part.geometry.computeBoundingBox();
    const { min, max } = /** @type {Box3} */ (part.geometry.boundingBox);
    for (const x of [min.x, max.x]) for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) {
      found.push(new Vector3(x, y, z).applyMatrix4(part.matrixWorld).toArray());
    }
  });
  return found;
}

/**
 * Return what the picture is to show of a scene [m].
 * @param {import("../../viewer/viewer.js").Viewer} viewer
 */
export function worked(viewer) {
  return worthSeeing(cornersOf(viewer.robot.group), viewer.data);
}
