// The projector: the picture alone, large, of the room that the supervisor chooses.

import { byId, make, write } from "../dom.js";
import { barOf, mountNotices } from "../notices.js";
import { PROJECTED } from "../layout/kept.js";
import { mountOverlay } from "../panels/overlay.js";
import { mountSettings } from "../panels/settings.js";
import { mountStatus } from "../panels/status.js";
import { STATES } from "../panels/top.js";
import { mountViews } from "../panels/views.js";
import { isolated } from "../names.js";
import { persons } from "../persons.js";
import { carried } from "../still/carried.js";
import { readyNow } from "../still/ended.js";
import { started } from "./room.js";

/** @param {import("../account.js").Me} me */
export function showProjector(me) {
  byId("room").hidden = false;
  document.body.classList.add("projector");
  const room = carried()?.still?.scene_url.split("/")[2] ?? ""; // /scene/ROOM/SESSION, of which the first picture is
  const app = started(room, true);
  app.store.set({ name: me.name, supervisor: me.supervisor });
  mountNotices(barOf("room"), app, { counts: false });
  mountOverlay(app);
  mountStatus(app);
  mountSettings(app);
  mountViews(app, { look: PROJECTED, keepLook: () => undefined });
  const title = byId("room-name");
  const operator = byId("turn");
  byId("control-button").hidden = byId("panic").hidden = true;
  app.store.on(["room"], ({ room }) => {
    write(title, room?.name ?? "Projector");
    document.title = `${room?.name ?? ""} · projector`;
    byId("task-name").hidden = !room?.task;
    write(byId("task-name"), room?.task ?? "");
  });
  app.store.on(["control", "people"], ({ control, people }) => {
    const holder = people.find(({ id }) => id === control.holder)?.name;
    operator.replaceChildren(holder ? isolated(holder) : "nobody", " has control");
    write(byId("crowd"), `${persons(people, control, "").filter(({ away }) => !away).length} here`);
  });
  app.store.on(["connection", "ended"], ({ connection, ended }) => {
    write(byId("link-state"), ended || STATES[connection]);
    byId("link-state").className = `chip ${connection}`;
  });
  byId("turn").after(make("a", { class: "button", href: "/", text: "To my room" }));
  readyNow();
}
