// Charts over time as SVG, drawn from the run's polynomials. A click shows that moment.

const SVG = "http://www.w3.org/2000/svg";
const HEIGHT = 190;
const TWO_COLUMNS = 900; // [px] a list this wide shows charts side by side
const GAP = 32; // [px] between them
const MARGIN = { left: 56, right: 14, top: 10, bottom: 24 };
const COLORS = ["#e8590c", "#1c7ed6", "#2f9e44", "#9c36b5", "#c2255c", "#0c8599"];

/**
 * @typedef {object} Chart
 * @property {string} title
 * @property {string} unit of the values
 * @property {{name: string, values: Float64Array}[]} series beside `times`
 * @property {number[]} [limits] values to mark
 * @property {string} [limitText]
 * @property {boolean} [fromZero]
 * @property {(index: number, t: number) => string} [tell] what to say of a series at a time
 */

/** All charts of a page: one time axis, one cursor. */
export class Charts {
  /**
   * @param {HTMLElement} list
   * @param {Float64Array} times [s]
   * @param {Chart[]} charts
   * @param {{start: number, end: number}[]} contacts
   * @param {(t: number) => void} seek
   */
  constructor(list, times, charts, contacts, seek) {
    this.list = list;
    this.times = times;
    this.charts = charts;
    this.contacts = contacts;
    this.seek = seek;
    this.width = 0;
    this.end = times[times.length - 1] || 1;
    /** @type {SVGLineElement[]} */
    this.cursors = [];
    this.t = 0;
    new ResizeObserver(() => this.draw()).observe(list);
    this.draw();
  }

  /** Draw all charts at the present width. */
  draw() {
    const whole = this.list.clientWidth || 800;
    const two = whole >= TWO_COLUMNS;
    const width = Math.floor(two ? (whole - GAP) / 2 : whole);
    if (width === this.width) return;
    this.list.classList.toggle("two", two);
    this.width = width;
    this.cursors = [];
    this.list.replaceChildren(...this.charts.map((chart) => this.figure(chart, width)));
    this.show(this.t);
  }

  /** @param {number} t [s] */
  x(t) {
    return MARGIN.left + (t / this.end) * (this.width - MARGIN.left - MARGIN.right);
  }

  /** @param {number} t time of the cursor [s] */
  show(t) {
    this.t = t;
    for (const cursor of this.cursors) {
      cursor.setAttribute("x1", String(this.x(t)));
      cursor.setAttribute("x2", String(this.x(t)));
    }
  }

  /** @param {Chart} chart @param {number} width */
  figure(chart, width) {
    const figure = document.createElement("figure");
    figure.className = "chart";
    const caption = document.createElement("figcaption");
    const title = document.createElement("span");
    title.textContent = `${chart.title} (${chart.unit})`;
    caption.append(title);
    if (chart.series.length > 1) caption.append(this.keys(chart));
    const [low, high] = range(chart);
    const y = (/** @type {number} */ value) =>
      MARGIN.top + ((high - value) / (high - low)) * (HEIGHT - MARGIN.top - MARGIN.bottom);
    const svg = node("svg", { viewBox: `0 0 ${width} ${HEIGHT}`, height: HEIGHT, role: "img" });
    const words = node("title", {});
    words.textContent = `${chart.title} in ${chart.unit}, from 0 to ${this.end.toFixed(1)} s`;
    svg.append(words);
    for (const { start, end } of this.contacts) {
      const left = this.x(start);
      svg.append(node("rect", { class: "contact", x: left, width: Math.max(2, this.x(end) - left), y: MARGIN.top,
        height: HEIGHT - MARGIN.top - MARGIN.bottom }));
    }
    this.axes(svg, chart, low, high, y, width);
    chart.series.forEach(({ values }, index) => svg.append(this.curve(values, y, COLORS[index % COLORS.length])));
    const cursor = /** @type {SVGLineElement} */ (node("line", { class: "cursor", y1: MARGIN.top, y2: HEIGHT - MARGIN.bottom }));
    this.cursors.push(cursor);
    svg.append(cursor);
    svg.addEventListener("pointerdown", (event) => this.point(event, svg));
    svg.addEventListener("pointermove", (event) => { if (event.buttons) this.point(event, svg); });
    figure.append(caption, svg);
    return figure;
  }

  /** @param {PointerEvent} event @param {Element} svg */
  point(event, svg) {
    const box = svg.getBoundingClientRect();
    const share = (event.clientX - box.left - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right);
    this.seek(Math.min(Math.max(share, 0), 1) * this.end);
  }

  /** @param {Chart} chart */
  keys(chart) {
    const keys = document.createElement("span");
    keys.className = "keys";
    chart.series.forEach(({ name }, index) => {
      const key = document.createElement("span");
      const dash = document.createElement("i");
      dash.style.background = COLORS[index % COLORS.length];
      key.append(dash, name);
      keys.append(key);
    });
    return keys;
  }

  /**
   * @param {Element} svg @param {Chart} chart @param {number} low @param {number} high
   * @param {(value: number) => number} y @param {number} width
   */
  axes(svg, chart, low, high, y, width) {
    const right = width - MARGIN.right;
    for (const value of ticks(low, high, 4)) {
      svg.append(node("line", { class: "grid", x1: MARGIN.left, x2: right, y1: y(value), y2: y(value) }));
      svg.append(words(number(value), { x: MARGIN.left - 8, y: y(value) + 4, "text-anchor": "end" }));
    }
    for (const t of ticks(0, this.end, Math.max(3, width / 120))) {
      svg.append(node("line", { class: "grid", x1: this.x(t), x2: this.x(t), y1: MARGIN.top, y2: HEIGHT - MARGIN.bottom }));
      svg.append(words(`${number(t)} s`, { x: this.x(t), y: HEIGHT - 6, "text-anchor": "middle" }));
    }
    for (const value of chart.limits ?? []) {
      if (value < low || value > high) continue;
      svg.append(node("line", { class: "limit", x1: MARGIN.left, x2: right, y1: y(value), y2: y(value) }));
      svg.append(words(chart.limitText ?? "limit", { class: "limit-text", x: right - 4, y: y(value) + (value < 0 ? 14 : -5), "text-anchor": "end" }));
    }
  }

  /** @param {Float64Array} values @param {(value: number) => number} y @param {string} color */
  curve(values, y, color) {
    let path = "";
    for (let i = 0; i < values.length; i++) {
      path += `${i ? "L" : "M"}${this.x(this.times[i]).toFixed(1)} ${y(values[i]).toFixed(1)}`;
    }
    return node("path", { class: "curve", d: path, stroke: color });
  }
}

/** @param {Chart} chart @returns {[number, number]} */
function range(chart) {
  let low = chart.fromZero ? 0 : Infinity;
  let high = chart.fromZero ? 1e-9 : -Infinity;
  for (const { values } of chart.series) {
    for (const value of values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  for (const value of chart.limits ?? []) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const room = (high - low || 1) * 0.08;
  return [chart.fromZero ? 0 : low - room, high + room];
}

/** Return round numbers between two values. */
function ticks(/** @type {number} */ low, /** @type {number} */ high, /** @type {number} */ wanted) {
  const rough = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= rough) ?? rough;
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

/** @param {number} value */
function number(value) {
  return String(Number(value.toFixed(3))).replace("-", "−");
}

/** @param {string} text @param {Record<string, string | number>} attributes */
function words(text, attributes) {
  const element = node("text", attributes);
  element.textContent = text;
  return element;
}

/** @param {string} name @param {Record<string, string | number>} attributes */
function node(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}
