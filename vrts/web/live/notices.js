// What everybody has to see: an announcement, and that the arm was stopped, by whom, and how to go on.
// Both stand below the bar on top of every page, over what is there, and move nothing.

import { byId, button, make } from "./dom.js";
import { badges, isolated } from "./names.js";

const KEPT = "vrts announcement closed"; // its number, in this page
const UNANSWERED = 1_500; // after which a press of PANIC counts as not arrived [ms]

/**
 * @param {HTMLElement} bar below which they stand
 * @param {{store: import("./store.js").Store, connection: import("./connection.js").Connection}} app
 * @param {{counts?: boolean, stops?: boolean}} [how] `counts`: whether a supervisor sees how many have seen it; `stops`: whether
 *   the page is about one arm
 * @returns {{pressed: () => void}} to be told that PANIC was pressed here
 */
export function mountNotices(bar, { store, connection }, { counts = true, stops = true } = {}) {
  // there from the beginning, so that screen readers read out what comes into them
  const announced = make("section", { class: "notice announced", role: "alert", hidden: true });
  const stopped = make("section", { class: "notice stopped", role: "alert", hidden: true });
  bar.append(make("div", { class: "notices" }, stopped, announced));
  announcement(announced, store, connection, counts);
  return { pressed: stops ? stop(stopped, store) : () => undefined };
}

/**
 * @param {HTMLElement} place @param {import("./store.js").Store} store @param {import("./connection.js").Connection} connection
 * @param {boolean} counts
 */
function announcement(place, store, connection, counts) {
  let shown = 0;
  let told = 0; // of which the server knows that it is on this screen
  const seen = make("p", { class: "seen", "aria-live": "off" });

  /** A page that nobody looks at shows nothing. */
  function tell() {
    const id = store.now.announced?.id ?? 0;
    if (!id || told === id || document.hidden || place.hidden) return;
    if (connection.send("noticed", { id, closed: false })) told = id;
  }

  function close() {
    sessionStorage.setItem(KEPT, String(shown));
    connection.send("noticed", { id: shown, closed: true });
    place.hidden = true;
  }

  store.on(["announced", "supervisor"], ({ announced, supervisor }) => {
    const id = announced?.id ?? 0;
    if (announced && id !== shown && sessionStorage.getItem(KEPT) !== String(id)) {
      const time = new Date(announced.at * 1000).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
      place.hidden = false;
      place.replaceChildren(
        make("p", { class: "who" }, "Announcement by ", isolated(announced.name), ...badges("supervisor"), ` ${time}`),
        make("div", { class: "what", dir: "auto", text: announced.text }),
        ...(supervisor && counts ? [seen] : []),
        make("div", { class: "row small" }, button("Close", close, { class: "close", title: "Closes it on this page" }),
          ...(supervisor ? [button("Take it down", () => connection.send("end_announcement"), { title: "Closes it on every page" })] : [])));
    }
    if (!announced) place.hidden = true;
    shown = id;
    if (announced) seen.textContent = `Seen by ${announced.seen} of ${announced.people}, closed by ${announced.closed}`;
    tell();
  });
  store.on(["connection"], ({ connection: state }) => {
    if (state === "open") tell();
    else told = 0; // the server may have been started again
  });
  document.addEventListener("visibilitychange", tell);
}

/** @param {HTMLElement} place @param {import("./store.js").Store} store */
function stop(place, store) {
  let timer = 0;
  let closed = 0; // which of them was closed here

  /** @param {(string | Node)[]} parts @param {string} how to go on @param {boolean} done @param {boolean} [closes] whether it can be closed */
  function show(parts, how, done, closes = done) {
    place.hidden = false;
    place.classList.toggle("waits", !done);
    place.replaceChildren(make("p", { class: "what" }, ...parts), ...(how ? [make("p", { class: "how", text: how })] : []),
      ...(closes ? [make("div", { class: "row small" }, button("Close", () => { closed = store.now.stopped?.at ?? 0; place.hidden = true; }))] : []));
  }

  let key = "";
  store.on(["stopped", "control", "you", "people"], ({ stopped, control, you, people, supervisor }) => {
    if (!stopped) {
      if (key) place.hidden = true;
      key = "";
      return;
    }
    window.clearTimeout(timer);
    if (stopped.at === closed) return;
    const how = onward(control, you, supervisor, people.find(({ id }) => id === control.holder)?.name ?? "");
    const now = `${stopped.at} ${how}`;
    if (now === key) return;
    key = now;
    const time = new Date(stopped.at * 1000).toLocaleTimeString();
    const by = stopped.person === you ? ["You"] : [isolated(stopped.name), ...badges(stopped.role)];
    show([make("strong", { text: "The arm was stopped. " }), ...by, ` pressed PANIC at ${time}. It stands still, and nothing goes on by itself.`], how, true);
  });

  return () => {
    if (store.now.stopped) key = ""; // said again: it was pressed again
    show([make("strong", { text: "Stopping the arm …" })], "", false);
    timer = window.setTimeout(() => {
      if (place.classList.contains("waits")) show([make("strong", { text: "No answer yet: the arm may still move. Press PANIC again." })], "", false, true);
    }, UNANSWERED);
  };
}

/**
 * Return who may do what next.
 * @param {import("./protocol.js").Control} control @param {string} you @param {boolean} supervisor @param {string} holder name
 */
function onward(control, you, supervisor, holder) {
  if (control.frozen) return supervisor ? "To go on: unfreeze the room, in the panel Lead." : "The supervisor has frozen the room: it goes on when they unfreeze it.";
  if (control.holder === you) return "Type RETRY to repeat the motion that was cut, or PROCEED for the next step. Any other command works too.";
  return holder ? "The person with control decides how to go on." : "Nobody has control now: take control to go on.";
}

/** The bar of a page, by which notices stand. @param {string} id of what it is in @returns {HTMLElement} */
export function barOf(id) {
  return byId(id).querySelector(".top");
}
