// What is shown is one moment: of the past, or of a rehearsal, where somebody looks at it, else what is now. Never some of each.

import { make } from "../dom.js";
import { backToLive, isLive, onLive, onThen } from "../looking.js";

/** What is pressed because of what one sees: it first leads back to what is now. Typed commands and what stops do it at once. */
const BY_SIGHT = new Set(["go", "step", "jog", "hand", "ready", "record"]);
const BACK = "The picture did not show what is now. Now it does: press again to do it.";

/**
 * @typedef {import("../looking.js").Then & {step: number, speed: number | null, mark: number | null, total: number}} Shown
 *   what is told of a moment; null: nobody knows it
 */

/** @param {import("../protocol.js").Status} status @returns {Shown} */
function ofStatus({ location, mode, program, line, text, held, contacts, step, speed, mark, total }) {
  return { location, mode, program, line, text, held, contacts, step, speed, mark, total };
}

/** Keep `shown` in the store. @param {import("../store.js").Store} store */
export function keepShown(store) {
  store.on(["status"], ({ status }) => isLive() && store.set({ shown: status && ofStatus(status) }));
  onThen((then) => {
    const { status } = store.now;
    if (isLive() || !then) store.set({ shown: status && ofStatus(status) });
    else if (status) store.set({ shown: { ...then, step: then.line, speed: null, mark: null, total: status.total } });
  });
  // a status comes when something changes: the last one counts, whether or not anything was told of the past
  onLive((live) => live && store.set({ shown: store.now.status && ofStatus(store.now.status) }));
}

/** Lead back to what is now where the page shows something else. @returns {string} why what was wanted is not done; empty: it may be */
export function leadBack() {
  const why = isLive() ? "" : BACK;
  backToLive(); // what is under way to another picture counts no more
  return why;
}

/** Lead back for a command. @param {import("../protocol.js").Message} action @returns {string} why it is not given; empty: it is */
export function leadBackFor(action) {
  const why = leadBack();
  return BY_SIGHT.has(action.type) ? why : "";
}

/** A sign for what is of now even where the rest shows something else. It takes its place at all times. */
export function ofNow() {
  return make("span", { class: "of-now" });
}
