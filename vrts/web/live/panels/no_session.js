// Over the picture: why there is no session, and what the supervisor can choose.

import { byId, button, make } from "../dom.js";

/** @typedef {import("../pages/room.js").App} App */

/** What each choice says, and what it sends. @type {Record<string, [string, (app: App) => void]>} */
const CHOICES = {
  wake: ["Wake it", ({ connection }) => connection.send("wake")],
  again: ["Try again", ({ connection }) => connection.send("go_on", { without_last: false })],
  without_last: ["Go on without the last command", ({ connection }) => connection.send("go_on", { without_last: true })],
  begin: ["Begin again", ({ connection, store }) => connection.send("set_scene", { scene: store.now.room?.scene ?? "" })],
};

/** @param {App} app */
export function mountNoSession(app) {
  const place = make("section", { class: "no-session", role: "status", "aria-label": "No session", hidden: true });
  byId("view").append(place);
  app.store.on(["noSession"], ({ noSession }) => {
    place.hidden = !noSession?.why;
    place.replaceChildren();
    if (!noSession?.why) return;
    place.append(make("p", { class: "why", text: sentence(noSession.why) }));
    place.append(make("p", { text: noSession.help ? sentence(noSession.help) : "Wait for the supervisor." }));
    const known = noSession.choices.filter((name) => name in CHOICES);
    if (!known.length) return;
    const buttons = known.map((name) => button(CHOICES[name][0], () => CHOICES[name][1](app), name === "again" || name === "wake" ? { class: "main" } : {}));
    place.append(make("div", { class: "row" }, ...buttons));
  });
}

/** Return words as a sentence. @param {string} words */
export function sentence(words) {
  return words.charAt(0).toUpperCase() + words.slice(1) + (words.endsWith(".") ? "" : ".");
}
