// Seven coordinates at any time, from polynomial segments: six joints [rad], hand opening [m].

export const COORDINATES = 7;

/**
 * @typedef {object} SegmentData numbers are little-endian, deflated, in base64
 * @property {string} knots float64: where the segments meet, both ends included [s]
 * @property {string} counts uint8: how many coefficients, by segment and coordinate
 * @property {string} coefficients float32: c0 + c1 s + c2 s^2 ..., s = (t - start) / (end - start)
 */

/** @typedef {{position: Float64Array, velocity: Float64Array}} Motion */

/** A piecewise polynomial; time is an argument. */
export class Timeline {
  /**
   * @param {Float64Array} knots one more than segments [s]
   * @param {Uint8Array} counts of coefficients, seven for each segment
   * @param {Float32Array} coefficients
   */
  constructor(knots, counts, coefficients) {
    this.starts = knots.subarray(0, -1);
    this.ends = knots.subarray(1);
    this.coefficients = coefficients;
    this.first = new Uint32Array(counts.length + 1); // where each polynomial begins
    counts.forEach((count, i) => (this.first[i + 1] = this.first[i] + count));
  }

  /** @param {SegmentData} data */
  static async unpack(data) {
    const parts = [data.knots, data.counts, data.coefficients];
    const [knots, counts, coefficients] = await Promise.all(parts.map(inflate));
    return new Timeline(new Float64Array(knots), new Uint8Array(counts), new Float32Array(coefficients));
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
    const length = this.ends[segment] - this.starts[segment];
    const share = length > 0 ? u / length : 0;
    for (let i = 0; i < COORDINATES; i++) {
      const row = segment * COORDINATES + i;
      let value = 0;
      let slope = 0;
      for (let at = this.first[row + 1] - 1; at >= this.first[row]; at--) {
        slope = slope * share + value;
        value = value * share + this.coefficients[at];
      }
      position[i] = value;
      velocity[i] = moving && length > 0 ? slope / length : 0;
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
