// Between the world and the picture: pixels of the canvas, and how much of the world one of them is.

import { Vector3 } from "three";

/** @typedef {{x: number, y: number}} Place on the canvas, from its upper left corner [px] */

/** A camera and the canvas that shows what it sees. */
export class Screen {
  /** @param {import("three").PerspectiveCamera} camera @param {HTMLCanvasElement} canvas */
  constructor(camera, canvas) {
    this.camera = camera;
    this.canvas = canvas;
  }

  /** How far ahead of the eye a point is [m]. @param {Vector3} point */
  depth(point) {
    return -point.clone().applyMatrix4(this.camera.matrixWorldInverse).z;
  }

  /** What one pixel is at a depth [m]. @param {number} depth [m] */
  pixel(depth) {
    return (2 * depth * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(this.canvas.clientHeight, 1);
  }

  /** @param {Vector3} point in the world @returns {Place} */
  place(point) {
    const { x, y } = point.clone().project(this.camera);
    return { x: ((x + 1) / 2) * this.canvas.clientWidth, y: ((1 - y) / 2) * this.canvas.clientHeight };
  }

  /** Return the point of the world that is seen at a place, at a depth. @param {Place} place @param {number} depth [m] */
  point({ x, y }, depth) {
    const size = this.pixel(depth);
    const { clientWidth, clientHeight } = this.canvas;
    return new Vector3((x - clientWidth / 2) * size, (clientHeight / 2 - y) * size, -depth).applyMatrix4(this.camera.matrixWorld);
  }

  /**
   * Return in which direction something is seen to point, of length 1; null where it points to the eye.
   * @param {Vector3} from @param {Vector3} along of length 1
   * @returns {Place | null}
   */
  direction(from, along) {
    const short = 20 * this.pixel(this.depth(from)); // 20 px, if it were seen from the side
    const [a, b] = [this.place(from), this.place(from.clone().addScaledVector(along, short))];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    return length > 4 ? { x: (b.x - a.x) / length, y: (b.y - a.y) / length } : null;
  }
}
