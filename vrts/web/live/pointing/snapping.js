// The pointer goes where the hand grips an object or sets one down: chosen from a list, or by a click on the object.

import { button, choice, make } from "../dom.js";
import { enable } from "../focus.js";
import { along, pointerAt } from "../pointer_pose.js";
import { onSelect } from "../selection.js";
import { compose, poseFrom } from "../../viewer/poses.js";

const ABOVE = 0.05; // [m] back along the approach

/** @typedef {import("../protocol.js").HandPlace} HandPlace */

/**
 * Return the pose of the tool at a place, with its object where it is now.
 * @param {HandPlace} place @param {import("../world.js").World} world
 */
export function poseAt(place, { state, viewer }) {
  const X_OT = poseFrom(place.X);
  const own = viewer?.data.bodies.find(({ name }) => name === place.body);
  const X_WO = state?.bodies.get(place.body) ?? (own && poseFrom(own.X));
  return X_WO ? compose(X_WO, X_OT) : X_OT;
}

/** @param {HandPlace} place */
function titled({ name, body }) {
  const what = { grip: "grip", put: "set down" }[name.toLowerCase().split("_").pop() ?? ""];
  return body && what ? `${body}: ${what} (${name})` : name;
}

/** @param {import("./tools.js").Around} around @returns {HTMLElement} */
export function mountSnapping({ store, world, pointer }) {
  const list = choice([], { id: "snap-place" });
  const at = button("At", () => snap(0), { "aria-label": "Put the pointer at the place", title: "Where the hand grips or sets down" });
  const above = button("Above", () => snap(ABOVE), { "aria-label": "Put the pointer 50 mm above the place", title: "50 mm back along the approach" });
  const clicks = make("input", { type: "checkbox", id: "snap-clicks", checked: true });
  const box = make("div", { class: "block" }, make("h2", { text: "Snap to an object" }),
    make("div", { class: "row" }, make("label", { for: "snap-place" }, "Place", list), at, above),
    make("label", { class: "check" }, clicks, "A click on an object snaps to it"));

  /** @param {number} back [m] */
  function snap(back) {
    const place = store.now.places.find(({ name }) => name === list.value);
    const now = pointer();
    if (place && now) now.change(along(pointerAt(poseAt(place, world), now.pose.length), -back));
  }

  store.on(["places"], ({ places }) => {
    const chosen = list.value;
    list.replaceChildren(...places.map((place) => make("option", { value: place.name, text: titled(place) })));
    if (places.some(({ name }) => name === chosen)) list.value = chosen;
    for (const one of [list, at, above]) enable(one, places.length > 0);
  });
  let told = false;
  onSelect((name) => {
    const first = !told; // what was selected before is no click
    told = true;
    const place = store.now.places.find(({ body }) => body === name);
    if (!name || !place) return;
    list.value = place.name;
    if (!first && clicks.checked && pointer()?.visible) snap(0);
  });
  return box;
}
