"""What the page does in a rehearsal: its own modules, with a socket and a page that are none."""

import json
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

from tests.__main__ import WEB

DENO = str(Path(sys.executable).parent / "deno")
MODULES = {
    **{f"@codemirror/{p.stem}": p.as_uri() for p in (WEB / "vendor" / "codemirror").glob("*.js")},
    **{
        f"@lezer/{name}": (WEB / "vendor" / "codemirror" / f"lezer-{name}.js").as_uri()
        for name in ("common", "highlight", "lr")
    },
    **{
        name: (WEB / "vendor" / "codemirror" / f"{name}.js").as_uri()
        for name in ("crelt", "style-mod", "w3c-keyname")
    },
    "@marijn/find-cluster-break": (
        WEB / "vendor" / "codemirror" / "find-cluster-break.js"
    ).as_uri(),
}
TEXT = ".PROGRAM main\n  MOVE a\n  MOVE b\n  MOVE c\n  MOVE d\n.END\n"
CODE = """
import { EditorState } from "@codemirror/state";
import "@codemirror/view";
import "@codemirror/lint";

const made = [];
class Fake {
  constructor() {
    Object.assign(this, { attributes: {}, heard: {}, children: [], style: {}, textContent: "", hidden: false, value: "" });
    this.classList = { toggle() {}, add() {} };
    made.push(this);
  }
  setAttribute(name, value) { this.attributes[name] = value; if (name === "id" || name === "value") this[name] = value; }
  getAttribute(name) { return this.attributes[name] ?? null; }
  addEventListener(type, act) { this.heard[type] = act; }
  append(...children) { this.children.push(...children); }
  replaceChildren(...children) { this.children = children; }
  after() {}
  get told() { return [this.textContent, ...this.children.map((child) => child.told ?? String(child))].join(" ").replace(/ +/g, " ").trim(); }
}
const sockets = [];
class Socket {
  static OPEN = 1;
  constructor() { Object.assign(this, { readyState: 0, sent: [], listeners: {} }); sockets.push(this); }
  addEventListener(type, act) { this.listeners[type] = act; }
  send(data) { this.sent.push(JSON.parse(data)); }
  open() { this.readyState = 1; this.listeners.open(); }
  close() { this.readyState = 3; this.listeners.close(); }
  hear(message) { this.listeners.message({ data: JSON.stringify({ id: this.sent[0].id, ...message }) }); }
}
const document = {
  createElement: () => new Fake(), createElementNS: () => new Fake(), createTextNode: (text) => { const one = new Fake(); one.textContent = text; return one; },
  getElementById: () => new Fake(), addEventListener() {}, querySelector: () => null, body: new Fake(),
};
const set = (name, value) => Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
set("document", document); set("window", globalThis); set("WebSocket", Socket);
set("location", { protocol: "http:", host: "here" }); set("matchMedia", () => ({ matches: true }));

const { Block } = await import(`${LIVE}/past/blocks.js`);
const looking = await import(`${LIVE}/looking.js`);
const gutter = await import(`${LIVE}/rehearsal/gutter.js`);
const { Earlier } = await import(`${LIVE}/rehearsal/lines.js`);
const { mountRehearsal } = await import(`${LIVE}/rehearsal/rehearsal.js`);
const diagnostics = await import("@codemirror/lint");
Block.unpack = async (_, data) => ({ data, at: (t) => ({ state: { t, held: [] }, step: null, running: true, moving: false, outputs: 0, X_VT: [] }) });

const soon = () => new Promise((resolve) => setTimeout(resolve, 5));
const place = (more) => ({ type: "stopped", why: "start", time_s: 0, program: "main", line: 2, depth: 1, step_text: "", text: "", variables: [], more: 0, typed: [], ...more });
const ready = { type: "ready", begin_s: 0, duration_s: 9, breakpoints: [], marks: [], contacts: [], near: [], undetermined: false, problems: [], note: "", mark: null,
  ended: { why: "completed", line: 6, time_s: 9, text: "over" } };

function page() {
  made.length = sockets.length = 0;
  const toasts = [];
  const world = { viewer: { data: { robot: { arm: {} } } }, instead: null };
  const store = { now: { room: { id: "R", scene: "s" }, alive: true }, on() {} };
  const view = {
    state: EditorState.create({ doc: TEXT, extensions: gutter.breakpoints }),
    dispatch(change) {
      const { state: startState } = view;
      const transaction = startState.update(change);
      view.state = transaction.state;
      rehearsal?.changed({ startState, state: view.state, changes: transaction.changes, docChanged: transaction.docChanged });
    },
    focus() {},
  };
  let rehearsal = null;
  rehearsal = mountRehearsal({ store, world, toasts: { tell: (text) => toasts.push(text), warn: (text) => toasts.push(text) } }, view,
    { help: { ask: async () => null }, name: () => "main.v2", shown() {}, why: () => "" });
  const by = (id) => made.find((one) => one.id === id);
  return {
    view, toasts, world, rehearsal, by,
    press: (id) => by(id).heard.click(),
    step: (name) => made.find((one) => one.attributes["aria-label"] === name).heard.click(),
    get socket() { return sockets.at(-1); },
    get state() { return by("rehearsal-state").textContent; },
    get said() { return rehearsal.element.children.at(-1).textContent; },
    line: (number) => view.state.doc.line(number),
    sent: (type) => sockets.flatMap(({ sent }) => sent).filter((one) => one.type === type),
    /** Answer what is asked, as a server does, until nothing is any more. */
    async served(done = 0) {
      for (let round = 0; round < 60; round += 1) {
        await soon();
        const { sent } = sockets.at(-1);
        if (sent.length === done) break;
        const { type, lines, number, time_s } = sent[done++];
        if (type === "rehearse") sockets.at(-1).hear({ ...ready, breakpoints: sent[0].breakpoints.map((line) => ({ line, verified: line !== 6, at: line })) });
        if (type === "breakpoints") sockets.at(-1).hear({ type, breakpoints: lines.map((line) => ({ line, verified: line !== 6, at: line })) });
        if (type === "go") sockets.at(-1).hear(place());
        if (type === "at") sockets.at(-1).hear(place({ why: "time", time_s }));
        if (type === "block") sockets.at(-1).hear({ type, number, data: { whole: true, until: 60 } });
      }
      return done;
    },
  };
}
async function there(...breakpoints) {
  const one = page();
  for (const number of breakpoints) gutter.toggleBreakpoint(one.view, one.line(number).from);
  one.press("rehearse");
  one.socket.open();
  one.done = await one.served();
  return one;
}
const said = {};
{
  const one = await there();
  one.view.dispatch({ changes: { from: 3, insert: "X" } });
  await one.served(one.done);
  said.plain = [one.sent("breakpoints").length, one.world.instead !== null];
}
{
  const one = await there(3, 5, 6);
  const before = one.done;
  one.view.dispatch({ changes: { from: 0, insert: "; first\\n" } }); // their lines go along: nothing is new
  one.done = await one.served(before);
  said.along = one.done - before;
  one.view.dispatch({ changes: { from: one.line(4).from, to: one.line(5).from } }); // the one of 3 is gone
  one.done = await one.served(one.done);
  said.gone = one.sent("breakpoints").map(({ lines }) => lines);
  gutter.toggleBreakpoint(one.view, one.line(3).from); // what was line 2
  gutter.toggleBreakpoint(one.view, one.line(1).from); // there was no such line
  one.done = await one.served(one.done);
  said.moved = one.sent("breakpoints").map(({ lines }) => lines);
}
{
  const one = await there();
  one.step("Step over");
  one.socket.hear({ type: "refused", message: "too many questions wait already", of: "go" });
  said.busy = [one.toasts, one.state, one.rehearsal.shown];
  one.step("Step over");
  said.again = one.sent("go").map(({ what }) => what);
  one.socket.hear({ type: "refused", message: "nothing is rehearsed" });
  said.refused = [one.state, one.rehearsal.shown];
}
{
  const problem = (line, severity) => ({ line, column: 3, end_line: line, end_column: 7, code: "V001", severity, message: `${severity} here`, help: "" });
  const refused = { type: "refused", message: "does not compile", problems: [problem(0, "error"), problem(3, "error"), problem(4, "warning")], more: 0 };
  const marked = ({ state }) => { const found = []; diagnostics.forEachDiagnostic(state, (one, from) => found.push([one.severity, state.doc.lineAt(from).number])); return found; };
  const one = page();
  one.press("rehearse");
  one.socket.open();
  one.socket.hear(refused);
  said.problems = [one.state, marked(one.view), one.view.state.doc.lineAt(one.view.state.selection.main.head).number];
  const other = page();
  other.press("rehearse");
  other.socket.open();
  other.view.dispatch({ changes: { from: 0, insert: "; meanwhile\\n" } });
  other.socket.hear(refused);
  said.meanwhile = [other.state, marked(other.view), other.view.state.selection.main.head];
}
{
  const one = page();
  one.press("rehearse");
  const { socket } = one;
  one.press("rehearsal-stop");
  said.early_stop = [socket.readyState, one.state];
  one.press("rehearse");
  one.rehearsal.forget();
  said.early_open = [one.socket !== socket, one.socket.readyState, one.state];
}
{
  const one = await there();
  const number = one.done;
  one.step("Step over");
  looking.backToLive(); // as PANIC does
  one.socket.hear(place({ why: "step", time_s: 3, line: 3 }));
  await soon();
  said.left = [one.rehearsal.shown, one.world.instead, one.by("rehearsal-time").value, one.said];
  one.step("Step over");
  one.socket.hear(place({ why: "step", time_s: 4, line: 4 }));
  await one.served(one.socket.sent.length);
  said.shown_again = [one.rehearsal.shown, one.world.instead !== null, one.said];
  one.view.dispatch({ changes: { from: one.line(4).to, insert: " ; x" } });
  said.quiet = [one.said, one.state];
  const other = page();
  other.press("rehearse");
  other.socket.open();
  looking.backToLive(); // a command while it is worked out
  await other.served();
  said.never = [other.rehearsal.shown, other.world.instead, other.state];
}
{
  const one = page();
  one.press("rehearse");
  one.socket.open();
  one.socket.hear(ready);
  one.socket.hear(place());
  await soon();
  looking.backToLive(); // while its first minute is on its way
  one.socket.hear({ type: "block", number: 0, data: { whole: true, until: 60 } });
  await soon();
  said.on_its_way = [one.rehearsal.shown, one.world.instead, one.toasts];
}
{
  let state = EditorState.create({ doc: "a\\nb\\nc\\nd" });
  const earlier = new Earlier(state.doc);
  const lines = () => [[1, 2, 3, 4].map((line) => earlier.toNow(line, state.doc)), Array.from({ length: state.doc.lines }, (_, line) => earlier.toThen(line + 1, state.doc))];
  const change = (changes) => { const transaction = state.update({ changes }); state = transaction.state; earlier.change(transaction); return lines(); };
  said.lines = [lines(), change({ from: 2, to: 4 }), change({ from: 0, insert: "n\\n" }), change({ from: 0, to: state.doc.length, insert: "x\\ny" }), change({ from: 0, to: 3, insert: "a\\nb\\nc\\nd" })];
}
console.log(JSON.stringify(said));
Deno.exit(0);
"""  # noqa: E501 -- JavaScript


