// What the charts show, computed from the run at many times. Nothing here decides anything.

/** @typedef {import("../viewer/replay.js").Replay} Replay */

const SAMPLES = 1200;
const DEGREES = 180 / Math.PI;

/**
 * Return times for charts and paths: evenly spaced, and where segments meet.
 * @param {Replay} replay
 */
export function sampleTimes(replay) {
  const times = Array.from({ length: SAMPLES + 1 }, (_, i) => (i / SAMPLES) * replay.end);
  if (replay.timeline.starts.length < SAMPLES) times.push(...replay.timeline.starts);
  return Float64Array.from(times.filter((t) => t >= 0 && t <= replay.end)).sort();
}

/**
 * Return positions of the tool tip.
 * @param {Replay} replay @param {Float64Array} times
 */
export function toolPath(replay, times) {
  const points = new Float32Array(3 * times.length);
  times.forEach((t, i) => points.set(replay.at(t).X_WT.subarray(12, 15), 3 * i));
  return points;
}

/**
 * Return the charts of a run.
 * @param {Replay} replay @param {Float64Array} times @param {Float32Array} path of the tool
 * @param {[number, number][]} clearance times [s] and smallest distances [mm], sampled
 * @returns {import("./charts.js").Chart[]}
 */
export function charts(replay, times, path, clearance = []) {
  const { arm } = replay;
  const motions = Array.from(times, (t) => replay.timeline.at(t));
  const joints = [0, 1, 2, 3, 4, 5];
  const column = (/** @type {(i: number) => number} */ value) => Float64Array.from(times, (_, i) => value(i));
  const middle = joints.map((k) => (arm.lower[k] + arm.upper[k]) / 2);
  const half = joints.map((k) => (arm.upper[k] - arm.lower[k]) / 2);
  const room = clearance.length < 2 ? [] : [
    { title: "Clearance: smallest distance to anything, sampled", unit: "mm",
      series: [{ name: "clearance", values: column((i) => between(clearance, times[i])) }] },
  ];
  return [
    ...room,
    { title: "Tool height above the base frame", unit: "mm", series: [{ name: "z", values: column((i) => path[3 * i + 2] * 1000) }] },
    { title: "Tool speed", unit: "mm/s", fromZero: true, limits: [arm.linearSpeed * 1000], limitText: "straight lines at SPEED 100",
      series: [{ name: "speed", values: column((i) => speed(replay, times[i])) }] },
    { title: "Joint positions within their ranges", unit: "% of half the range; ±100 is a limit", limits: [-100, 100],
      series: joints.map((k) => ({
        name: `JT${k + 1} (${degrees(arm.lower[k])}…${degrees(arm.upper[k])}°)`,
        values: column((i) => ((motions[i].position[k] - middle[k]) / half[k]) * 100) })) },
    { title: "Joint speeds", unit: "% of the limit", limits: [-100, 100],
      series: joints.map((k) => ({ name: `JT${k + 1} (${degrees(arm.speed[k])}°/s)`,
        values: column((i) => (motions[i].velocity[k] / arm.speed[k]) * 100) })) },
    { title: "Hand opening", unit: "mm", fromZero: true,
      series: [{ name: "opening", values: column((i) => motions[i].position[6] * 1000) }] },
  ];
}

/**
 * Return the speed of the tool tip [mm/s], by central difference over 2 ms.
 * @param {Replay} replay @param {number} t
 */
export function speed(replay, t) {
  const step = 0.001;
  const [a, b] = [replay.at(Math.max(0, t - step)), replay.at(Math.min(replay.end, t + step))];
  const distance = Math.hypot(b.X_WT[12] - a.X_WT[12], b.X_WT[13] - a.X_WT[13], b.X_WT[14] - a.X_WT[14]);
  return (distance / (b.t - a.t || 1)) * 1000;
}

/**
 * Return a sampled value at a time, linear between samples.
 * @param {[number, number][]} samples @param {number} t
 */
function between(samples, t) {
  let low = 0;
  let high = samples.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (samples[middle][0] <= t) low = middle;
    else high = middle;
  }
  const [[t0, a], [t1, b]] = [samples[low], samples[high]];
  return t1 > t0 ? a + ((b - a) * Math.min(Math.max(t - t0, 0), t1 - t0)) / (t1 - t0) : a;
}

/** @param {number} radians */
function degrees(radians) {
  return String(Math.round(radians * DEGREES)).replace("-", "−");
}
