// A rehearsal of what is in the editor: run by a process of one's own, shown to nobody else.

import { byId } from "../dom.js";
import { mark as markProblems } from "../editor/diagnostics.js";
import { backToLive, isLive, wished } from "../looking.js";
import { LONGEST_PROGRAM } from "../protocol.js";
import { Bar, stepOf } from "./bar.js";
import { Beside } from "./beside.js";
import { breakpointLines, forgetSigns, otherBreakpoints, showHere, tellIdle } from "./gutter.js";
import { Earlier } from "./lines.js";
import { Link } from "./link.js";
import { NONE, next, whyNot, words } from "./phase.js";
import { Picture } from "./picture.js";
import { Track } from "./track.js";

const SAME = 1e-3; // moments nearer than this are one [s]
const SEVERITIES = { error: 1, warning: 2, note: 3 }; // as the editor counts them
const SAID = ["rehearse", "ready", "placed", "ended"]; // what is read out

/**
 * @param {import("../pages/room.js").App} app
 * @param {import("@codemirror/view").EditorView} view
 * @param {{help: import("../editor/help.js").Help, name: () => string, shown: () => void, why: () => string}} bench the name of the file; told
 *   when the picture shows a rehearsal or the room; why a text cannot be rehearsed
 */
export function mountRehearsal({ store, world, toasts }, view, bench) {
  let phase = NONE;
  let plays = false; // as soon as it stands at the start
  let warned = false; // that the picture cannot show it
  let of = ""; // which room and scene it is of
  let lines = ""; // with breakpoints, as they were told last
  let since = 0; // which wishes to see the room came before the step that is under way
  /** @type {Earlier | null} the text that is rehearsed */
  let earlier = null;
  const link = new Link(() => store.now.room?.id ?? "", take);
  const bar = new Bar({ rehearse, go, stop });
  const beside = new Beside(seek);
  const picture = new Picture(world, link, { moment, left });
  const track = new Track(byId("timeline-place"), { seek, play, speed: (speed) => (picture.speed = speed), live: backToLive });

  /** @param {Parameters<typeof next>[1]} happened */
  function become(happened) {
    phase = next(phase, happened);
    show(SAID.includes(happened.type));
  }

  function show(said = false) {
    const line = lineNow(phase.place?.line ?? 0);
    const stands = words(phase, line, line ? view.state.doc.line(line).text : "");
    const away = phase.kind === "there" && !phase.shown && phase.place ? `${stands}. The picture shows the room: any step shows the rehearsal again.` : stands;
    bar.show((step) => whyNot(phase, step), phase.kind === "begun" || phase.kind === "there", away, said && phase.place?.why !== "time" ? stands : null);
    beside.element.hidden = phase.kind !== "there";
    track.show(picture.t, picture.playing, line ? `line ${line}` : "");
  }

  /** @param {number} line of the text that is rehearsed */
  function lineNow(line) {
    return earlier?.toNow(line, view.state.doc) ?? 0;
  }

  /** @param {number} line of the text that is rehearsed */
  function textThen(line) {
    return earlier && line > 0 && line <= earlier.doc.lines ? earlier.doc.line(line).text.trim() : "";
  }

  function linesThen() {
    const then = breakpointLines(view).map((line) => earlier?.toThen(line, view.state.doc) ?? line);
    return [...new Set(then)].filter((line) => line > 0); // a line that is newer has no step
  }

  /** Tell breakpoints where they are other ones. */
  function tellBreakpoints() {
    const wanted = linesThen();
    if (wanted.join() !== lines && link.send("breakpoints", { lines: wanted })) lines = wanted.join();
  }

  // --- what is asked -----------------------------------------------------------------------------

  function rehearse() {
    const { room, alive } = store.now;
    const text = view.state.doc.toString();
    const why = !room ? "There is no room." : !alive ? "The room has no session now." : text.length > LONGEST_PROGRAM ? "It is too long for a program." : bench.why();
    if (why) {
      link.stop();
      end(why);
      return;
    }
    if (phase.shown) backToLive();
    earlier = new Earlier(view.state.doc);
    of = place();
    showHere(view, 0);
    lines = linesThen().join();
    since = wished();
    link.begin({ name: bench.name(), text, from: bar.from.value, breakpoints: linesThen() });
    warned = false;
    become({ type: "rehearse" });
  }

  /** @param {import("./phase.js").Step} step */
  function go(step) {
    const why = whyNot(phase, step);
    if (why) {
      if (phase.kind !== "there" || !phase.asked) toasts.tell(why);
      return;
    }
    picture.way = null;
    become({ type: "asked" });
    since = wished();
    link.go(step);
  }

  /** @param {number} t [s] */
  function seek(t) {
    if (phase.kind !== "there") return;
    picture.seek(t);
    if (!phase.shown) void shown();
  }

  async function play() {
    if (phase.kind === "there" && await shown()) picture.toggle();
  }

  function stop() {
    if (phase.kind === "none" || phase.kind === "ended") return;
    link.stop();
    end("The rehearsal has been ended.");
  }

  // --- what is heard -----------------------------------------------------------------------------

  /** @param {import("./link.js").Message} message */
  function take(message) {
    if (message.type === "ready") begin(/** @type {any} */ (message));
    else if (message.type === "stopped") void stopped(/** @type {any} */ (message), Boolean(message.step));
    else if (message.type === "breakpoints") idle(message.breakpoints);
    else if (message.type === "refused" && message.id === 0) toasts.warn(message.message);
    else if (message.type === "refused" && message.question !== undefined) turnedAway(message);
    else if (message.type === "refused") refused(message);
    else if (message.type === "ended" && (!message.lost || phase.kind === "begun" || phase.kind === "there")) end(message.message);
  }

  /** @param {import("./phase.js").Ready} ready */
  function begin(ready) {
    const { begin_s: begin = 0, duration_s: length, marks } = ready;
    const range = { begin, end: begin + length };
    picture.begin(range, ready);
    track.begin(range, marks);
    beside.begin(ready, lineNow);
    idle(ready.breakpoints);
    become({ type: "ready", ready });
    tellBreakpoints(); // set or taken away meanwhile
    become({ type: "asked" });
    link.go(ready.breakpoints.length ? "run" : "start");
    plays = !ready.breakpoints.length && !window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  /** @param {import("./phase.js").Place} place @param {boolean} step whether somebody went there by a step */
  async function stopped(place, step) {
    const { t, seen } = picture;
    const works = place.why === "time" && Math.abs(t - place.time_s) < SAME ? seen?.step : null;
    if (works?.at) place = { ...place, line: works.at, program: works.program, step_text: works.text }; // what the arm does, not what comes next
    become({ type: "placed", place, step });
    beside.show(place);
    picture.place = { time_s: place.time_s, program: place.program, line: place.line, text: textThen(place.line) || place.step_text, over: ["end", "error"].includes(place.why) || !place.program };
    if (!picture.playing) showHere(view, lineNow(place.line));
    const there = step && since === wished() && await shown();
    if (there && phase.kind === "there") {
      picture.glide(place.time_s);
      if (plays) picture.toggle();
      plays = false;
    } else if (step && since !== wished() && phase.kind === "there") { // somebody has gone back to the room meanwhile
      picture.seek(place.time_s);
      plays = false;
    }
    show();
  }

  /** One question is refused, and the rehearsal goes on. @param {import("./link.js").Message} message */
  function turnedAway({ question, message }) {
    toasts.warn(message);
    if (question === "breakpoints") lines = "?"; // the next change tells them
    if (question === "go") become({ type: "refused" });
  }

  /** @param {import("./link.js").Message} message */
  function refused({ problems = [], more = 0, message }) {
    const changed = phase.earlier;
    const errors = problems.filter((/** @type {import("./phase.js").Problem} */ { severity }) => severity === "error");
    const count = errors.length + (errors.length === problems.length ? Number(more) : 0); // errors come first
    end(count ? `Not rehearsed: ${count === 1 ? "1 mistake" : `${count} mistakes`} in the text.` : message);
    const [first, ...others] = problems.filter((/** @type {import("./phase.js").Problem} */ { line }) => line > 0);
    if (!first || changed) return;
    void markProblems(view, bench.help, [first, ...others].map((/** @type {import("./phase.js").Problem} */ one) => ({
      range: { start: { line: one.line - 1, character: one.column - 1 }, end: { line: one.end_line - 1, character: one.end_column - 1 } },
      message: one.help ? `${one.message}\n${one.help}` : one.message, code: one.code, severity: SEVERITIES[one.severity] ?? 1,
    })));
    const { doc } = view.state;
    const line = doc.line(Math.min(first.line, doc.lines));
    view.dispatch({ selection: { anchor: Math.min(line.from + first.column - 1, line.to) }, scrollIntoView: true });
    view.focus();
  }

  /** @param {import("./phase.js").Checked[]} checked */
  function idle(checked) {
    tellIdle(view, new Set(checked.filter(({ verified }) => !verified).map(({ line }) => lineNow(line))));
  }

  // --- the picture -------------------------------------------------------------------------------

  async function shown() {
    const before = wished();
    const there = await picture.show(() => before === wished());
    if (before !== wished()) return false; // somebody has gone back to the room meanwhile
    if (!there && phase.kind === "there" && !warned) toasts.warn(picture.blocks.problem || "the picture cannot show the rehearsal");
    warned = !there;
    if (there && !phase.shown) {
      become({ type: "shown", shown: true });
      bench.shown();
    }
    return there;
  }

  function left() {
    become({ type: "shown", shown: false });
    bench.shown();
  }

  /** @param {number} t [s] that the picture shows */
  function moment(t) {
    if (phase.kind !== "there") return;
    const { playing, way, seen } = picture;
    if (!phase.asked && !(way && !playing) && Math.abs(t - (phase.place?.time_s ?? -1)) > 1e-6) link.at(t);
    const line = lineNow((playing ? seen?.step?.at : phase.place?.line) ?? 0);
    if (playing) showHere(view, line); // sooner than the answer comes
    track.show(t, playing, line ? `line ${line}` : "");
  }

  /** End it, and say why. @param {string} why */
  function end(why) {
    const { shown: seen } = phase;
    phase = next(phase, { type: "ended", message: why });
    if (seen && !isLive()) backToLive();
    showHere(view, 0);
    earlier = null;
    become({ type: "ended", message: why });
  }

  // --- the page ----------------------------------------------------------------------------------

  /** Which room and scene it would be of. */
  function place() {
    return `${store.now.room?.id} ${store.now.room?.scene}`;
  }

  store.on(["room"], () => {
    if (phase.kind === "none" || of === place()) return;
    link.close();
    end("The rehearsal ended: this is another room or scene.");
  });
  document.addEventListener("keydown", (event) => {
    const inBench = event.composedPath().includes(bar.element.parentElement ?? bar.element);
    if (document.querySelector("dialog[open]") || !(phase.shown || inBench)) return;
    if (inBench && event.key === "Enter" && event.shiftKey && (event.ctrlKey || event.metaKey)) rehearse();
    else {
      const step = stepOf(event);
      if (!step || phase.kind !== "there") return; // the browser's
      if (!event.repeat || !phase.asked) go(step);
    }
    event.preventDefault();
    event.stopPropagation();
  }, true);
  show();

  return {
    element: bar.element,
    beside: beside.element,
    /** Whether the picture shows a rehearsal. */
    get shown() {
      return phase.shown;
    },
    /** @param {any} update of the editor */
    changed(update) {
      if (update.docChanged) {
        earlier?.change({ changes: update.changes, startState: update.startState, newDoc: update.state.doc });
        if (earlier) become({ type: "changed", earlier: !earlier.doc.eq(view.state.doc) });
      }
      if (otherBreakpoints(update) && phase.kind === "there") tellBreakpoints();
    },
    /** The text is another one. */
    forget() {
      forgetSigns(view);
      if (phase.kind === "begun" || phase.kind === "there") stop();
    },
  };
}
