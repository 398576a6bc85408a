// Open, close, ready; and everything that only the operator may press.

import { COMMANDING, allow, whyNoCommand } from "../allowed.js";
import { byId } from "../dom.js";

/** @param {import("../pages/room.js").App} app */
export function mountButtons({ store, act }) {
  byId("hand-open").addEventListener("click", () => act({ type: "hand", open: true }));
  byId("hand-close").addEventListener("click", () => act({ type: "hand", open: false }));
  byId("ready").addEventListener("click", () => act({ type: "ready" }));
  store.on(COMMANDING, () => {
    for (const id of ["hand-open", "hand-close", "ready"]) allow(byId(id), whyNoCommand(store.now));
    byId("watching").hidden = store.operator;
  });
}
