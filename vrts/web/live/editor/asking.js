// A question that has to be answered before anything else: a dialog with a few buttons.

import { make } from "../dom.js";

/**
 * Ask, and return the answer; "" when the dialog was left.
 * @param {string} title @param {(Node | string)[]} content @param {[string, string][]} answers values and words, the first is preferred
 * @returns {Promise<string>}
 */
export function asked(title, content, answers) {
  return new Promise((resolve) => {
    const heading = make("h2", { text: title, id: "asking-title" });
    const buttons = answers.map(([value, words], index) => make("button", {
      type: "button", text: words, class: index ? "" : "main", click: () => dialog.close(value), autofocus: !index,
    }));
    const dialog = make("dialog", { class: "asking", "aria-labelledby": "asking-title", close: () => {
      resolve(dialog.returnValue);
      dialog.remove();
    } }, heading, ...content, make("div", { class: "row" }, ...buttons));
    document.body.append(dialog);
    dialog.showModal();
  });
}
