// How others come in: the class code, or a link for one room; large enough for the last row.

import { byId, button, make, write } from "../dom.js";

/** @param {import("../toasts.js").Toasts} toasts @param {import("../store.js").Store} store */
export function mountEntrance(toasts, store) {
  const place = byId("entrance");
  const title = make("h2", { id: "entrance-title" });
  const code = make("output", { class: "code" });
  const address = make("p", { class: "address" });
  const picture = make("img", { class: "qr", alt: "QR code of the link", hidden: true });
  const copy = button("Copy the link", () => void copied());
  const close = button("Close", () => place.hidePopover());
  let url = "";
  let ofCode = false; // what is shown is the class code, which may change while it is shown
  place.setAttribute("aria-labelledby", title.id);
  place.replaceChildren(title, code, address, picture, make("div", { class: "row" }, copy, close));

  for (const opener of Array.from(document.querySelectorAll(".opens-entrance"))) {
    /** @type {HTMLElement} */ (opener).hidden = false;
    opener.addEventListener("click", showCode);
  }
  store.on(["code"], () => ofCode && place.matches(":popover-open") && fill());

  function showCode() {
    ofCode = true;
    fill();
    place.showPopover();
  }

  function fill() {
    const { code: text, url: link } = store.now.code;
    write(code, text);
    // the picture is asked for anew with each code
    set("Class code", link, link ? `/code.svg?${Date.now()}` : "");
    write(address, text ? `at ${new URL(link).origin}` : "There is no class code: hand out links to the rooms.");
  }

  /** Make a link that lets into one room only. @param {import("../protocol.js").RoomEntry} room */
  async function showLink(room) {
    const answer = await fetch("/link", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ room: room.id }) });
    const made = await answer.json();
    if (answer.ok) showMade(made, room.name);
    else toasts.warn(made.text);
  }

  /** Show a link that was made. @param {{url: string, picture: string}} made @param {string} room its name */
  function showMade(made, room) {
    ofCode = false;
    write(code, "");
    set(`Link into ${room}`, made.url, URL.createObjectURL(new Blob([made.picture], { type: "image/svg+xml" })));
    write(address, `${made.url} (for this room only, until you end it)`);
    place.showPopover();
  }

  /** @param {string} words @param {string} link @param {string} image */
  function set(words, link, image) {
    write(title, words);
    url = link;
    code.hidden = !code.textContent;
    copy.hidden = !link;
    picture.hidden = !image;
    if (image) picture.src = image;
  }

  async function copied() {
    try {
      await navigator.clipboard.writeText(url);
      toasts.tell("the link is copied");
    } catch {
      toasts.warn("the browser does not let the page copy: select the link instead");
    }
  }

  return { showCode, showLink, showMade };
}
