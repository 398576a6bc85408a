// The teach pendant: joints, world, tool; in steps, or as long as a key is held.

import { COMMANDING, allow, whyNoCommand } from "../allowed.js";
import { byId, button, choice, figure, make, write } from "../dom.js";
import { HeldKey } from "./held.js";

const DEG = Math.PI / 180;
const STEPS_MM = [0.1, 1, 5, 10, 50, 100];
const STEPS_DEG = [0.1, 1, 2, 5, 15, 45];
const AXES = {
  joint: ["Joint 1", "Joint 2", "Joint 3", "Joint 4", "Joint 5", "Joint 6"],
  world: ["X", "Y", "Z", "about X", "about Y", "about Z"],
  tool: ["x", "y", "z", "about x", "about y", "about z"],
};
const PLUS = "qwerty";
const MINUS = "asdfgh";

/** @typedef {keyof typeof AXES} Frame */

/** @param {import("../pages/room.js").App} app */
export function mountPendant(app) {
  const { store, act, world } = app;
  const panel = byId("panel-pendant");
  const key = new HeldKey(app);
  /** @type {Frame} */
  let frame = "joint";
  let size = 3;
  let hold = false;

  const modes = /** @type {Frame[]} */ (Object.keys(AXES)).map((name) => button(name, () => choose(name), { "data-frame": name, "aria-pressed": "false" }));
  const ways = [["step", "Step"], ["hold", "Hold to move"]].map(([name, text]) => button(text, () => chooseWay(name === "hold"), { "data-way": name, "aria-pressed": "false" }));
  const step = choice(STEPS_MM.map((mm, index) => [String(index), `${mm} mm, ${STEPS_DEG[index]}°`]), { id: "pendant-step", change: () => (size = Number(step.value)) });
  const speed = choice([["0.05", "creep"], ["0.25", "slow"], ["0.5", "medium"], ["1", "full"]], { id: "pendant-speed" });
  step.value = String(size);
  speed.value = "0.25";
  const stepLabel = make("label", { text: "Step " }, step);
  const speedLabel = make("label", { text: "Speed " }, speed);
  const rows = PLUS.split("").map((_, axis) => {
    const name = make("span", { class: "axis" });
    const value = make("span", { class: "value number" });
    const keys = /** @type {const} */ ([-1, 1]).map((way) => moving(axis, way));
    return { name, value, keys, row: make("div", { class: "axis-row" }, keys[0], name, value, keys[1]) };
  });
  const where = make("input", { id: "record-name", maxlength: 64, placeholder: "p1, or #p1 for joints", spellcheck: "false", autocapitalize: "off" });
  const record = button("Record", () => where.value.trim() && app.command({ type: "record", name: where.value.trim() })
    .then(() => { app.toasts.tell(`${where.value.trim()} is recorded`); where.value = following(where.value.trim()); })
    .catch((error) => app.toasts.warn(error.message)));

  panel.append(
    make("div", { class: "segmented", role: "group", "aria-label": "What the keys move" }, ...modes),
    make("div", { class: "row" }, make("div", { class: "segmented", role: "group", "aria-label": "How" }, ...ways), stepLabel, speedLabel),
    make("div", { class: "axes", id: "axes" }, ...rows.map(({ row }) => row)),
    make("div", { class: "row" }, make("label", { text: "Location " }, where), record),
    make("p", { class: "soft hint", text: "Keys while this panel has the focus: Q W E R T Y forward, A S D F G H back, 1 2 3 frame, − and + step." }),
  );
  panel.tabIndex = -1;

  /** @param {number} axis @param {1 | -1} way */
  function moving(axis, way) {
    const element = button(way > 0 ? "+" : "−", () => hold || stepOnce(axis, way), { class: "jog" });
    const down = () => hold && !element.disabled && key.press({ frame, axis, way, speed: Number(speed.value) });
    element.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => {
      if (!hold) return;
      element.setPointerCapture(event.pointerId);
      down();
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture", "blur"]) element.addEventListener(end, () => key.release());
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => [" ", "Enter"].includes(event.key) && !event.repeat && down());
    element.addEventListener("keyup", () => key.release());
    return element;
  }

  /** @param {number} axis @param {1 | -1} way */
  function stepOnce(axis, way) {
    const length = frame !== "joint" && axis < 3;
    act({ type: "step", frame, axis, way, size: length ? STEPS_MM[size] / 1000 : STEPS_DEG[size] * DEG });
  }

  /** @param {Frame} name */
  function choose(name) {
    key.release();
    frame = name;
    for (const mode of modes) mode.setAttribute("aria-pressed", String(mode.dataset.frame === name));
    rows.forEach(({ name: label, keys }, axis) => {
      write(label, AXES[name][axis]);
      keys.forEach((one, index) => one.setAttribute("aria-label", `${AXES[name][axis]} ${index ? "plus" : "minus"}`));
    });
    values();
  }

  /** @param {boolean} held */
  function chooseWay(held) {
    key.release();
    hold = held;
    for (const way of ways) way.setAttribute("aria-pressed", String((way.dataset.way === "hold") === held));
    stepLabel.hidden = held;
    speedLabel.hidden = !held;
  }

  function values() {
    const { location } = store.now.shown ?? { location: [] };
    rows.forEach(({ value }, axis) => {
      if (frame === "joint") write(value, world.state ? `${figure(world.state.q[axis] / DEG, 2)}°` : "–");
      else write(value, frame === "world" && axis < 3 && location.length ? `${figure(location[axis], 1)} mm` : "");
    });
  }

  panel.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    if (["INPUT", "SELECT"].includes(/** @type {HTMLElement} */ (event.target).tagName) || event.ctrlKey || event.altKey || event.metaKey) return;
    const plus = PLUS.indexOf(event.key);
    const axis = Math.max(plus, MINUS.indexOf(event.key));
    if ("123".includes(event.key)) choose(/** @type {Frame[]} */ (["joint", "world", "tool"])[Number(event.key) - 1]);
    else if (event.key === "+" || event.key === "-") {
      size = Math.min(Math.max(size + (event.key === "+" ? 1 : -1), 0), STEPS_MM.length - 1);
      step.value = String(size);
    } else if (axis >= 0 && !whyNoCommand(store.now)) {
      const way = plus >= 0 ? 1 : -1;
      if (!hold) stepOnce(axis, way);
      else if (!event.repeat) key.press({ frame, axis, way, speed: Number(speed.value) });
    } else return;
    event.preventDefault();
  });
  panel.addEventListener("keyup", () => key.release());

  store.on(COMMANDING, () => {
    const why = whyNoCommand(store.now);
    for (const { keys } of rows) for (const one of keys) allow(one, why);
    allow(record, why);
    if (why && key.down) key.release();
  });
  store.on(["shown"], values);
  world.watchers.push(() => frame === "joint" && !panel.hidden && values());
  choose("joint");
  chooseWay(false);
}

/** Return the name of the next location: p1, p2, ... @param {string} name */
function following(name) {
  return /\d+$/.test(name) ? name.replace(/\d+$/, (digits) => String(Number(digits) + 1)) : `${name}2`;
}
