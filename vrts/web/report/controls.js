// Buttons and keys of the replay.

/** @typedef {import("../viewer/player.js").Player} Player */
/** @typedef {import("../viewer/viewer.js").Viewer} Viewer */
/** @typedef {import("./events.js").EventList} EventList */

const byId = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (document.getElementById(id));

const BUTTONS = [["forward", 1, "Play forward"], ["backward", -1, "Play backward"]];
const TURN = Math.PI / 12; // of the view by one press [rad]

/** Keys that elements of the page need for themselves, by selector. @type {[string, string[]][]} */
const OWN = [
  ["select", [" ", "ArrowLeft", "ArrowRight", "Home", "End", "b", ",", "."]],
  ["button, a, summary, input[type=checkbox]", [" "]],
  [".source, .excerpt", [" ", "ArrowLeft", "ArrowRight", "Home", "End"]],
];

/**
 * @param {Player} player @param {Viewer | null} viewer @param {EventList} events
 * @param {(t: number) => void} jump
 */
export function bindControls(player, viewer, events, jump) {
  byId("time").addEventListener("input", () => jump(Number(byId("time").value)));
  byId("forward").addEventListener("click", () => player.toggle(1));
  byId("backward").addEventListener("click", () => player.toggle(-1));
  byId("event-before").addEventListener("click", () => jump(events.before(player.t)));
  byId("event-after").addEventListener("click", () => jump(events.after(player.t)));
  byId("speed").addEventListener("change", () => { player.speed = Number(byId("speed").value); });
  byId("show-trace").addEventListener("change", () => viewer?.showTrace(byId("show-trace").checked));
  byId("show-goals").addEventListener("change", () => viewer?.showGoals(byId("show-goals").checked));
  for (const button of document.querySelectorAll("[data-turn]")) {
    button.addEventListener("click", () => viewer?.turn(TURN * Number(/** @type {HTMLElement} */ (button).dataset.turn)));
  }
  for (const button of document.querySelectorAll("[data-zoom]")) {
    button.addEventListener("click", () => viewer?.zoom(Number(/** @type {HTMLElement} */ (button).dataset.zoom)));
  }
  const looks = [...document.querySelectorAll("[data-look]")];
  for (const look of looks) {
    look.addEventListener("click", () => {
      viewer?.look(/** @type {HTMLElement} */ (look).dataset.look ?? "");
      player.show(player.t, player);
      for (const other of looks) other.setAttribute("aria-pressed", String(other === look));
    });
  }
}

/**
 * Space plays and pauses, B plays backward, arrows step by 0.1 s (with shift 1 s), comma and full
 * stop go from event to event, Home and End to the ends.
 * @param {Player} player @param {EventList} events @param {(t: number) => void} jump
 */
export function bindKeys(player, events, jump) {
  /** @type {Record<string, (event: KeyboardEvent) => void>} */
  const keys = {
    " ": () => player.toggle(1),
    b: () => player.toggle(-1),
    ArrowRight: (event) => jump(player.t + (event.shiftKey ? 1 : 0.1)),
    ArrowLeft: (event) => jump(player.t - (event.shiftKey ? 1 : 0.1)),
    ",": () => jump(events.before(player.t)),
    ".": () => jump(events.after(player.t)),
    Home: () => jump(0),
    End: () => jump(player.end),
  };
  document.addEventListener("keydown", (event) => {
    const target = /** @type {HTMLElement} */ (event.target);
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const own = OWN.some(([selector, taken]) => taken.includes(key) && target.closest(selector));
    const action = keys[key];
    if (!action || own || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action(event);
  });
}

/** @param {Player} player */
export function showPlaying(player) {
  for (const [id, direction, words] of /** @type {[string, number, string][]} */ (BUTTONS)) {
    const playing = player.playing && player.direction === direction;
    byId(id).classList.toggle("playing", playing);
    byId(id).setAttribute("aria-label", playing ? "Pause" : words);
  }
}
