// Where the page begins: who is there, and which of its faces is wanted.

import { Denied, enter, whoAmI } from "./account.js";
import { byId } from "./dom.js";
import { keepFocus } from "./focus.js";
import { showDoor } from "./pages/door.js";
import { showRoom } from "./pages/room.js";

/** @returns {Promise<import("./account.js").Me | null>} */
async function identified() {
  const token = new URLSearchParams(location.hash.slice(1)).get("enter");
  if (!token) return whoAmI();
  history.replaceState(null, "", location.pathname + location.search); // a token is no part of the history
  try {
    return await enter(token, "");
  } catch (error) {
    const known = await whoAmI();
    if (known) return known;
    // a class code's link says who may enter, not who it is
    const nameless = error instanceof Denied && error.status === 422;
    showDoor(nameless ? "" : /** @type {Error} */ (error).message, nameless ? token : "");
    return null;
  }
}

/** Show the face of the page that the address asks for. @param {import("./account.js").Me} me */
async function begin(me) {
  byId("enter").hidden = true;
  const wanted = new URLSearchParams(location.search);
  // few ever look at these: nobody else has to fetch them
  if (location.pathname === "/admin") (await import("./pages/admin.js")).showAdmin();
  else if (wanted.has("wall")) (await import("./pages/wall.js")).showWall(me);
  else if (wanted.has("projector")) (await import("./pages/projector.js")).showProjector(me);
  else showRoom(me, wanted.get("room") ?? "");
}

/** Find out who is there, and begin. */
async function start() {
  const me = await identified();
  if (me) await begin(me);
  else if (byId("enter").hidden) showDoor("", "");
}

keepFocus();
document.addEventListener("entered", (event) => void begin(/** @type {CustomEvent} */ (event).detail));
void start();