@cache
def done() -> Any:
    """Return what the page did."""
    live = json.dumps((WEB / "live").as_uri())
    code = f"const LIVE = {live};\nconst TEXT = {json.dumps(TEXT)};\n{CODE}"
    imports = "data:application/json," + json.dumps({"imports": MODULES})
    words = [DENO, "eval", "--no-lock", "--import-map", imports, code]
    ran = subprocess.run(words, capture_output=True, text=True, check=False, timeout=60.0)
    assert ran.returncode == 0, ran.stderr
    return json.loads(ran.stdout)


def test_breakpoints_are_told_once_and_only_where_they_are_others() -> None:
    said = done()
    assert said["plain"] == [0, True], "an edit without breakpoints tells nothing"
    assert said["along"] == 0, "a line that goes along is the same line of the rehearsed text"
    assert said["gone"] == [[5, 6]]
    assert said["moved"] == [[5, 6], [2, 5, 6]], "a line that is newer has no step"


def test_a_question_that_is_refused_ends_no_rehearsal() -> None:
    said = done()
    toasts, state, shown = said["busy"]
    assert toasts == ["too many questions wait already"]
    assert (state, shown) == ("Start, line 2: MOVE a. 9.0 s, no contacts; over", True)
    assert said["again"] == ["start", "over", "over"], "the step may be gone again"
    assert said["refused"] == ["nothing is rehearsed", False]


