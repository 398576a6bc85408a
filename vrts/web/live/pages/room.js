// A room: connection, world and panels put together.

import { Bodies } from "../bodies.js";
import { Connection, Refusal } from "../connection.js";
import { byId, write } from "../dom.js";
import { Intake } from "../intake.js";
import { bindKeys } from "../keys.js";
import { mountLayout } from "../layout/mount.js";
import { mountSelection } from "../selection.js";
import { barOf, mountNotices } from "../notices.js";
import { endStill, readyNow } from "../still/ended.js";
import { Store } from "../store.js";
import { Toasts } from "../toasts.js";
import { World } from "../world.js";
import { backToLive } from "../looking.js";
import { keepShown, leadBackFor } from "../past/shown.js";
import { mountEditor } from "../editor/panel.js";
import { mountButtons } from "../panels/buttons.js";
import { mountMonitor } from "../panels/monitor.js";
import { mountNoSession, sentence } from "../panels/no_session.js";
import { mountOverlay } from "../panels/overlay.js";
import { mountPendant } from "../panels/pendant.js";
import { mountPointing } from "../panels/pointing.js";
import { mountSettings, wantedRate } from "../panels/settings.js";
import { mountStatus } from "../panels/status.js";
import { mountTask } from "../panels/task.js";
import { mountTabs } from "../panels/tabs.js";
import { mountTop } from "../panels/top.js";
import { mountViews } from "../panels/views.js";

/**
 * @typedef {object} App what panels work with
 * @property {Store} store
 * @property {Connection} connection
 * @property {World} world
 * @property {Toasts} toasts
 * @property {(action: import("../protocol.js").Message) => Promise<import("../protocol.js").Done>} command give a
 *   command; rejects when it is refused
 * @property {(action: import("../protocol.js").Message) => void} act give a command; tells when it is refused
 * @property {() => void} panic
 */

/** @param {import("../account.js").Me} me @param {string} wanted id of the room; empty: one's own */
export function showRoom(me, wanted) {
  byId("room").hidden = false;
  const app = started(wanted, false);
  app.store.set({ name: me.name, supervisor: me.supervisor, alone: me.alone, resets: me.students_reset, course: Boolean(me.course), robots: Boolean(me.robots), rooms: me.rooms });
  const notices = mountNotices(barOf("room"), app);
  const { panic } = app;
  app.panic = () => {
    const { connection, alive } = app.store.now;
    if (connection === "open" && alive) notices.pressed();
    else if (connection === "open") app.toasts.warn("the room has no session now");
    panic();
  };
  byId("work-link").hidden = !me.course;
  mountTop(app);
  mountViews(app, mountLayout());
  mountSelection(app.world);
  mountOverlay(app);
  mountStatus(app);
  later(app, async () => (await import("../past/past.js")).mountPast(app));
  mountTabs(app);
  mountTask(app);
  mountMonitor(app);
  mountButtons(app);
  mountPendant(app);
  mountPointing(app);
  later(app, async () => (await import("../panels/programs.js")).mountPrograms(app));
  mountEditor(app);
  later(app, async () => (await import("../panels/history.js")).mountHistory(app));
  later(app, async () => (await import("../panels/notes.js")).mountNotes(app));
  later(app, async () => (await import("../panels/chat.js")).mountChat(app));
  if (!me.alone) later(app, async () => (await import("../panels/people.js")).mountPeople(app));
  if (me.robots) {
    later(app, async () => {
      const [bar, hands, own, slots] = await Promise.all([import("../panels/own_bar.js"), import("../panels/own_hands.js"), import("../panels/own.js"), import("../panels/own_slots.js")]);
      bar.mountOwnBar(app);
      hands.mountOwnHands(app);
      own.mountOwn(app);
      slots.mountOwnSlots(app);
    });
  }
  if ((me.supervisor || me.leads) && !me.alone) {
    later(app, async () => {
      const [{ mountLead }, { mountEntrance }] = await Promise.all([import("../panels/lead.js"), import("../panels/entrance.js")]);
      mountLead(app, mountEntrance(app.toasts, app.store), me);
    });
  }
  mountSettings(app);
  bindKeys(app);
  readyNow();
}

/** Add a part of the page that the first picture does not need. @param {App} app @param {() => Promise<void>} part */
function later({ toasts }, part) {
  part().catch((problem) => toasts.warn(`a part of the page could not be loaded (${problem.message}): load the page again`));
}

/**
 * Connect to a room and show its world.
 * @param {string} room @param {boolean} follow whether to follow what the projector is told
 * @returns {App}
 */
export function started(room, follow) {
  const store = new Store();
  const bodies = new Bodies();
  const toasts = new Toasts(byId("toasts"));
  const world = new World(byId("canvas"), bodies);
  const intake = new Intake(store, bodies, {
    refused: (message) => toasts.warn(new Refusal(/** @type {any} */ (message)).message),
    jumped: () => world.forget(),
    left: () => world.clear(),
    now: () => world.now,
  });
  const connection = new Connection({
    message: (message) => intake.take(message),
    frame: (frame) => frame.session === store.now.session && world.take(frame),
    state: (state, why) => store.set({ connection: state, ended: why ?? "" }),
  });
  /** @param {import("../protocol.js").Message} action */
  async function command(action) {
    const why = leadBackFor(action); // who acts sees what follows
    if (why) throw new Refusal({ code: "past", text: why });
    /** @type {import("../protocol.js").Done} */
    const done = await connection.ask("command", { lease: store.now.control.lease, action }, "number");
    if (!done.accepted) throw new Refusal(done);
    return done;
  }
  /** @type {App} */
  const app = {
    store, connection, world, toasts, command,
    act: (action) => void command(action).catch((error) => toasts.warn(error.message)),
    panic: () => (backToLive(), connection.send("panic")) || toasts.warn("there is no connection: the arm cannot be stopped from here"),
  };
  connection.rate = wantedRate();
  keepShown(store);
  mountNoSession(app);
  store.on(["sceneUrl", "noSession", "connection"], ({ sceneUrl, noSession, connection: state, ended }) => {
    const over = state === "ended";
    if (over || noSession?.why) world.clear();
    byId("no-scene").hidden = !over && Boolean(sceneUrl || noSession?.why);
    write(byId("no-scene"), over ? sentence(ended) : "The session is being prepared …");
  });
  store.on(["sceneUrl"], ({ sceneUrl }) => {
    world.load(sceneUrl).catch((error) => noView(error, toasts));
  });
  store.on(["connection", "noSession"], ({ connection, noSession }) => {
    if (connection === "ended" || noSession?.why) endStill();
  });
  store.on(["session", "sceneUrl"], ({ session, sceneUrl }) => {
    if (session >= 0 && !sceneUrl) endStill();
  });
  store.on(["contacts"], ({ contacts }) => (world.contacts = contacts));
  store.on(["status"], ({ status }) => status && world.know(status));
  if (follow) {
    store.on(["projector"], ({ projector }) => {
      if (projector && projector !== store.now.room?.id) connection.enter(projector);
    });
  }
  connection.enter(room);
  Object.assign(window, { vrts: app }); // for tests and for the curious
  return app;
}

/** @param {Error} error @param {Toasts} toasts */
function noView(error, toasts) {
  endStill();
  if (/webgl/i.test(error.message)) byId("no-view").hidden = false;
  else toasts.warn(error.message);
}
