// The page's parts beside each other: borders that move, parts that fold, remembered in this browser.

import { byId } from "../dom.js";
import { withAlt } from "../keys.js";
import { keepLayout, keptLayout, LIMITS } from "./kept.js";
import { movable } from "./separators.js";

const NARROW = window.matchMedia("(max-width: 960px) and (not ((max-height: 520px) and (orientation: landscape)))");
const PICTURE = { wide: 320, high: 140 }; // least that is left of the picture [px]
const KEYS = { KeyT: "terminal", KeyP: "desk" }; // with Alt

/** @typedef {"desk"|"terminal"} Part */

/**
 * Arrange the page as it was left, and let it be arranged.
 * @returns {import("./kept.js").Layout & {keepLook: (name: string) => void}}
 */
export function mountLayout() {
  const layout = { ...keptLayout(), keepLook };
  const room = byId("room");
  const floor = /** @type {HTMLElement} */ (room.querySelector(".floor"));
  const borders = { desk: byId("desk-border"), terminal: byId("terminal-border") };
  const parts = { desk: byId("desk"), terminal: byId("terminal-place") };
  const buttons = { desk: byId("fold-desk"), terminal: byId("fold-terminal") };

  /** @param {string} name of the view point to begin with from now on */
  function keepLook(name) {
    layout.look = name;
    keep();
  }

  function keep() {
    const { keepLook: _, ...kept } = layout;
    keepLayout(kept);
  }

  /** Which number says how large a part is. @param {Part} part */
  const measure = (part) => (part === "terminal" ? "terminal" : NARROW.matches ? "deskHigh" : "desk");

  /** How large a part may be here, and is [px]. @param {Part} part */
  function spaceOf(part) {
    const name = measure(part);
    const { least, most } = LIMITS[name];
    const box = parts[part].getBoundingClientRect();
    const now = Math.round(name === "desk" ? box.width : box.height);
    const view = byId("view").getBoundingClientRect();
    const spare = name === "desk" ? floor.clientWidth - PICTURE.wide - now : view.height - PICTURE.high;
    return { least, most: Math.max(Math.min(most, Math.floor(now + spare)), least), now };
  }

  /** @param {Part} part @param {boolean} folded */
  function fold(part, folded) {
    layout[part === "desk" ? "deskFolded" : "terminalFolded"] = folded;
    keep();
    show();
  }

  const isFolded = (/** @type {Part} */ part) => (part === "desk" ? layout.deskFolded : layout.terminalFolded);

  function show() {
    room.style.setProperty("--desk", `${layout.desk}px`);
    if (layout.deskHigh) room.style.setProperty("--desk-high", `${layout.deskHigh}px`); // else by the window
    room.style.setProperty("--terminal", `${layout.terminal}px`);
    for (const part of /** @type {Part[]} */ (["desk", "terminal"])) {
      const folded = isFolded(part);
      room.classList.toggle(`${part}-folded`, folded);
      buttons[part].setAttribute("aria-expanded", String(!folded));
    }
    told();
  }

  /** Say where the borders are, for who does not see it. */
  function told() {
    for (const part of /** @type {Part[]} */ (["desk", "terminal"])) {
      const { least, most, now } = spaceOf(part);
      const upright = part === "desk" && !NARROW.matches;
      const border = borders[part];
      border.setAttribute("aria-orientation", upright ? "vertical" : "horizontal");
      for (const [name, value] of Object.entries({ valuemin: 0, valuemax: Math.max(most, now), valuenow: isFolded(part) ? 0 : now })) {
        border.setAttribute(`aria-${name}`, String(value));
      }
      border.setAttribute("aria-valuetext", isFolded(part) ? "folded" : `${now} of at least ${least} pixels`);
    }
  }

  for (const part of /** @type {Part[]} */ (["desk", "terminal"])) {
    const turn = () => fold(part, !isFolded(part));
    buttons[part].addEventListener("click", turn);
    movable({
      handle: borders[part], fold: turn, upright: () => part === "desk" && !NARROW.matches, room: () => spaceOf(part),
      set: (size, done) => {
        layout[measure(part)] = size;
        if (part === "desk") layout.deskFolded = false;
        else layout.terminalFolded = false;
        show();
        if (done) keep();
      },
    });
  }
  document.addEventListener("keydown", (event) => {
    const code = withAlt(event);
    const part = KEYS[/** @type {keyof typeof KEYS} */ (code)];
    if (code === "KeyM" && isFolded("terminal")) fold("terminal", false); // the monitor is to get the focus
    if (!part) return;
    event.preventDefault();
    buttons[/** @type {Part} */ (part)].click();
  }, true);
  NARROW.addEventListener("change", show);
  new ResizeObserver(told).observe(floor);
  show();
  return layout;
}
