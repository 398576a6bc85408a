// What the page knows. Panels listen to the names they show.

/**
 * @typedef {object} Known
 * @property {"connecting"|"open"|"waiting"|"ended"} connection
 * @property {string} ended why there is no connection any more
 * @property {string} you id of one's own person
 * @property {string} name
 * @property {boolean} supervisor
 * @property {boolean} resets whether every operator may reset and rewind
 * @property {boolean} alone whether there is nobody else to come
 * @property {boolean} course whether there are assignments
 * @property {boolean} robots whether there are robots of one's own, or time slots
 * @property {import("./protocol.js").Hands | null} hands that are up in robots of students
 * @property {{person: string, body: string} | null} pointed what somebody else points at
 * @property {import("./protocol.js").RoomEntry | null} room
 * @property {import("./protocol.js").RoomEntry[]} rooms
 * @property {string} projector id of the room that it shows
 * @property {import("./protocol.js").SceneEntry[]} scenes
 * @property {number} session
 * @property {string} sceneUrl
 * @property {boolean} alive whether the session runs
 * @property {import("./protocol.js").NoSession | null} noSession why none begins by itself
 * @property {import("./protocol.js").Person[]} people
 * @property {string[]} barred names of those who were sent away, for supervisors
 * @property {string[]} muted names of those who are not heard, for supervisors
 * @property {import("./protocol.js").Control} control
 * @property {import("./protocol.js").Chat[]} chat
 * @property {import("./protocol.js").Status | null} status of what is now: what may be done goes by it
 * @property {import("./past/shown.js").Shown | null} shown status of the moment that is looked at: what is told goes by it
 * @property {import("./protocol.js").Program[]} programs
 * @property {import("./protocol.js").Contact[]} contacts
 * @property {import("./protocol.js").Contact[]} near
 * @property {import("./protocol.js").Happened[]} events
 * @property {import("./protocol.js").TaskView | null} task
 * @property {import("./protocol.js").Marked | null} marked the public mark with every lost point
 * @property {import("./protocol.js").Noted[]} notes at moments of the session
 * @property {import("./protocol.js").HandPlace[]} places where the hand grips and sets down
 * @property {string} output the end of what the monitor shows
 * @property {import("./protocol.js").WallRow[]} wall
 * @property {{code: string, url: string}} code the class code that works now, for supervisors
 * @property {import("./protocol.js").Announced | null} announced what stands on top of every page
 * @property {import("./protocol.js").Stopped | null} stopped who stopped the arm, until it moves again
 */

/** @returns {Known} */
function nothing() {
  return {
    connection: "connecting", ended: "", you: "", name: "", supervisor: false, alone: false, resets: false, course: false, robots: false, hands: null, pointed: null, room: null, rooms: [], projector: "",
    scenes: [], session: -1, sceneUrl: "", alive: false, noSession: null, people: [], barred: [], muted: [], chat: [], status: null, shown: null, programs: [],
    notes: [],
    places: [], contacts: [], near: [], events: [], output: "", task: null, marked: null, wall: [], announced: null, stopped: null, code: { code: "", url: "" },
    control: { holder: "", lease: "", queue: [], locked: false, frozen: false, chat: true, turn_s: 0, idle_s: 0, ends: 0 },
  };
}

/** Holds the values and tells of changes, at once. */
export class Store {
  constructor() {
    this.now = nothing();
    /** @type {{names: Set<string>, tell: (now: Known) => void}[]} */
    this.listeners = [];
  }

  /** @param {Partial<Known>} changes */
  set(changes) {
    const now = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (this.now));
    const names = Object.entries(changes).filter(([name, value]) => now[name] !== value).map(([name]) => name);
    Object.assign(this.now, changes);
    for (const { names: wanted, tell } of this.listeners) if (names.some((name) => wanted.has(name))) tell(this.now);
  }

  /**
   * Be told now, and whenever one of some values changes.
   * @param {(keyof Known)[]} names @param {(now: Known) => void} tell
   */
  on(names, tell) {
    this.listeners.push({ names: new Set(names), tell });
    tell(this.now);
  }

  /** Whether one may give commands. */
  get operator() {
    const { control, you } = this.now;
    return you !== "" && control.holder === you;
  }
}
