// The panel of the virtual pointer: numbers, steps, what can be reached, and Go.

import { button, choice, figure, make, write } from "./dom.js";
import { enable } from "./focus.js";

const NAMES = ["X", "Y", "Z", "O", "A", "T"];
const SAID = ["X in millimetres", "Y in millimetres", "Z in millimetres", "O in degrees", "A in degrees", "T in degrees"];
const DIGITS = [2, 2, 2, 2, 2, 2];
const STEPS_MM = ["0.1", "1", "10", "50"];
const STEPS_DEG = ["0.1", "1", "5", "15", "90"];
/** Keys of the pads: to the right, away from the eye, up; of the last pad: about the arrow. */
const KEYS = {
  ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1], PageDown: [0, 0, -1],
};

/**
 * @typedef {object} Wishes what people do in the panel
 * @property {(numbers: number[]) => void} type all six numbers
 * @property {(stage: 1|2) => void} stage
 * @property {() => void} align
 * @property {() => void} snap
 * @property {(distance: number) => void} along [m]
 * @property {(angle: number) => void} turn [rad]
 * @property {(end: "base"|"tip"|"hand", view: number[]) => void} shift by right, away, up, as seen [m]
 * @property {(straight: boolean) => void} straight
 * @property {(on: boolean) => void} show
 * @property {() => void} go
 */

/** Builds the panel once; what it shows is set from outside. */
export class PointerPanel {
  /** @param {HTMLElement} box @param {Wishes} wishes */
  constructor(box, wishes) {
    this.wishes = wishes;
    /** @type {number[]} */
    this.numbers = [0, 0, 0, 0, 0, 0];
    this.box = make("div", { class: "pointer" });
    this.shown = make("input", { type: "checkbox", class: "pointer-shown", change: () => wishes.show(this.shown.checked) });
    this.stages = [1, 2].map((stage) => button(stage === 1 ? "1 Place" : "2 Turn",
      () => wishes.stage(/** @type {1|2} */ (stage)), { "data-stage": String(stage), "aria-pressed": "false" }));
    this.fields = NAMES.map((name, i) => this.field(name, i));
    this.mm = choice(STEPS_MM.map((step) => [step, `${step} mm`]), { "aria-label": "Step in millimetres" });
    this.mm.value = "10";
    this.deg = choice(STEPS_DEG.map((step) => [step, `${step}°`]), { "aria-label": "Step in degrees" });
    this.deg.value = "5";
    this.reach = make("p", { class: "pointer-reach", role: "status", "data-reach": "unknown" });
    this.reachText = make("span", { class: "pointer-reach-text" });
    this.reach.append(make("i", { "aria-hidden": "true" }), this.reachText);
    this.said = make("p", { class: "pointer-said", role: "alert", hidden: true });
    this.next = button("Next", () => wishes.stage(this.stage === 1 ? 2 : 1), { class: "pointer-next" });
    this.goButton = button("Go", () => wishes.go(), { class: "pointer-go" });
    this.ways = this.waysOfGoing();
    /** @type {1|2} */
    this.stage = 1;
    this.hint = make("p", { class: "pointer-hint" });
    this.placing = make("div", { class: "pointer-pads", role: "group", "aria-label": "Move with the arrow keys" },
      this.pad("Base", "base", "Base of the arrow"), this.pad("Tip", "tip", "Tip of the arrow"), this.pad("Both", "hand", "Both ends"));
    this.turning = make("div", { class: "pointer-pads", role: "group", "aria-label": "Turn about the arrow" },
      button("⟲ Turn", () => wishes.turn(this.angle), { "aria-label": "Turn counter-clockwise about the arrow" }),
      this.pad("Keys", "turn", "Turn with the arrow keys"),
      button("Turn ⟳", () => wishes.turn(-this.angle), { "aria-label": "Turn clockwise about the arrow" }));
    this.build(box);
  }

  /** @param {HTMLElement} box */
  build(box) {
    const group = (/** @type {string} */ name, /** @type {(Node | string)[]} */ ...parts) =>
      make("div", { class: name, role: "group" }, ...parts);
    this.box.append(
      group("pointer-top", make("label", { class: "pointer-show" }, this.shown, " Pointer"),
        make("div", { class: "pointer-stages", role: "group", "aria-label": "Stage" }, ...this.stages)),
      this.reach,
      group("pointer-numbers", ...this.fields.map((field) => field.row)),
      group("pointer-steps", make("span", { text: "Step" }), this.mm, this.deg),
      this.placing, this.turning,
      group("pointer-tools",
        button("Align", () => this.wishes.align(), { title: "Arrow vertical" }),
        button("Snap to gripper", () => this.wishes.snap(), { title: "Where the hand is now" }),
        button("← Back off", () => this.wishes.along(-this.distance), { title: "Back along the arrow", "aria-label": "Back off along the arrow" }),
        button("Approach →", () => this.wishes.along(this.distance), { title: "Ahead along the arrow", "aria-label": "Approach along the arrow" })),
      group("pointer-end", this.ways, this.next, this.goButton),
      this.said, this.hint);
    box.append(this.box);
  }

  /** Return the step [m]. */
  get distance() {
    return Number(this.mm.value) / 1000;
  }

  /** Return the step [rad]. */
  get angle() {
    return (Number(this.deg.value) * Math.PI) / 180;
  }

