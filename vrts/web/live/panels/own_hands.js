// On top of the page of who leads: how many hands are up, and one press brings them to the first.

import { button, byId } from "../dom.js";
import { inText } from "../names.js";
import { goTo } from "./own_bar.js";
import { count } from "./tabs.js";

/** Return how long ago something was, in words. @param {number} since Unix time [s] */
export function ago(since) {
  const minutes = Math.floor((Date.now() / 1000 - since) / 60);
  return minutes < 1 ? "just now" : minutes < 60 ? `since ${minutes} min` : `since ${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** @param {import("../pages/room.js").App} app */
export function mountOwnHands(app) {
  const { store, toasts } = app;
  const chip = button("", () => {
    const next = waiting()[0];
    if (next) goTo(app, next.room);
  }, { id: "hands-button", class: "hands", hidden: true });
  byId("link-state").before(chip);
  /** @type {Set<string> | null} */
  let known = null;

  /** Hands that nobody helps yet, who waits longest first. */
  function waiting() {
    const { hands, room } = store.now;
    return (hands?.hands ?? []).filter((one) => one.room !== room?.id && !one.helping.length);
  }

  store.on(["hands", "room", "supervisor"], ({ hands, room }) => {
    const leads = Boolean(hands?.rooms);
    const wait = leads ? waiting() : [];
    chip.hidden = !wait.length;
    if (wait.length) {
      const [next] = wait;
      const text = wait.length === 1 ? `${inText(next.name)} raises a hand` : `${wait.length} hands up: first ${inText(next.name)}`;
      if (chip.textContent !== text) chip.replaceChildren(text);
      chip.title = `Go to ${inText(next.name)}${next.text ? `: ${next.text}` : ""}`;
    }
    if (!hands || !leads) return;
    const up = new Set(hands.hands.map((one) => `${one.room} ${one.since}`));
    for (const one of known === null ? [] : hands.hands.filter((one) => !known?.has(`${one.room} ${one.since}`) && one.room !== room?.id)) {
      count("own");
      toasts.tell(`${inText(one.name)} raises a hand${one.text ? `: ${one.text}` : ""}`);
    }
    known = up;
  });
}
