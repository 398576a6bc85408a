// Over the picture: what touches, what is close, what was checked.

import { byId, make } from "../dom.js";
import { isLive } from "../looking.js";

const CLOSE = 1.5; // how long a near miss is shown after it [s]

/** @param {import("../pages/room.js").App} app */
export function mountOverlay({ store, world }) {
  let shown = "";
  world.watchers.push((state) => {
    const touching = world.lit(state.t);
    const until = (/** @type {import("../protocol.js").Contact} */ row) => (isLive() ? Math.max(row.end, row.heard ?? row.end) + CLOSE : row.end);
    const near = world.showContacts ? (world.instead?.near ?? store.now.near).filter((row) => row.start <= state.t && state.t <= until(row)) : [];
    const rows = [...touching.map((row) => ["bad", row.text]), ...near.map((row) => ["warn", row.text])].slice(-4);
    const key = JSON.stringify(rows);
    if (key === shown) return;
    shown = key;
    byId("overlay").replaceChildren(...rows.map(([kind, text]) => make("span", { class: kind, text })));
  });
}
