// How others come in: the class code, or a link for one room; large enough for the last row.

import { byId, button, make, write } from "../dom.js";

/** @param {import("../toasts.js").Toasts} toasts */
export function mountEntrance(toasts) {
  const place = byId("entrance");
  const title = make("h2", { id: "entrance-title" });
  const code = make("output", { class: "code" });
  const address = make("p", { class: "address" });
  const picture = make("img", { class: "qr", alt: "QR code of the link", hidden: true });
  const copy = button("Copy the link", () => void copied());
  const close = button("Close", () => place.hidePopover());
  let url = "";
  place.setAttribute("aria-labelledby", title.id);
  place.replaceChildren(title, code, address, picture, make("div", { class: "row" }, copy, close));

  for (const opener of Array.from(document.querySelectorAll(".opens-entrance"))) {
    /** @type {HTMLElement} */ (opener).hidden = false;
    opener.addEventListener("click", () => void showCode());
  }

  async function showCode() {
    const answer = await fetch("/code");
    const known = answer.ok ? await answer.json() : { code: "", url: "" };
    write(code, known.code);
    show("Class code", known.url, known.code ? "/code.svg" : "");
    write(address, known.code ? `at ${new URL(known.url).origin}` : "There is no class code: hand out links to the rooms.");
  }

  /** Make a link that lets into one room only. @param {import("../protocol.js").RoomEntry} room */
  async function showLink(room) {
    const answer = await fetch("/link", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ room: room.id }) });
    const made = await answer.json();
    if (!answer.ok) {
      toasts.warn(made.text);
      return;
    }
    write(code, "");
    show(`Link into ${room.name}`, made.url, URL.createObjectURL(new Blob([made.picture], { type: "image/svg+xml" })));
    write(address, `${made.url} (for this room only, for 12 hours)`);
  }

  /** @param {string} words @param {string} link @param {string} image */
  function show(words, link, image) {
    write(title, words);
    url = link;
    code.hidden = !code.textContent;
    copy.hidden = !link;
    picture.hidden = !image;
    if (image) picture.src = image;
    place.showPopover();
  }

  async function copied() {
    try {
      await navigator.clipboard.writeText(url);
      toasts.tell("the link is copied");
    } catch {
      toasts.warn("the browser does not let the page copy: select the link instead");
    }
  }

  return { showCode, showLink };
}
