// One question in a dialog: what will change, and whether to go on.

import { button, byId, make } from "../live/dom.js";

/**
 * Ask, and return whether somebody agreed.
 * @param {string} title @param {(Node | string)[]} body @param {string} yes the word on the button
 * @returns {Promise<boolean>}
 */
export function ask(title, body, yes) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("ask"));
  return new Promise((resolve) => {
    let agreed = false;
    const close = (/** @type {boolean} */ answer) => {
      agreed = answer;
      dialog.close();
    };
    const go = button(yes, () => close(true), { class: "main" });
    dialog.replaceChildren(
      make("h2", { id: "ask-title", text: title }), make("div", { class: "ask-body", tabindex: "0", role: "region", "aria-label": title }, ...body),
      make("div", { class: "row end" }, button("Cancel", () => close(false)), go));
    dialog.addEventListener("close", () => resolve(agreed), { once: true });
    dialog.showModal();
    go.focus();
  });
}