def test_mistakes_are_counted_and_marked_in_the_text_that_they_are_of() -> None:
    said = done()
    told = "Not rehearsed: 2 mistakes in the text."
    assert said["problems"] == [told, [["error", 3], ["warning", 4]], 3]
    assert said["meanwhile"] == [told, [], 0], "another text is not marked"


def test_a_rehearsal_that_is_not_on_its_way_yet_can_be_ended() -> None:
    said = done()
    assert said["early_stop"] == [3, "The rehearsal has been ended."]
    assert said["early_open"] == [True, 3, "The rehearsal has been ended."]


def test_who_went_back_to_the_room_stays_there_until_the_next_step() -> None:
    said = done()
    assert said["left"] == [False, None, "3", "Step, line 3: MOVE b"]
    assert said["shown_again"] == [True, True, "Step, line 4: MOVE c"]
    shown, instead, state = said["never"]
    assert (shown, instead) == (False, None)
    assert state.endswith(". The picture shows the room: any step shows the rehearsal again.")
    assert said["on_its_way"] == [False, None, []]


def test_a_line_is_read_out_at_a_step_and_not_at_every_key() -> None:
    said, state = done()["quiet"]
    assert said == "Step, line 4: MOVE c"
    assert state == "Step, line 4: MOVE c ; x (of an earlier text)"


def test_lines_of_an_earlier_text_are_found_or_gone() -> None:
    begun, deleted, inserted, pasted, undone = done()["lines"]
    assert begun == [[1, 2, 3, 4], [1, 2, 3, 4]]
    assert deleted == [[1, 0, 2, 3], [1, 3, 4]]
    assert inserted == [[2, 0, 3, 4], [0, 1, 3, 4]]
    assert pasted == [[2, 0, 0, 0], [0, 1]]
    assert undone == begun
