// Which moment of the session's past this page looks at, for everybody on the page who wants to lead there.

/**
 * @typedef {object} Then what was at that moment, as the status shows it
 * @property {number[]} location X Y Z [mm] O A T [degrees]
 * @property {string} mode
 * @property {string} program
 * @property {number} line of the program's text; 0: none
 * @property {string} text of that line
 * @property {string} held body in the hand
 * @property {number} contacts that had begun
 */

/** @type {number | null} */
let moment = null; // session time [s]; null: what is now
/** @type {(() => void) | null} what to do when the room is looked at again; null: it is */
let leave = null;
/** @type {((at_s: number | null) => void)[]} */
const watchers = [];
/** @type {((then: Then | null) => void)[]} */
const readers = [];
/** @type {((live: boolean) => void)[]} */
const livers = [];
let told = "null"; // what the readers know
let live = true; // what the livers know
let wishes = 0; // to see the room or its past, fulfilled already or not

/** Look at a moment of the past, alone: nobody else's page changes. @param {number} at_s session time [s] */
export function look(at_s) {
  wishes += 1;
  if (Number.isFinite(at_s)) set(Math.max(at_s, 0));
  changed();
}

/** Look at what is now again. */
export function backToLive() {
  wishes += 1;
  set(null);
  leaveOther();
  changed();
}

/** Return how often somebody has wished to see the room or its past: what comes later than such a wish shows nothing else. */
export function wished() {
  return wishes;
}

/** Look at something else than the room, until somebody looks at the room or its past again. @param {() => void} left told then */
export function lookAtOther(left) {
  set(null);
  leaveOther();
  leave = left;
  changed();
}

/** Whether this page shows what is now in the room. */
export function isLive() {
  return moment === null && leave === null;
}

/** Be told now, and whenever the page begins or ends to show something else than what is now. @param {(live: boolean) => void} tell */
export function onLive(tell) {
  livers.push(tell);
  tell(live);
}

/** Return the moment that is looked at [s]; null: what is now. */
export function lookedAt() {
  return moment;
}

/** Be told now, and whenever another moment is looked at. @param {(at_s: number | null) => void} tell */
export function onLook(tell) {
  watchers.push(tell);
  tell(moment);
}

/** Tell what was then; null: what is now counts again. @param {Then | null} then */
export function tellThen(then) {
  const key = JSON.stringify(then);
  if (key === told) return; // asked for at every frame
  told = key;
  for (const tell of readers) tell(then);
}

/** Be told what was at the moment that is looked at. @param {(then: Then | null) => void} tell */
export function onThen(tell) {
  readers.push(tell);
}

/** @param {number | null} at_s */
function set(at_s) {
  if (at_s === moment) return;
  moment = at_s;
  if (moment !== null) leaveOther(); // who leaves it finds that the past is looked at
  for (const tell of watchers) tell(moment);
}

function changed() {
  if (live === isLive()) return;
  live = !live;
  for (const tell of livers) tell(live);
}

function leaveOther() {
  const left = leave;
  leave = null;
  left?.();
}
