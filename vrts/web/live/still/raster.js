// A picture drawn by the processor alone: flat faces, the nearest in front. It needs no WebGL and no library.

const NEAR = 0.05; // from the eye; what is nearer is cut off [m]

/** @typedef {number[]} Point x, y and z [m] */

/** Draws faces as one eye sees them. */
export class Raster {
  /**
   * @param {number} width [px] @param {number} height [px]
   * @param {{eye: Point, target: Point}} aim [m], z is up @param {number} fov height of the picture as an angle [rad]
   */
  constructor(width, height, { eye, target }, fov) {
    this.width = width;
    this.height = height;
    this.eye = eye;
    const ahead = unit(target.map((x, axis) => x - eye[axis]));
    const right = unit([ahead[1], -ahead[0], 0]);
    const up = [right[1] * ahead[2], -right[0] * ahead[2], right[0] * ahead[1] - right[1] * ahead[0]];
    this.axes = [right, up, ahead];
    this.focal = height / 2 / Math.tan(fov / 2); // [px]
    this.near = new Float32Array(width * height); // one over the depth of what is drawn [1/m]
    this.bytes = new Uint8ClampedArray(4 * width * height); // of the picture: red, green, blue and alpha
    this.pixels = new Uint32Array(this.bytes.buffer);
  }

  /**
   * Fill the picture with sky, and with a floor without end below it. All that is seen of a floor in one row
   * lies at one depth.
   * @param {number} z height of the floor [m] @param {(depth: number) => number[]} color at a depth [m]; of the sky: endless
   */
  fill(z, color) {
    const [, up, ahead] = this.axes;
    for (let row = 0; row < this.height; row++) {
      const depth = (z - this.eye[2]) / (ahead[2] + (up[2] * (this.height / 2 - row - 0.5)) / this.focal);
      this.pixels.fill(packed(color(depth > 0 ? depth : Infinity)), row * this.width, (row + 1) * this.width);
    }
  }

  /** Whether a face is seen from outside. @param {Point} point of it @param {Point} normal the way out of it */
  sees([x, y, z], normal) {
    const { eye } = this;
    return (x - eye[0]) * normal[0] + (y - eye[1]) * normal[1] + (z - eye[2]) * normal[2] < 0;
  }

  /**
   * Draw a flat convex face whose corners are seen counter-clockwise; from behind it is not seen.
   * @param {Point[]} face in the world [m] @param {number[]} color red, green and blue, 0..255
   */
  draw(face, color) {
    const seen = face.map((point) => {
      const away = [point[0] - this.eye[0], point[1] - this.eye[1], point[2] - this.eye[2]];
      return this.axes.map((axis) => axis[0] * away[0] + axis[1] * away[1] + axis[2] * away[2]);
    });
    const shown = seen.every(([, , depth]) => depth >= NEAR) ? seen : cutOff(seen);
    const corners = shown.map(([x, y, depth]) => [this.width / 2 + (this.focal * x) / depth, this.height / 2 - (this.focal * y) / depth, 1 / depth]);
    const value = packed(color);
    for (let k = 1; k + 1 < corners.length; k++) this.triangle(corners[0], corners[k], corners[k + 1], value);
  }

  /**
   * @param {number[]} a column, row and nearness of a corner @param {number[]} b @param {number[]} c
   * @param {number} value of its pixels
   */
  triangle(a, b, c, value) {
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (!(area < 0)) return; // rows count downward, so what faces the eye turns the other way
    const { width, near, pixels } = this;
    const across = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area; // nearness by column
    const down = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    const first = Math.max(Math.ceil(Math.min(a[1], b[1], c[1]) - 0.5), 0);
    const last = Math.min(Math.ceil(Math.max(a[1], b[1], c[1]) - 0.5), this.height) - 1;
    for (let row = first; row <= last; row++) {
      const y = row + 0.5;
      let from = Infinity;
      let to = -Infinity;
      for (const [p, q] of [[a, b], [b, c], [c, a]]) {
        if (p[1] > y === q[1] > y) continue;
        const x = p[0] + ((y - p[1]) / (q[1] - p[1])) * (q[0] - p[0]);
        from = Math.min(from, x);
        to = Math.max(to, x);
      }
      const begin = Math.max(Math.ceil(from - 0.5), 0);
      const end = Math.min(Math.ceil(to - 0.5), width);
      let here = a[2] + across * (begin + 0.5 - a[0]) + down * (y - a[1]);
      for (let at = row * width + begin; at < row * width + end; at++, here += across) {
        if (here > near[at]) {
          near[at] = here;
          pixels[at] = value;
        }
      }
    }
  }
}

/** Cut off what is too near to the eye, or behind it. @param {Point[]} face as the eye sees it */
function cutOff(face) {
  /** @type {Point[]} */
  const found = [];
  face.forEach((point, k) => {
    const next = face[(k + 1) % face.length];
    if (point[2] >= NEAR) found.push(point);
    if (point[2] >= NEAR === next[2] >= NEAR) return;
    const share = (NEAR - point[2]) / (next[2] - point[2]);
    found.push(point.map((x, axis) => x + share * (next[axis] - x)));
  });
  return found;
}

/** Return a pixel. @param {number[]} color red, green and blue, 0..255 */
function packed([red, green, blue]) {
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0; // every browser's machine puts the lowest byte first
}

/** @param {Point} a */
function unit(a) {
  const length = Math.hypot(...a);
  return a.map((x) => x / length);
}
