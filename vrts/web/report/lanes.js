// Lanes under the time bar: what was at work, held, on, touching and near, over the whole run.

/** @typedef {import("../viewer/replay.js").Replay} Replay */
/** @typedef {{start: number, end: number, kind: string, text: string, label?: string}} Bar */
/** @typedef {{name: string, bars?: Bar[], curve?: [number, number][]}} Lane curve: time [s], share of the height */

const FINEST = 1 / 1500; // of the run: what would be narrower than a pixel is not drawn twice
const ROOM = 0.022; // of the run: a bar this wide has room for a number
const TICKS = 10; // at most, of the ruler
const SAMPLES = 400;
const MOST_SIGNALS = 8;
const NEAR = 150; // [mm] clearance from here on fills its lane
const SVG = "http://www.w3.org/2000/svg";

/** Draws lanes and a cursor; a click or a drag anywhere goes to that time. */
export class Lanes {
  /**
   * @param {HTMLElement} box @param {Lane[]} lanes
   * @param {number} end of the run [s]
   * @param {(t: number) => void} jump
   */
  constructor(box, lanes, end, jump) {
    this.end = end || 1;
    const cursor = document.createElement("div");
    cursor.className = "cursor";
    this.mark = document.createElement("b");
    cursor.append(this.mark);
    this.hint = document.createElement("span");
    this.hint.hidden = true;
    cursor.append(this.hint);
    box.replaceChildren(...lanes.map((lane) => this.row(lane)), this.ruler(), cursor);
    box.setAttribute("role", "img"); // not before it has a name
    box.setAttribute("aria-label", `Over time: ${lanes.map((lane) => lane.name).join(", ")}. The list of events says the same in words.`);
    const time = (/** @type {PointerEvent} */ event) => {
      const area = cursor.getBoundingClientRect();
      return Math.min(Math.max((event.clientX - area.left) / area.width, 0), 1) * end;
    };
    const go = (/** @type {PointerEvent} */ event) => jump(time(event));
    box.addEventListener("pointerdown", (event) => {
      box.setPointerCapture(event.pointerId);
      go(event);
    });
    box.addEventListener("pointermove", (event) => {
      if (box.hasPointerCapture(event.pointerId)) go(event);
      this.hint.hidden = event.pointerType === "touch";
      this.hint.style.left = `${(100 * time(event)) / this.end}%`;
      this.hint.textContent = `${time(event).toFixed(2)} s`;
    });
    box.addEventListener("pointerleave", () => { this.hint.hidden = true; });
  }

  /** @param {number} t [s] */
  show(t) {
    this.mark.style.left = `${(100 * t) / this.end}%`;
  }

  /** @param {Lane} lane */
  row(lane) {
    const row = document.createElement("div");
    row.className = lane.curve && !lane.bars ? "lane tall" : "lane";
    const name = document.createElement("span");
    name.className = "name";
    name.textContent = lane.name;
    const band = document.createElement("div");
    band.className = "band";
    if (lane.curve) band.append(this.area(lane.curve));
    for (const bar of this.drawn(lane.bars ?? [])) band.append(this.bar(bar));
    row.append(name, band);
    return row;
  }

  /** Return a row of times. */
  ruler() {
    const row = this.row({ name: "" });
    row.classList.add("ruler");
    const rough = this.end / TICKS;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = ([1, 2, 5, 10].find((k) => k * power >= rough) ?? 10) * power;
    for (let k = 0; k * step <= this.end * (1 - ROOM); k++) {
      const tick = document.createElement("span");
      tick.style.left = `${(100 * k * step) / this.end}%`;
      tick.textContent = `${Number((k * step).toFixed(3))}${k ? "" : " s"}`;
      row.lastElementChild?.append(tick);
    }
    return row;
  }

  /** Return the bars that can be told apart. @param {Bar[]} bars */
  drawn(bars) {
    let last = -Infinity;
    return bars.filter((bar) => {
      if (bar.kind.startsWith("line") && bar.end < last + FINEST * this.end) return false;
      last = bar.start;
      return true;
    });
  }

  /** @param {Bar} bar */
  bar(bar) {
    const drawn = document.createElement("i");
    drawn.className = bar.kind;
    drawn.title = bar.text;
    drawn.style.left = `${(100 * bar.start) / this.end}%`;
    drawn.style.width = `${(100 * (bar.end - bar.start)) / this.end}%`;
    if (bar.label && bar.end - bar.start > ROOM * this.end) drawn.textContent = bar.label;
    return drawn;
  }

