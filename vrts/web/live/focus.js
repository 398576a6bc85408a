// Where the keyboard is stays where it is: when rows are drawn again, go, hide, or may not be pressed any more.

const CAN_HAVE_IT = "a[href], button, input, select, textarea, summary, [tabindex]";
const OFF = "aria-disabled";
const HELD = "data-held"; // off by `enable`, and not by whoever has a way of their own

/**
 * @typedef {object} Kept where the keyboard was
 * @property {HTMLElement} element
 * @property {string} key of the row and what it does there
 * @property {{place: Element, path: number[]}[]} above what it was in, the innermost first, and the way down from there
 */

/** @type {Kept | null} */
let kept = null;

/**
 * Put rows into a place. Those that say the same as before stay as they are, so who is in one of them stays there.
 * @param {Element} place @param {Element[]} wanted
 */
export function settle(place, wanted) {
  const left = [...place.children];
  const rows = wanted.map((row) => {
    const same = left.findIndex((one) => one.isEqualNode(row));
    return same < 0 ? row : left.splice(same, 1)[0];
  });
  for (const old of left) old.remove();
  let next = place.firstElementChild;
  for (const row of rows) {
    if (row === next) next = next.nextElementSibling;
    else place.insertBefore(row, next);
  }
}

/**
 * Let something be used, or not. What has the keyboard keeps it, says that it is off, and does nothing.
 * @param {HTMLButtonElement | HTMLInputElement | HTMLSelectElement} element @param {boolean} on
 */
export function enable(element, on) {
  const holds = !on && element === document.activeElement && !element.disabled;
  if (element.disabled === (!on && !holds) && element.hasAttribute(HELD) === holds && element.hasAttribute(OFF) === holds) return; // asked for at every frame
  element.disabled = !on && !holds;
  for (const [name, value] of [[OFF, "true"], [HELD, ""]]) {
    if (holds) element.setAttribute(name, value);
    else element.removeAttribute(name);
  }
  if (element instanceof HTMLInputElement) element.readOnly = holds;
}

/** Watch over the keyboard's place, on the whole page. */
export function keepFocus() {
  document.addEventListener("focusin", ({ target }) => (kept = remembered(/** @type {HTMLElement} */ (target))));
  document.addEventListener("pointerdown", ({ target }) => {
    if (!/** @type {Element} */ (target).closest?.(CAN_HAVE_IT)) kept = null; // who points elsewhere wants to be there
  }, true);
  document.addEventListener("focusout", ({ target }) => {
    const left = /** @type {HTMLInputElement} */ (target);
    if (left.hasAttribute(HELD)) queueMicrotask(() => document.activeElement !== left && enable(left, false));
  });
  for (const name of ["click", "pointerdown", "keydown", "submit"]) document.addEventListener(name, refuse, true);
  new MutationObserver(restore).observe(document.body, { subtree: true, childList: true, attributes: true, attributeFilter: ["hidden", "disabled", "open", "class"] });
}

/** What is off has the keyboard, and does nothing with it. @param {Event} event */
function refuse(event) {
  const target = /** @type {Element} */ (event.target);
  if (!(event.type === "submit" ? document.activeElement : target)?.closest(`[${HELD}]`)) return;
  const key = event instanceof KeyboardEvent ? event.key : "";
  if (key === "Escape" || (event instanceof KeyboardEvent && (event.altKey || event.ctrlKey || event.metaKey))) return;
  event.stopPropagation();
  if (["", "Enter", " "].includes(key)) event.preventDefault();
}

/** @param {HTMLElement} element @returns {Kept} */
function remembered(element) {
  /** @type {Kept["above"]} */
  const above = [];
  /** @type {number[]} */
  let path = [];
  for (let one = /** @type {Element} */ (element); one.parentElement; one = one.parentElement) {
    path = [Array.prototype.indexOf.call(one.parentElement.children, one), ...path];
    above.push({ place: one.parentElement, path });
  }
  return { element, key: keyOf(element), above };
}

/** What an element is there for, however often it is made again. @param {Element} element */
function keyOf(element) {
  const row = element.closest("[data-key]");
  const own = element.id || element.getAttribute("data-do") || element.getAttribute("aria-label") || element.textContent || element.tagName;
  return `${row?.getAttribute("data-key") ?? ""}\n${own}`;
}

/**
 * Give the keyboard back where what had it is gone: to the same thing made again, else to its neighbour.
 * @param {MutationRecord[]} changes
 */
function restore(changes) {
  if (!kept || (document.activeElement !== document.body && document.activeElement !== kept.element)) return;
  const { element, key, above } = kept;
  const moved = document.activeElement !== element && changes.some(({ addedNodes }) => [...addedNodes].some((node) => node.contains(element)));
  if (moved && usable(element)) element.focus({ preventScroll: true });
  if (element.isConnected && changes.every(({ type }) => type === "childList")) return; // the most frequent by far
  if (usable(element)) return;
  for (const { place, path } of above) {
    if (!place.isConnected || !shown(place)) continue;
    const all = inside(place);
    if (!all.length) continue;
    (all.find((one) => keyOf(one) === key) ?? nearest(place, path) ?? all[0]).focus({ preventScroll: true });
    return;
  }
}

/**
 * Return what stands where something was: in the same row or the one that took its place, else before it.
 * @param {Element} place @param {number[]} path
 */
function nearest(place, [index, ...rest]) {
  const rows = [...place.children];
  const order = [rows[index], ...rows.slice(0, index).reverse(), ...rows.slice(index + 1)].filter(Boolean);
  for (const row of order) {
    if (row instanceof HTMLElement && row.matches(CAN_HAVE_IT) && usable(row)) return row;
    const all = inside(row);
    if (!all.length) continue;
    /** @type {Element | undefined} */
    let deeper = row;
    for (const step of rest) deeper = deeper?.children[step] ?? deeper;
    return all.find((one) => one === deeper) ?? all[0];
  }
  return null;
}

/** What can have the keyboard within a place. @param {Element} place */
function inside(place) {
  return /** @type {HTMLElement[]} */ ([...place.querySelectorAll(CAN_HAVE_IT)]).filter((one) => one.tabIndex >= 0 && usable(one));
}

/** @param {HTMLElement} element */
function usable(element) {
  return element.isConnected && !element.matches(":disabled") && shown(element);
}

/** @param {Element} element */
function shown(element) {
  return element.checkVisibility?.({ visibilityProperty: true }) ?? element.getClientRects().length > 0;
}
