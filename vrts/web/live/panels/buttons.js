// Open, close, ready; and everything that only the operator may press.

import { byId } from "../dom.js";

/** @param {import("../pages/room.js").App} app */
export function mountButtons({ store, act }) {
  byId("hand-open").addEventListener("click", () => act({ type: "hand", open: true }));
  byId("hand-close").addEventListener("click", () => act({ type: "hand", open: false }));
  byId("ready").addEventListener("click", () => act({ type: "ready" }));
  store.on(["control", "you", "connection"], () => {
    const may = store.operator && store.now.connection === "open";
    for (const id of ["hand-open", "hand-close", "ready"]) byId(id).disabled = !may;
    byId("watching").hidden = store.operator;
  });
}
