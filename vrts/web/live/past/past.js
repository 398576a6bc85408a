// A look at the session's past, for this page alone, while the session goes on.

import { components } from "../../viewer/poses.js";
import { byId, make, write } from "../dom.js";
import { MOVING, RUNNING } from "../frame.js";
import { withAlt } from "../keys.js";
import { backToLive, look, lookedAt, onLook, tellThen } from "../looking.js";
import { Bar, ago } from "./bar.js";
import { BLOCK, Blocks } from "./blocks.js";
import { goOnFrom } from "./branch.js";
import { FARTHEST, Marks } from "./marks.js";

const AHEAD = 10; // of what is played the next block is fetched so early [s]
const LAST = 0.4; // nearer to now than this is live, when the past is played [s]
const PAUSE = 250; // between drawings of the marks [ms]
const LOOK_BACK = 5; // where play begins when one looks at what is now [s]

/** @param {import("../pages/room.js").App} app */
export function mountPast({ store, world, toasts, connection }) {
  const blocks = new Blocks(
    () => (store.now.alive ? store.now.sceneUrl.replace(/^\/scene\//, "/past/") : ""), () => world.viewer?.data.robot.arm, () => (drawn = -Infinity));
  const marks = new Marks(store, blocks);
  const bar = new Bar(byId("timeline-place"), {
    seek, live: backToLive, jump, play: toggle, redraw: () => (drawn = -Infinity), branch,
  });
  const sign = make("div", { class: "past-sign", id: "past-sign", hidden: true });
  const words = make("span", { class: "past-ago" }); // it changes all the time: the slider says it when it is asked
  const told = make("span", { class: "unseen", role: "status" });
  byId("view").append(told);
  sign.append(make("span", { "aria-hidden": "true", text: "You look at the past" }, words), make("button", { type: "button", class: "main", text: "Back to live", title: "Alt+L", click: backToLive }),
    make("button", { type: "button", class: "main past-branch", text: "Go on from here", click: () => void branch() }));
  byId("view").append(sign);
  let playing = false;
  let jumps = 0; // that were asked for
  let before = 0; // the page's clock at the last frame [ms]
  let drawn = -Infinity; // when marks were drawn last [ms]
  /** @type {ReturnType<import("./blocks.js").Block["at"]> | null} */
  let seen = null;

  /** @param {number} t [s] */
  function seek(t) {
    if (t >= world.now) backToLive();
    else look(Math.max(t, blocks.reaches));
  }

  function toggle() {
    playing = !playing;
    before = performance.now();
    if (playing && lookedAt() === null) seek(world.now - LOOK_BACK);
  }

  async function branch() {
    const at = lookedAt();
    if (at === null) return;
    try {
      await goOnFrom(connection, at);
      backToLive();
      toasts.tell("this room is yours alone: it goes on from the moment that you looked at");
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
  }

  /** @param {1 | -1} direction */
  async function jump(direction) {
    const at = lookedAt();
    const jumped = ++jumps;
    playing = false;
    const { mark, far } = await marks.next(at ?? world.now, direction, bar.jumps.value, world.now);
    if (jumped !== jumps || lookedAt() !== at) return; // somebody has gone elsewhere meanwhile
    if (mark) {
      look(mark.t);
      toasts.tell(mark.text);
    } else if (direction > 0 && at !== null && !far) backToLive();
    else toasts.tell(`nothing of this kind in the ${FARTHEST} minutes ${direction > 0 ? "after" : "before"}`);
  }

  onLook((t) => {
    document.body.classList.toggle("looks-back", t !== null);
    sign.hidden = t === null;
    write(told, t === null ? "" : "You look at the past");
    if (t === null) {
      playing = false;
      seen = null;
      tellThen(null);
    }
  });
  world.jumpWatchers.push(() => {
    blocks.forget();
    backToLive();
  });
  store.on(["session", "alive"], ({ alive }) => {
    if (!alive) backToLive();
  });
  document.addEventListener("keydown", (event) => {
    if (withAlt(event) === "KeyL") {
      event.preventDefault();
      backToLive();
    }
  });

  world.elsewhere = () => {
    const at = performance.now();
    if (playing && lookedAt() !== null) {
      const t = Number(lookedAt()) + (bar.speed * (at - before)) / 1000;
      if (t > world.now - LAST) backToLive();
      else look(t);
    }
    before = at;
    const t = lookedAt();
    const block = t === null ? null : blocks.of(t);
    if (block && t !== null) {
      seen = block.at(t);
      if (playing && t + AHEAD > block.data.until && block.data.whole) blocks.want(Math.floor(t / BLOCK) + 1);
    }
    show(t, Boolean(block));
    if (at - drawn > PAUSE) {
      drawn = at;
      bar.mark(marks.between(bar.range.min, bar.range.max));
    }
    if (t === null) return null;
    if (!seen) return stands() || null; // until it is known how it was
    return { state: { ...seen.state, t }, outputs: seen.outputs, flags: (seen.running ? RUNNING : 0) | (seen.moving ? MOVING : 0) };
  };

  /** Return what was shown last of the room: not the present, when somebody looks at the past. A rehearsal is neither. */
  function stands() {
    return world.state && !world.other && { state: world.state, outputs: world.outputs, flags: 0 };
  }

  /** @param {number | null} t @param {boolean} here whether what was then is here */
  function show(t, here) {
    const { now } = world;
    bar.show({ now, t, reaches: blocks.reaches, loading: t !== null && !here, playing, problem: t !== null && !here ? blocks.problem : "" });
    if (t === null) return;
    write(words, `: ${ago(now - t)}${here ? "" : " …"}`);
    if (seen && here) tellThen(then(seen));
  }

  /** Return what was then as a status shows it. @param {NonNullable<typeof seen>} one @returns {import("../looking.js").Then} */
  function then({ state, step, running, moving, X_VT }) {
    const contacts = store.now.contacts.filter(({ start }) => start <= state.t).length;
    return {
      location: components(X_VT), mode: running ? "running" : moving ? "moving" : "idle", program: step?.program ?? "", line: step?.line ?? 0,
      text: step?.text ?? "", held: state.held[0] ?? "", contacts,
    };
  }
}