  /** @param {string} name @param {number} i */
  field(name, i) {
    const input = make("input", {
      type: "text", inputmode: "decimal", autocomplete: "off", spellcheck: "false", "aria-label": SAID[i], "data-number": name,
      change: () => this.typed(i), focus: () => input.select(),
      keydown: (/** @type {KeyboardEvent} */ event) => this.key(event, i),
    });
    const stepper = (/** @type {string} */ sign, /** @type {1|-1} */ way) => button(sign, () => this.step(i, way),
      { tabindex: "-1", "aria-label": `${name} ${way > 0 ? "up" : "down"}` });
    const row = make("div", { class: "pointer-number" }, make("span", { text: name, "aria-hidden": "true" }),
      input, stepper("−", -1), stepper("+", 1));
    return { input, row };
  }

  /** A place that takes the arrow keys. @param {string} text @param {"base"|"tip"|"hand"|"turn"} end @param {string} said */
  pad(text, end, said) {
    const keys = end === "turn" ? "Left and right turn" : "Arrows move it horizontally, Page Up and Down move it up and down";
    return make("button", {
      type: "button", class: "pointer-pad", "data-pad": end, "aria-label": `${said}: ${keys.toLowerCase()}`, title: keys,
      text: `⌨ ${text}`,
      keydown: (/** @type {KeyboardEvent} */ event) => {
        const way = KEYS[/** @type {keyof typeof KEYS} */ (event.key)];
        if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        event.stopPropagation();
        const size = event.shiftKey ? 0.1 : 1;
        if (end === "turn") this.wishes.turn(-(way[0] + way[1] + way[2]) * this.angle * size);
        else this.wishes.shift(end, way.map((n) => n * this.distance * size));
      },
    });
  }

  /** How the arm goes there: two radio buttons. */
  waysOfGoing() {
    const way = (/** @type {string} */ text, /** @type {boolean} */ straight) => make("label", {},
      make("input", { type: "radio", name: "pointer-way", value: straight ? "straight" : "joint", checked: !straight,
        change: () => this.wishes.straight(straight) }), make("span", { text }));
    return make("fieldset", { class: "pointer-ways" }, make("legend", { class: "unseen", text: "Motion" }),
      way("Joint", false), way("Straight", true));
  }

  /** @param {KeyboardEvent} event @param {number} i */
  key(event, i) {
    const way = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (event.key === "Enter") this.typed(i);
    if (event.key === "Escape") this.refresh(i);
    if (!way) return;
    event.preventDefault();
    this.step(i, /** @type {1|-1} */ (way), event.shiftKey ? 0.1 : 1);
    this.fields[i].input.select();
  }

  /** @param {number} i @param {1|-1} way @param {number} size */
  step(i, way, size = 1) {
    const entered = parsed(this.fields[i].input.value);
    const from = entered === null || this.untouched(i) ? this.numbers[i] : entered;
    const next = from + way * size * Number(i < 3 ? this.mm.value : this.deg.value);
    this.wishes.type(this.numbers.map((n, k) => (k === i ? Math.round(next * 1e6) / 1e6 : n)));
  }

  /** Take what was typed into a field; what is no number stays, marked. @param {number} i */
  typed(i) {
    const { input } = this.fields[i];
    const entered = parsed(input.value);
    input.setAttribute("aria-invalid", String(entered === null));
    if (entered === null || this.untouched(i)) return;
    this.wishes.type(this.numbers.map((n, k) => (k === i ? entered : n)));
  }

  /** Whether a field shows its number as it was written there, rounded. @param {number} i */
  untouched(i) {
    return this.fields[i].input.value === figure(this.numbers[i], DIGITS[i]);
  }

  /** @param {number} i */
  refresh(i) {
    const { input } = this.fields[i];
    input.value = figure(this.numbers[i], DIGITS[i]);
    input.removeAttribute("aria-invalid");
  }

  /** @param {number[]} numbers X Y Z [mm] O A T [degrees] */
  showNumbers(numbers) {
    this.numbers = numbers;
    this.fields.forEach((_, i) => this.refresh(i));
  }

  /** @param {1|2} stage */
  showStage(stage) {
    this.stage = stage;
    this.stages.forEach((each, i) => each.setAttribute("aria-pressed", String(i + 1 === stage)));
    this.placing.hidden = stage === 2;
    this.turning.hidden = stage === 1;
    this.next.textContent = stage === 1 ? "Next" : "Back";
    write(this.hint, stage === 1
      ? "Drag an end of the arrow: the ball moves it horizontally, the blue axis up and down. Drag the arrow to slide it along itself, and the ghost hand to move everything. After you press a button with ⌨, the arrow keys move it."
      : "Drag the ring: the gripper turns about the arrow.");
  }

  /** @param {import("./pointer_reach.js").Answer} answer */
  showReach(answer) {
    this.reach.dataset.reach = answer.state;
    if (answer.state !== "asking") write(this.reachText, answer.text);
  }

  /** @param {boolean} on */
  showVisible(on) {
    this.shown.checked = on;
    if (!on) {
      this.reach.dataset.reach = "unknown";
      write(this.reachText, "the pointer is off");
    }
    this.box.classList.toggle("off", !on);
  }

  /** @param {boolean} on @param {string} why not */
  enableGo(on, why) {
    enable(this.goButton, on);
    this.goButton.title = on ? "Move the arm to the pointer" : why;
  }

  /** @param {string} text empty: nothing */
  say(text) {
    write(this.said, text);
    this.said.hidden = !text;
  }
}

/** Return the number that a text says, with a point or a comma; null for anything else. @param {string} text */
export function parsed(text) {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}
