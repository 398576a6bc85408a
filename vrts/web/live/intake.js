// What the server tells, put where it belongs.

const MOST_CHAT = 500;
const MOST_NOTES = 200;
const MOST_EVENTS = 500;
const MOST_CONTACTS = 300;
const MOST_OUTPUT = 20_000; // characters
const FIRST = -1; // session number of a room whose session has not begun

/** @typedef {import("./protocol.js").Message} Message */
/** @typedef {import("./protocol.js").Contact} Contact */

/** Reads messages into the store; what the 3D world needs at its own time goes to the bodies. */
export class Intake {
  /**
   * @param {import("./store.js").Store} store @param {import("./bodies.js").Bodies} bodies
   * @param {{refused: (message: Message) => void, jumped: () => void, left: () => void, now: () => number}} heard `left`: for another room; `now`: session time that is shown [s]
   */
  constructor(store, bodies, heard) {
    this.store = store;
    this.bodies = bodies;
    this.heard = heard;
  }

  /** @param {Message} message */
  take(message) {
    const { store } = this;
    switch (message.type) {
      case "welcome":
        store.set({ you: message.you, name: message.name, supervisor: message.supervisor });
        if (!message.resumed) store.set({ chat: [] });
        break;
      case "snapshot": {
        const other = store.now.room !== null && message.room.id !== store.now.room.id;
        store.set({ room: message.room, rooms: message.rooms, scenes: message.scenes, noSession: null });
        store.set({ notes: message.notes });
        if (message.chat.length) store.set({ chat: message.chat });
        store.set({ stopped: null, announced: null, hands: null, pointed: null }); // told after this, if there is any
        if (other) this.heard.left();
        this.state(message, other);
        break;
      }
      case "state": this.state(message, false); break;
      case "no_session": store.set({ noSession: /** @type {any} */ (message) }); break;
      case "people": store.set({ people: message.people, barred: message.barred, muted: message.muted }); break;
      case "control": store.set({ control: /** @type {any} */ (message) }); break;
      case "chat": store.set({ chat: [...store.now.chat, /** @type {any} */ (message)].slice(-MOST_CHAT) }); break;
      case "noted": store.set({ notes: [...store.now.notes, /** @type {any} */ (message)].slice(-MOST_NOTES) }); break;
      case "now": store.set({ status: message.status }); break;
      case "event": this.event(message.event); break;
      case "wall": store.set({ wall: message.rooms, projector: message.projector }); break;
      case "rooms": this.rooms(message); break;
      case "code": store.set({ code: { code: message.code, url: message.url } }); break;
      case "announced": store.set({ announced: message.id ? /** @type {any} */ (message) : null }); break;
      case "stopped": store.set({ stopped: message.at ? /** @type {any} */ (message) : null }); break;
      case "hands": store.set({ hands: /** @type {any} */ (message) }); break;
      case "pointed": store.set({ pointed: /** @type {any} */ (message) }); break;
      case "refused": this.heard.refused(message); break;
    }
  }

  /** @param {Message} message */
  rooms(message) {
    const own = message.rooms.find((/** @type {{id: string}} */ room) => room.id === this.store.now.room?.id);
    this.store.set({ rooms: message.rooms, projector: message.projector, room: own ?? this.store.now.room });
  }

  /** Everything about the session, whole. @param {Message} message @param {boolean} other whether it is another room's than before */
  state(message, other) {
    const { state } = message;
    // a rewind goes back in the same session, and who was away has not heard of it
    if (other || message.session !== this.store.now.session || (state && state.status.time_s < this.heard.now())) this.heard.jumped();
    if (!state) {
      if (other) this.store.set({ programs: [], places: [], contacts: [], near: [], events: [], output: "", task: null });
      this.store.set({ session: message.session ?? FIRST, sceneUrl: message.scene_url, alive: false, status: null, marked: null });
      return;
    }
    this.bodies.reset(state.bodies);
    this.store.set({
      session: message.session, sceneUrl: message.scene_url, alive: true, status: state.status, programs: state.programs, places: state.places ?? [],
      contacts: state.contacts, near: state.near, events: state.events, output: state.output,
      task: state.task, marked: state.marked,
    });
  }

  /** @param {Message} event of the session */
  event(event) {
    const { store } = this;
    switch (event.type) {
      case "moved": this.bodies.add(event.bodies); break;
      case "happened": store.set({ events: [...store.now.events, /** @type {any} */ (event)].slice(-MOST_EVENTS) }); break;
      case "output":
        store.set({ output: (store.now.output + event.text).slice(-MOST_OUTPUT) });
        if (store.now.status) store.set({ status: { ...store.now.status, prompt: event.prompt } });
        break;
      case "marked": store.set({ marked: /** @type {any} */ (event) }); break;
      case "programs": store.set({ programs: event.programs }); break;
      case "checked": {
        // what is found late is shown late, but it is shown
        const heard = (/** @type {Contact} */ row) => ({ ...row, heard: this.heard.now() });
        store.set({ contacts: merged(store.now.contacts, event.contacts.map(heard)), near: merged(store.now.near, event.near.map(heard)) });
        break;
      }
      case "began":
        this.heard.jumped();
        store.set({ notes: store.now.notes.filter(({ at_s: at }) => at < event.time_s) });
        break;
    }
  }
}

/**
 * Return rows with newer ones; a contact that has gone on replaces what was known of it.
 * @param {Contact[]} known @param {Contact[]} fresh
 */
function merged(known, fresh) {
  if (!fresh.length) return known;
  const key = (/** @type {Contact} */ c) => `${c.first}\n${c.second}\n${c.start}`;
  const rows = new Map([...known, ...fresh].map((row) => [key(row), row]));
  return [...rows.values()].sort((a, b) => a.start - b.start).slice(-MOST_CONTACTS);
}
