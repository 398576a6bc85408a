// Borders that can be moved: by mouse and finger, and by the arrow keys.

const STEP = 16; // [px] of an arrow key
const STRIDE = 64; // [px] with Shift

/**
 * @typedef {object} Border
 * @property {HTMLElement} handle with role=separator
 * @property {() => {least: number, most: number, now: number}} room for the size that it sets [px]
 * @property {() => boolean} upright whether it moves left and right
 * @property {(size: number, done: boolean) => void} set take a size [px]; `done` when it is to be remembered
 * @property {() => void} fold or unfold what it borders on
 */

/** Let a border be moved. What it sets lies to the right of it, or below. @param {Border} border */
export function movable({ handle, room, upright, set, fold }) {
  /** @type {{id: number, from: number, size: number, moved: boolean} | null} */
  let drag = null;
  const within = (/** @type {number} */ size) => {
    const { least, most } = room();
    return Math.min(Math.max(Math.round(size), least), Math.max(most, least));
  };
  const along = (/** @type {PointerEvent} */ event) => (upright() ? event.clientX : event.clientY);

  handle.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    handle.setPointerCapture(event.pointerId);
    drag = { id: event.pointerId, from: along(event), size: room().now, moved: false };
    handle.classList.add("dragged");
  });
  handle.addEventListener("pointermove", (event) => {
    if (drag?.id !== event.pointerId) return;
    drag.moved ||= along(event) !== drag.from;
    if (drag.moved) set(within(drag.size + drag.from - along(event)), false);
  });
  for (const name of /** @type {const} */ (["pointerup", "pointercancel"])) {
    handle.addEventListener(name, (event) => {
      if (drag?.id !== event.pointerId) return;
      const { moved } = drag;
      drag = null;
      handle.classList.remove("dragged");
      if (moved) set(within(room().now), true); // a click alone sets nothing
    });
  }
  handle.addEventListener("dblclick", fold);
  handle.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { least, most, now } = room();
    const step = event.shiftKey ? STRIDE : STEP;
    const [more, less] = upright() ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
    const wanted = { [more]: now + step, [less]: now - step, Home: least, End: most }[event.key];
    if (event.key === "Enter") fold();
    else if (wanted !== undefined) set(within(wanted), true);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
}