  /** @param {[number, number][]} curve */
  area(curve) {
    const svg = document.createElementNS(SVG, "svg");
    svg.setAttribute("viewBox", `0 0 ${this.end} 1`);
    svg.setAttribute("preserveAspectRatio", "none");
    const path = document.createElementNS(SVG, "path");
    const points = curve.map(([t, share]) => `${t.toFixed(3)} ${(1 - 0.92 * share).toFixed(3)}`);
    path.setAttribute("d", `M${curve[0][0]} 1L${points.join("L")}L${curve[curve.length - 1][0]} 1Z`);
    svg.append(path);
    return svg;
  }
}

/**
 * Return the lanes of a run; a lane with nothing to show is left out, but contacts always stand.
 * @param {Replay} replay
 * @param {{run: import("../viewer/replay.js").RunData, contacts: Contact[], grazes: Contact[], doubtful: Contact[], near: Contact[], clearance: [number, number][]}} data
 * @returns {Lane[]}
 */
export function lanesOf(replay, data) {
  const bars = (/** @type {Contact[]} */ rows, /** @type {string} */ kind) =>
    rows.map((c) => ({ start: c.start, end: c.end, kind, text: `${c.text}, ${span(c.start, c.end)}` }));
  const touches = [...bars(data.grazes, "graze"), ...bars(data.doubtful, "doubtful"), ...bars(data.contacts, "contact")];
  const misses = data.near.length ? [{ name: "Near misses", bars: bars(data.near, "near") }] : [];
  const lanes = [{ name: "Line", bars: lineBars(data.run.lines, replay.end) }];
  if (data.run.processLines.length) lanes.push({ name: "PC line", bars: lineBars(data.run.processLines, replay.end) });
  const gripper = { name: "Gripper", bars: holds(data.run.placements, replay.end), curve: opening(replay) };
  const signals = data.run.signals.slice(0, MOST_SIGNALS).map(({ signal, on }) => ({
    name: `Signal ${signal}`,
    bars: on.map(([start, end]) => ({ start, end, kind: "on", text: `signal ${signal} on, ${span(start, end)}` })),
  }));
  const near = data.clearance.length > 1 ? [{ name: "Clearance", curve: shares(data.clearance, NEAR) }] : [];
  return [...lanes, gripper, ...signals, { name: "Contacts", bars: touches }, ...misses, ...near];
}

/** @typedef {{start: number, end: number, text: string}} Contact */

/** @param {[number, number][]} lines @param {number} end @returns {Bar[]} */
function lineBars(lines, end) {
  return lines.map(([start, line], i) => {
    const until = lines[i + 1]?.[0] ?? end;
    return { start, end: until, kind: i % 2 ? "line odd" : "line", text: `line ${line}, ${span(start, until)}`, label: String(line) };
  });
}

/** @param {Record<string, import("../viewer/replay.js").PlacementData[]>} placements @param {number} end @returns {Bar[]} */
function holds(placements, end) {
  return Object.entries(placements).flatMap(([body, rows]) =>
    rows.filter((row) => row.lie === "held").map((row) => {
      const until = Math.min(row.end ?? end, end);
      return { start: row.start, end: until, kind: "held", text: `holds ${body}, ${span(row.start, until)}`, label: body };
    }));
}

/** Return how far the hand is open, as a share of its stroke. @param {Replay} replay @returns {[number, number][]} */
function opening(replay) {
  const rows = Array.from({ length: SAMPLES + 1 }, (_, i) => {
    const t = (i / SAMPLES) * replay.end;
    return /** @type {[number, number]} */ ([t, replay.timeline.at(t).position[6]]);
  });
  return shares(rows);
}

/**
 * Scale values to the largest, or to `full`; what is below zero counts as zero.
 * @param {[number, number][]} rows @param {number} full @returns {[number, number][]}
 */
function shares(rows, full = Math.max(...rows.map(([, value]) => value), 1e-9)) {
  return rows.map(([t, value]) => [t, Math.min(Math.max(value, 0) / full, 1)]);
}

/** @param {number} start @param {number} end */
function span(start, end) {
  return `${start.toFixed(2)}–${end.toFixed(2)} s`;
}
