// Names of messages and their fields, as the server defines them; a test compares the two.

/** What the browser may send. */
export const FROM_CLIENT = {
  join: ["room", "rate", "resume", "seen", "version"],
  rate: ["rate"],
  command: ["lease", "number", "action"],
  panic: [],
  request_control: [],
  hand_back: [],
  raise_hand: ["up", "text"],
  wake: [],
  point: ["body"],
  say: ["text", "private", "to"],
  noticed: ["id", "closed"],
  note: ["text"],
  reach: ["of", "position_m", "oat_rad", "straight"],
  program: ["of", "name"],
  go_on_from: ["of", "at_s"],
  hand_over: ["person"],
  lower_hand: ["room"],
  lock: ["on"],
  freeze: ["on", "everywhere"],
  kick: ["person"],
  allow: ["name"],
  mute: ["person", "on"],
  unmute: ["name"],
  set_chat: ["on"],
  set_turn: ["turn_s", "idle_s"],
  set_scene: ["scene"],
  go_on: ["without_last"],
  make_rooms: ["rooms"],
  close_room: ["room"],
  broadcast: ["text", "scene"],
  end_announcement: [],
  watch_wall: ["on"],
  project: ["room"],
  export_log: ["of", "room"],
};

/** What an operator may do: the `action` of a command. */
export const ACTIONS = {
  line: ["line"],
  interrupt: [],
  upload: ["name", "text"],
  go: ["position_m", "oat_rad", "straight"],
  step: ["frame", "axis", "way", "size"],
  jog: ["frame", "axis", "way", "speed"],
  keep: [],
  let_go: [],
  hand: ["open"],
  ready: [],
  record: ["name"],
  save: ["name"],
  reset: [],
  rewind: ["time_s"],
};

/** What the server sends. */
export const FROM_SERVER = {
  welcome: ["you", "name", "supervisor", "room", "resume", "resumed", "rate", "version"],
  snapshot: ["room", "rooms", "scenes", "number", "session", "scene_url", "state", "chat", "notes"],
  people: ["people", "barred", "muted"],
  control: ["holder", "lease", "queue", "locked", "frozen", "chat", "turn_s", "idle_s", "ends"],
  chat: ["number", "at", "person", "name", "text", "private", "to", "role"],
  noted: ["number", "at_s", "name", "text"],
  event: ["number", "event"],
  now: ["status"],
  state: ["session", "scene_url", "state"],
  no_session: ["why", "help", "choices"],
  result: ["number", "of", "result"],
  refused: ["of", "code", "text", "help"],
  reached: ["of", "result"],
  program_text: ["of", "result"],
  branched: ["of", "room"],
  wall: ["rooms", "projector"],
  rooms: ["rooms", "projector"],
  code: ["code", "url"],
  announced: ["id", "at", "name", "text", "seen", "closed", "people"],
  stopped: ["at", "person", "name", "role"],
  hands: ["hands", "more", "rooms", "awake"],
  pointed: ["person", "body"],
  log_file: ["of", "url"],
  closed: ["code", "text"],
};

/** What comes from a session inside of them. */
export const FROM_SESSION = {
  moved: ["time_s", "bodies"],
  happened: ["time_s", "kind", "text", "program", "line"],
  output: ["time_s", "text", "prompt"],
  programs: ["programs"],
  checked: ["checked_s", "contacts", "near", "undetermined", "mark"],
  marked: ["time_s", "mark", "total", "lost", "parts"],
  began: ["time_s", "epoch_s"],
  done: ["ref", "at_s", "accepted", "text", "help", "code", "counts", "row"],
  reached: ["ref", "reachable", "why", "code", "branch", "joints_rad", "way", "touches", "path_m", "method"],
  status: ["time_s", "joints_rad", "location", "hand_m", "program", "mode", "step", "line", "text", "speed",
    "signals", "held", "prompt", "contacts", "checked_s", "mark", "tool", "total"],
  snapshot: ["ref", "status", "bodies", "programs", "contacts", "near", "events", "output", "task", "marked", "places"],
};

export const VERSION = 1;
export const LONGEST_PROGRAM = 200_000; // characters of an uploaded file
export const LONGEST_CHAT = 1000; // characters
export const LONGEST_NOTE = 200; // characters

