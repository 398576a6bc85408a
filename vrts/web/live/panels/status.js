// Joints, X Y Z O A T, time, hand, frame rate, and the line at work.

import { RUNNING, STOPPING, onIn } from "../frame.js";
import { byId, figure, make, write } from "../dom.js";

const DEG = 180 / Math.PI;
const SECOND = 1000; // [ms]
const NAMES = ["J1", "J2", "J3", "J4", "J5", "J6", "X", "Y", "Z", "O", "A", "T", "Time", "Hand", "Speed", "Outputs", "Contacts", "Mark"];
const TITLES = {
  X: "mm, tool in the world", O: "degrees", Hand: "opening, mm", Speed: "of the monitor",
  Contacts: "certified so far", Mark: "by the public checks",
};

/** @param {import("../pages/room.js").App} app */
export function mountStatus({ store, world }) {
  /** @type {Map<string, HTMLElement>} */
  const cells = new Map();
  byId("figures").replaceChildren(...NAMES.map((name) => {
    const value = make("dd", { text: "–" });
    cells.set(name, value);
    return make("div", { class: `f-${name.toLowerCase()}`, title: TITLES[/** @type {keyof typeof TITLES} */ (name)] }, make("dt", { text: name }), value);
  }));
  const set = (/** @type {string} */ name, /** @type {string} */ text) => write(/** @type {HTMLElement} */ (cells.get(name)), text);

  store.on(["shown"], ({ shown }) => shown && show(shown));

  /** @param {import("../past/shown.js").Shown} status */
  function show(status) {
    status.location.forEach((value, index) => set(NAMES[6 + index], figure(value, index < 3 ? 1 : 2)));
    set("Speed", status.speed === null ? "–" : `${figure(status.speed, 0)} %`);
    set("Contacts", String(status.contacts));
    set("Mark", status.mark === null || status.mark === undefined ? "–" : `${figure(status.mark, 1)} / ${status.total}`);
    write(byId("mode"), status.mode);
    byId("mode").className = `mode ${status.mode}`;
    const line = status.line ? `${status.program} ${status.line}  ${status.text}` : status.program || status.text;
    write(byId("line-now"), line);
    write(byId("held"), status.held ? `holds ${status.held}` : "");
    byId("strip").classList.toggle("touched", status.contacts > 0);
  }
  world.watchers.push((state, outputs, flags) => {
    for (let joint = 0; joint < 6; joint++) set(NAMES[joint], figure(state.q[joint] * DEG, 2));
    set("Time", `${figure(state.t, 1)} s`);
    set("Hand", figure(state.q[6] * 1000, 1));
    const on = onIn(outputs);
    set("Outputs", on.length ? on.join(" ") : "none");
    document.body.classList.toggle("stopping", Boolean(flags & STOPPING));
    document.body.classList.toggle("runs", Boolean(flags & RUNNING));
  });
  let before = 0;
  window.setInterval(() => {
    const passed = world.heard - before; // of the session, as the frames themselves say
    write(byId("rate"), `${world.frames && passed > 0 ? Math.round(world.frames / passed) : 0} frames/s`);
    world.frames = 0;
    before = world.heard;
  }, SECOND);
}
