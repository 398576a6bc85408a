"""What a rehearsal in the page has come to, and what may be asked of it: the page's own modules."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from tests.__main__ import WEB

DENO = str(Path(sys.executable).parent / "deno")
READY: dict[str, Any] = {
    "begin_s": 100.0,
    "duration_s": 62.5,
    "breakpoints": [],
    "marks": [{"time_s": 101.0, "kind": "contact", "text": "", "line": 2}],
    "contacts": [],
    "near": [],
    "mark": None,
    "note": "",
    "ended": {"why": "completed", "line": 9, "time_s": 162.5, "text": "`main` is over"},
}
LATE = {"why": "end", "time_s": 162.5, "program": "main", "line": 9, "depth": 1}
PLACE = {
    **LATE,
    "step_text": "",
    "text": "",
    "more": 0,
    "variables": [{"name": "i", "value": "2"}, {"name": "j", "value": "1"}],
}
EARLY = {**PLACE, "why": "start", "time_s": 100.0, "variables": [{"name": "i", "value": "1"}]}
BODY = """
const { ready, late, early } = given;
const all = (...happened) => happened.reduce(phase.next, phase.NONE);
const begun = all({ type: "rehearse" });
const there = all({ type: "rehearse" }, { type: "ready", ready });
const at = (place) => all({ type: "rehearse" }, { type: "ready", ready }, { type: "asked" }, { type: "placed", place, step: true });
const asked = phase.next(at(early), { type: "asked" });
const changed = phase.next(at(late), { type: "changed", earlier: true });
const key = (key, ...more) => bar.stepOf({ key, shiftKey: more.includes("shift"), ctrlKey: more.includes("ctrl"), altKey: more.includes("alt"), metaKey: false });
const marks = [1, 2, 2.0004, 5].map((time_s) => ({ time_s, kind: "contact", text: "", line: 1 }));
return {
  before: phase.whyNot(phase.NONE, "run"),
  begun: [phase.whyNot(begun, "over"), phase.words(begun, 0, "")],
  start: ["back", "back_run", "over", "run"].map((step) => phase.whyNot(at(early), step)),
  end: ["over", "into", "out", "run", "back"].map((step) => phase.whyNot(at(late), step)),
  under_way: phase.whyNot(asked, "over"),
  look_meanwhile: phase.next(asked, { type: "placed", place: late, step: false }).asked,
  words: [
    phase.words(at(early), 1, "  MOVE a"), phase.words(changed, 3, "MOVE b"), phase.words(at({ ...early, why: "time", time_s: 165 }), 0, ""),
    phase.words(phase.next(at(late), { type: "changed", earlier: false }), 3, "MOVE b"),
  ],
  over: phase.next(at(late), { type: "ended", message: "It ran too long." }),
  nothing_ends_twice: phase.next(phase.NONE, { type: "changed", earlier: true }).earlier,
  altered: [...phase.altered(early, late)],
  first: [...phase.altered(null, late)],
  seconds: [0, 1.25, 59.94, 61.5, -1].map(phase.seconds),
  keys: [key("F10"), key("F10", "ctrl"), key("F10", "shift"), key("F11"), key("F11", "shift"), key("F2"), key("F2", "shift"), key("F5"), key("F5", "shift"), key("F10", "alt")],
  after: [track.nextMark(marks, 2, 1)?.time_s, track.nextMark(marks, 2, -1)?.time_s, track.nextMark(marks, 5, 1) ?? null],
};
"""  # noqa: E501 -- JavaScript


def asked() -> Any:
    """Return what the page's modules say."""
    names = ("phase", "bar", "track")
    imports = "\n".join(
        f'import * as {name} from "{(WEB / "live" / "rehearsal" / f"{name}.js").as_uri()}";'
        for name in names
    )
    given = json.dumps({"ready": READY, "late": PLACE, "early": EARLY})
    code = f"{imports}\nconst made = (given) => {{{BODY}}};"
    code += f"\nconsole.log(JSON.stringify(made({given})));"
    words = [DENO, "eval", "--no-lock", code]
    done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=60.0)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_what_may_be_asked_follows_from_where_the_rehearsal_stands() -> None:
    said = asked()
    assert said["before"] == "Rehearse first."
    assert said["begun"] == ["The rehearsal is being worked out.", "Being worked out …"]
    begins, ends = "The rehearsal begins here.", "The rehearsal ends here."
    assert said["start"] == [begins, begins, "", ""]
    assert said["end"] == [ends] * 4 + [""]
    assert said["under_way"] == "The step before is under way."
    assert said["look_meanwhile"], "a look at a moment ends no step"
    assert said["words"] == [
        "Start, line 1: MOVE a. 1:02.5 min, 1 contact; main is over",
        "End: main is over (of an earlier text)",
        "At 1:05.0 min, main",
        "End: main is over",
    ]
    over = said["over"]
    assert (over["kind"], over["why"], over["ready"]) == ("ended", "It ran too long.", None)
    assert not said["nothing_ends_twice"]
    assert said["altered"] == ["i", "j"]
    assert said["first"] == [], "nothing has changed where nothing was before"
    assert said["seconds"] == ["0.0 s", "1.3 s", "59.9 s", "1:01.5 min", "0.0 s"]
    assert said["keys"] == ["over", "back", None, "into", "out", "run", "back_run"] + [None] * 3
    assert said["after"] == [5, 1, None]