/**
 * @typedef {{type: string, [field: string]: any}} Message
 * @typedef {{id: string, name: string, role: "viewer"|"operator"|"supervisor", hand: boolean, muted: boolean,
 *   away: boolean, rate: number}} Person
 * @typedef {{id: string, name: string, scene: string, task: string, people: number, offered: boolean, own: string}} RoomEntry
 * @typedef {{id: string, task: boolean}} SceneEntry
 * @typedef {{room: string, where: string, name: string, since: number, text: string, place: number, here: boolean,
 *   helping: string[]}} Hand `since`: Unix time [s]
 * @typedef {{hands: Hand[], more: number, rooms: number, awake: number}} Hands
 * @typedef {{why: string, help: string, choices: string[]}} NoSession
 * @typedef {{number: number, at: number, person: string, name: string, text: string, private: boolean, to: string,
 *   role: "viewer"|"operator"|"supervisor"|null}} Chat
 * @typedef {{holder: string, lease: string, queue: string[], locked: boolean, frozen: boolean, chat: boolean,
 *   turn_s: number, idle_s: number, ends: number}} Control
 * @typedef {{id: number, at: number, name: string, text: string, seen: number, closed: number, people: number}} Announced
 * @typedef {{at: number, person: string, name: string, role: "viewer"|"operator"|"supervisor"|null}} Stopped
 * @typedef {{time_s: number, joints_rad: number[], location: number[], hand_m: number, program: string, mode: string,
 *   step: number, line: number, text: string, speed: number, signals: number[], held: string, prompt: string,
 *   contacts: number, checked_s: number, mark: number | null, tool: number[], total: number}} Status
 * @typedef {{name: string, body: string, X: number[]}} HandPlace in the frame of its body; without one, in the world
 * @typedef {{body: string, start: number, lie: string, X: number[], support: string | null}} Placed
 * @typedef {{name: string, lines: string[], fault: string, main?: boolean}} Program
 * @typedef {{first: string, second: string, parts: string[], text: string, start: number, end: number,
 *   deepest: number, point: number[], held: string, line: number, depthMm?: number, distanceMm?: number,
 *   heard?: number}} Contact `heard`: session time at which the page learnt of it [s]
 * @typedef {{time_s: number, kind: string, text: string, program: string, line: number}} Happened
 * @typedef {{number: number, at_s: number, name: string, text: string}} Noted
 * @typedef {{points: string, kind: string, text: string, at_s: number | null}} Lost
 * @typedef {{check: string, title: string, kind: string, answer: string, points: string, most: string, text: string}} Part
 * @typedef {{time_s: number, mark: number, total: number, lost: Lost[], parts: Part[]}} Marked
 * @typedef {{lower: number[], upper: number[]}} BoxView corners [m]
 * @typedef {{kind: "goal"|"relation", check: string, title: string, words: string, bodies: string[], places: import("./goal_distance.js").Place[],
 *   shapes: Record<string, import("./goal_distance.js").Shape>, positionMm: number, orientationDeg: number, other?: string, box?: BoxView | null}} GoalView
 *   a relation has neither shapes nor tolerances
 * @typedef {{check: string, name: string, point: number[], radius: number, approach: number[] | null, words: string}} ViaView
 * @typedef {{title: string, text: string, total: number, zeroAt: number, ordered: boolean, goals: GoalView[], vias: ViaView[],
 *   zones: ({name: string} & BoxView)[], rules: {text: string, name: string, worth: string}[]}} TaskView what `task_view` makes of a task
 * @typedef {{ref: number, at_s: number, accepted: boolean, text: string, help: string, code: string}} Done
 * @typedef {{text: string, parts: [string, string], start: number, end: number, point: [number, number, number],
 *   at_goal: boolean}} WayTouch
 * @typedef {{reachable: boolean, why: string, code: string, branch: string[], joints_rad: number[],
 *   way?: "free"|"touches"|"unknown"|"", touches?: WayTouch[], path_m?: number[], method?: string}} Reached
 * @typedef {{id: string, name: string, scene: string, scene_url?: string, task: string, operator: string, people: number, hands: string[],
 *   queue: number, time_s: number, line: string, contacts: number, mark: number | null, joints_rad: number[],
 *   alive: boolean, hand_m: number, stopped: string, bodies: Placed[]}} WallRow
 */

/**
 * Return a message as text. A field that the protocol does not know is a mistake of ours.
 * @param {string} type @param {Record<string, unknown>} fields
 */
export function packed(type, fields) {
  known(FROM_CLIENT, type, fields);
  if (type === "command") {
    const { type: kind, ...rest } = /** @type {Message} */ (fields.action);
    known(ACTIONS, kind, rest);
  }
  return JSON.stringify({ type, ...fields });
}

/** @param {Record<string, string[]>} names @param {string} type @param {Record<string, unknown>} fields */
function known(names, type, fields) {
  const strange = Object.keys(fields).filter((field) => !names[type]?.includes(field));
  if (!names[type] || strange.length) throw new Error(`no such message: ${type} ${strange.join(" ")}`);
}
