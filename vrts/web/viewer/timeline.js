// Seven coordinates at any time, from polynomial segments: six joints [rad], hand opening [m].

export const COORDINATES = 7;
const POWERS = 4; // cubics: c0 + c1 u + c2 u^2 + c3 u^3, u = t - start

/**
 * @typedef {object} SegmentData numbers are little-endian, deflated, in base64
 * @property {string} knots float64: where the segments meet, both ends included [s]
 * @property {string} coefficients float32: segment, coordinate, power
 */

/** @typedef {{position: Float64Array, velocity: Float64Array}} Motion */

/** A piecewise polynomial; time is an argument. */
export class Timeline {
  /**
   * @param {Float64Array} knots one more than segments [s]
   * @param {Float32Array} coefficients
   */
  constructor(knots, coefficients) {
    this.starts = knots.subarray(0, -1);
    this.ends = knots.subarray(1);
    this.coefficients = coefficients;
  }

  /** @param {SegmentData} data */
  static async unpack(data) {
    const [knots, coefficients] = await Promise.all([inflate(data.knots), inflate(data.coefficients)]);
    return new Timeline(new Float64Array(knots), new Float32Array(coefficients));
  }

  /** End of the last segment [s]. */
  get end() {
    return this.ends.length ? this.ends[this.ends.length - 1] : 0;
  }

  /**
   * Return the index of the segment valid at a time; the nearest one outside the timeline.
   * @param {number} t [s]
   */
  index(t) {
    let low = 0;
    let high = this.starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= t) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /**
   * Return positions and velocities at a time. The arm stands still outside the timeline.
   * @param {number} t [s]
   * @returns {Motion}
   */
  at(t) {
    const segment = this.index(t);
    const start = this.starts[segment];
    const inside = Math.min(Math.max(t, start), this.ends[segment]);
    return this.evaluate(segment, inside - start, inside === t);
  }

  /**
   * Evaluate one segment.
   * @param {number} segment
   * @param {number} u time since its start [s]
   * @param {boolean} moving false: report zero velocity
   * @returns {Motion}
   */
  evaluate(segment, u, moving = true) {
    const position = new Float64Array(COORDINATES);
    const velocity = new Float64Array(COORDINATES);
    for (let i = 0; i < COORDINATES; i++) {
      const at = (segment * COORDINATES + i) * POWERS;
      const [c0, c1, c2, c3] = this.coefficients.subarray(at, at + POWERS);
      position[i] = c0 + u * (c1 + u * (c2 + u * c3));
      velocity[i] = moving ? c1 + u * (2 * c2 + u * 3 * c3) : 0;
    }
    return { position, velocity };
  }
}

/**
 * @param {string} base64
 * @returns {Promise<ArrayBuffer>}
 */
function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}
