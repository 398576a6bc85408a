// The versions of a program: a list, the text of the chosen one, and a way back to it.

import { make } from "../dom.js";

/** @param {number} at [s] */
export function when(at) {
  const date = new Date(at * 1000);
  const day = date.toDateString() === new Date().toDateString() ? "" : `${date.toLocaleDateString()}, `;
  return `${day}${date.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit", second: "2-digit" })}`;
}

/** Return who saved a version, in words. @param {import("./shelf.js").Version} version */
export function who({ mine, saver }) {
  return mine ? "you" : saver || "somebody who was removed";
}

/**
 * Show the versions of a program; return the text that is to be taken, null for none.
 * @param {import("./shelf.js").Shelves} shelves @param {import("./shelf.js").Shelf} shelf @param {string} name
 * @returns {Promise<{text: string, number: number} | null>}
 */
export async function chosenVersion(shelves, shelf, name) {
  const found = await shelves.versions(shelf, name);
  return new Promise((resolve) => {
    /** @type {{text: string, number: number} | null} */
    let chosen = null;
    const text = make("pre", { class: "preview", tabindex: "0", "aria-label": "Text of the chosen version" });
    const take = make("button", { type: "button", class: "main", text: "Take this text", disabled: true, click: () => dialog.close("take") });
    const list = make("ul", { class: "versions", "aria-label": "Versions, the newest first" }, ...found.map((version) => make("li", {}, make("button", {
      type: "button", "aria-pressed": "false", disabled: !version.length && !version.saver,
      text: `${version.number} · ${when(version.at)} · ${who(version)} · ${version.length} characters`,
      click: (event) => void show(version, event.currentTarget),
    }))));
    const dialog = make("dialog", { class: "asking wide", "aria-labelledby": "versions-title", close: () => {
      resolve(dialog.returnValue === "take" ? chosen : null);
      dialog.remove();
    } },
    make("h2", { id: "versions-title", text: `Versions of ${name}` }),
    make("p", { class: "soft", text: "Taking a text puts it into the editor; save it to make it the newest version." }),
    make("div", { class: "beside" }, list, text),
    make("div", { class: "row" }, take, make("button", { type: "button", text: "Close", click: () => dialog.close("") })));

    /** @param {import("./shelf.js").Version} version @param {HTMLElement} button */
    async function show({ number }, button) {
      try {
        chosen = { text: await shelves.text(shelf, name, number), number };
        text.textContent = chosen.text;
      } catch (error) {
        chosen = null;
        text.textContent = /** @type {Error} */ (error).message;
      }
      take.disabled = !chosen;
      for (const one of list.querySelectorAll("button")) one.setAttribute("aria-pressed", String(one === button));
    }
    document.body.append(dialog);
    dialog.showModal();
    list.querySelector("button")?.click();
  });
}
