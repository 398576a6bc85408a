// Small helpers to build the page. Text is always set as text, never as markup.

/**
 * Return an element of the page that has to be there.
 * @param {string} id
 * @returns {any}
 */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/**
 * Return a new element.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string | boolean | number | ((event: any) => void) | undefined>} attributes functions are listeners, true an
 *   attribute without value; `text` is the text
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (name === "text") element.textContent = String(value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** Return a button. @param {string} text @param {() => void} click @param {Record<string, string | boolean>} attributes */
export function button(text, click, attributes = {}) {
  return make("button", { type: "button", text, click, ...attributes });
}

/** Return a small drawing, 16 by 16, for a button. @param {string} path as SVG writes it */
export function drawing(path) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

/** Return a select with options. @param {[string, string][]} options value and text @param {Record<string, any>} attributes */
export function choice(options, attributes = {}) {
  return make("select", attributes, ...options.map(([value, text]) => make("option", { value, text })));
}

/**
 * Set an element's text when it is another one: screen readers and selections stay quiet.
 * @param {Element} element @param {string} text
 */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** Return a text in which words between backticks are code. @param {string} text @returns {Node[]} */
export function prose(text) {
  return text.split("`").map((part, index) => (index % 2 ? make("code", { text: part }) : document.createTextNode(part)));
}

/** Return a number for people: a true minus, no −0. @param {number} value @param {number} digits */
export function figure(value, digits) {
  return value.toFixed(digits).replace(/^-(0(\.0*)?)$/, "$1").replace("-", "−");
}

/** Call back when Enter makes no line break. @param {HTMLFormElement} form @param {() => void} act */
export function onSubmit(form, act) {
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    act();
  });
}

/** Let somebody keep a text as a file. @param {string} name @param {string} text */
export function download(name, text) {
  const url = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  make("a", { href: url, download: name }).click();
  window.setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Have what a button opens appear at the button, within the window. @param {HTMLElement} opener @param {HTMLElement} box a popover */
export function beside(opener, box) {
  box.addEventListener("beforetoggle", () => (box.style.visibility = "hidden")); // until it has its place
  box.addEventListener("toggle", (event) => {
    box.style.visibility = "";
    if (/** @type {ToggleEvent} */ (event).newState !== "open") return;
    const [at, size] = [opener.getBoundingClientRect(), box.getBoundingClientRect()];
    const below = at.bottom + 4 + size.height <= window.innerHeight;
    box.style.left = `${Math.max(Math.min(at.left, window.innerWidth - size.width - 8), 8)}px`;
    box.style.top = `${below ? at.bottom + 4 : Math.max(at.top - size.height - 4, 8)}px`;
  });
}
