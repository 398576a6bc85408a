// Notes at this moment: put by the operator and the supervisor, seen by everybody on the time line and in the list of events.

import { byId, make, onSubmit, write } from "../dom.js";
import { enable } from "../focus.js";
import { withAlt } from "../keys.js";
import { backToLive, onLook } from "../looking.js";
import { inText } from "../names.js";
import { offerMarks } from "../past/marks.js";
import { LONGEST_NOTE } from "../protocol.js";
import { count } from "./tabs.js";

/** @param {import("../pages/room.js").App} app */
export function mountNotes({ store, connection, toasts }) {
  const field = make("input", { id: "note-text", maxlength: LONGEST_NOTE, placeholder: "Worth coming back to", "aria-label": "Note", autocomplete: "off", required: true });
  const put = make("button", { title: "Put a note at this moment of the session (Alt+N)" });
  const form = make("form", { class: "row note-form", id: "note-form" }, field, put);
  byId("panel-history").prepend(form);
  onSubmit(form, () => {
    const text = field.value.trim();
    if (!text) return;
    backToLive(); // a note is put at what is now
    if (connection.send("note", { text })) field.value = "";
    else toasts.warn("there is no connection at the moment");
  });
  document.addEventListener("keydown", (event) => {
    if (withAlt(event) !== "KeyN" || form.hidden) return;
    event.preventDefault();
    const fold = byId("fold-desk");
    if (fold.getAttribute("aria-expanded") === "false") fold.click();
    byId("tab-history").click();
    field.focus();
  }, true);
  store.on(["control", "you", "supervisor", "connection", "alive"], ({ supervisor, connection: state, alive }) => {
    form.hidden = !supervisor && !store.operator;
    for (const one of [field, put]) enable(one, state === "open" && alive);
  });
  onLook((t) => write(put, t === null ? "Note this moment" : "Note now"));
  let known = 0;
  store.on(["notes"], ({ notes }) => {
    if (notes.length > known && known) count("history");
    known = notes.length;
  });
  offerMarks(() => store.now.notes.map(({ at_s: t, name, text }) => ({ t, kind: "said", text: `${inText(name)}: ${text}` })));
}
