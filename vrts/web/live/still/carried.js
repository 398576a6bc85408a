// What the page brought with it: who one is, and how the arm stood when the server sent it.

/** @typedef {{scene_url: string, scene: import("../../viewer/viewer.js").SceneData} & import("./drawing.js").Posture} Still */
/** @typedef {{now: number, me: import("../account.js").Me, still: Still | null}} Carried `now`: the server's time, since 1970 [s] */

const PLACE = "carried";

/** @type {Carried | null | undefined} */
let known;

/** Return it; null where the page was sent to nobody in particular, or somebody enters anew. @returns {Carried | null} */
export function carried() {
  if (known === undefined) {
    const text = document.getElementById(PLACE)?.textContent;
    known = text && !new URLSearchParams(location.hash.slice(1)).has("enter") ? JSON.parse(text) : null;
  }
  return known ?? null;
}
