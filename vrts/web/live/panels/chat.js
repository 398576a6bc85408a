// Chat with everybody, or with the supervisors only.

import { allow } from "../allowed.js";
import { byId, choice, make, onSubmit } from "../dom.js";
import { settle } from "../focus.js";
import { badges, inText, isolated } from "../names.js";
import { LONGEST_CHAT } from "../protocol.js";
import { count } from "./tabs.js";

/** @param {import("../pages/room.js").App} app */
export function mountChat({ store, connection, toasts }) {
  const panel = byId("panel-chat");
  const list = make("div", { class: "said", role: "log", "aria-label": "Chat", tabindex: "0" });
  const field = make("input", { id: "chat-text", maxlength: LONGEST_CHAT, placeholder: "Say something", "aria-label": "Message", autocomplete: "off", required: true });
  const to = choice([], { id: "chat-to", "aria-label": "To whom" });
  const send = make("button", { class: "main", text: "Send" });
  const form = make("form", { class: "row say" }, field, to, send);
  const off = make("p", { class: "soft", text: "The supervisor has turned the chat off." });
  panel.classList.add("chat");
  panel.append(list, off, form);

  onSubmit(form, () => {
    const text = field.value.trim();
    if (!text) return;
    const [kind, person = ""] = to.value.split(" ");
    if (connection.send("say", { text, private: kind !== "all", to: person })) field.value = "";
    else toasts.warn("there is no connection at the moment");
  });

  let last = 0;
  store.on(["chat", "you"], ({ chat, you }) => {
    const below = list.scrollHeight - list.scrollTop - list.clientHeight < 40;
    settle(list, chat.map((row) => entry(row, you)));
    if (below) list.scrollTop = list.scrollHeight;
    const newest = chat.at(-1)?.number ?? 0;
    if (newest > last && last && chat.at(-1)?.person !== you) count("chat");
    const spoken = chat.at(-1);
    const speaker = store.now.people.find(({ id }) => id === spoken?.person);
    const heard = !spoken?.name || (speaker?.role === "supervisor" && speaker.id !== you && panel.hidden);
    const stands = spoken?.text === store.now.announced?.text; // on top of the page already
    if (spoken && !stands && newest > last && last && heard) toasts.tell(spoken.name ? `${inText(spoken.name)}: ${spoken.text}` : spoken.text);
    last = Math.max(newest, last || 1);
  });
  document.addEventListener("panel", () => (list.scrollTop = list.scrollHeight));
  store.on(["people", "you", "supervisor"], ({ people, you, supervisor }) => {
    const before = to.value;
    const others = supervisor ? people.filter(({ id }) => id !== you) : [];
    const options = [["all", "to all"], ["lead", supervisor ? "to supervisors" : "to supervisor"], ...others.map(({ id, name }) => [`one ${id}`, `to ${inText(name)}`])];
    to.replaceChildren(...options.map(([value, text]) => make("option", { value, text, selected: value === before })));
  });
  store.on(["control", "connection", "people", "you", "supervisor"], ({ control, connection: state, people, you, supervisor }) => {
    const muted = people.some(({ id, muted: silent }) => id === you && silent);
    off.textContent = muted ? "The supervisor has muted you." : "The supervisor has turned the chat off.";
    off.hidden = control.chat && !muted;
    form.hidden = !supervisor && (!control.chat || muted);
    for (const one of [field, send]) allow(one, state === "open" ? "" : "There is no connection at the moment.");
  });
}

/** @param {import("../protocol.js").Chat} row @param {string} you */
function entry(row, you) {
  const time = new Date(row.at * 1000).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
  const kind = row.name === "" ? "server" : row.person === you ? "own" : "";
  const head = make("p", { class: "who" }, make("b", {}, row.name ? isolated(row.name) : "Server"), ...badges(row.role), ` ${time}`,
    ...(row.private ? [make("span", { class: "tag" }, "private, to ", row.to ? isolated(row.to) : "the supervisor")] : []));
  return make("div", { class: `line ${kind}` }, head, make("p", { class: "text", text: row.text }));
}
