"""What the desk's page computes by itself: who is next, what the list shows, numbers as typed."""

import json
import subprocess
import sys
from pathlib import Path

from tests.__main__ import WEB

DENO = str(Path(sys.executable).parent / "deno")
BODY = """
const row = (id, order, more = {}) => ({ id, name: id, order, final: order, unsafe: [], causes: [],
  assigned: [], finished: [], likeness: null, excused: false, conflict: false, cause: "",
  ...more });
const done = (who, stale = false) => [{ who, mark: 1, stale }];
const rows = [
  row("Çelik", 3, { unsafe: [{ reason: "late" }], causes: ["k"] }),
  row("Ömer", 1, { assigned: ["me"], finished: done("you") }),
  row("Anna", 2, { finished: done("you") }),
  row("Ben", 4, { finished: done("you", true) }),
  row("Eva", 5, { excused: true, likeness: {} }),
];
const names = (list) => list.map((one) => one.name);
const some = (change) => names(filters.shown(rows, { ...filters.everything(), ...change }, "me"));
return {
  next: names(filters.shown(rows, filters.everything(), "me")),
  mark: some({ order: "mark", text: "n" }),
  accents: [some({ text: "CELIK" }), some({ text: "omer" })],
  open: some({ flags: new Set(["open"]) }),
  both: some({ flags: new Set(["open", "mine"]) }),
  reason: some({ reason: "late" }),
  cause: some({ cause: "k" }),
  counts: filters.counts(rows, "me").flags,
  after: [undefined, rows[1], rows[3]].map((now) => filters.nextOpen(rows, now, "me")?.name),
  nobody: filters.nextOpen([rows[4]], undefined, "me"),
  typed: ["−0,5", "+1.", " 7.25 ", ".5", "1e3", "", "1,2,3", "NaN", "-0.0004", "1e308"]
    .map(words.typed),
  exact: [-0.5, 1, 0.125, 0, 1 / 3].map(words.exact),
  amount: ["-3/2", "4", 2.5, null].map(words.amount),
  points: [-1.5, 0, 2].map(words.points),
  lost: [1.226038, "-13/500", -1.5, null].map(words.lost),
  after_points: [words.after(9.8, 0.5, 10), words.after(0.2, -1, 10), words.after(null, 1, 10)],
  ids: ["Grip: nicht geprüft!", "Grip", "李"].map((title) =>
    words.identifier(title, new Set(["grip"]))),
};
"""


def test_what_the_page_computes(tmp_path: Path) -> None:
    script = tmp_path / "probe.js"
    desk = WEB / "desk"
    script.write_text(
        f'import * as filters from "{(desk / "filters.js").as_uri()}";\n'
        f'import * as words from "{(desk / "words.js").as_uri()}";\n'
        f"console.log(JSON.stringify((() => {{{BODY}}})()));\n",
        encoding="utf-8",
    )
    ran = subprocess.run(
        [DENO, "run", "--no-remote", "--no-npm", str(script)],
        capture_output=True,
        text=True,
        check=True,
    )
    assert json.loads(ran.stdout) == {
        "next": ["Ömer", "Anna", "Çelik", "Ben", "Eva"],
        "mark": ["Anna", "Ben"],
        "accents": [["Çelik"], ["Ömer"]],
        "open": ["Ömer", "Çelik", "Ben"],
        "both": ["Ömer"],
        "reason": ["Çelik"],
        "cause": ["Çelik"],
        "counts": {"unsafe": 1, "mine": 1, "open": 3, "alike": 1},
        "after": ["Ömer", "Çelik", "Ömer"],
        "nobody": None,
        "typed": [-0.5, 1, 7.25, 0.5, None, None, None, None, None, None],
        "exact": ["-1/2", "1", "1/8", "0", "333/1000"],
        "amount": [-1.5, 4, 2.5, None],
        "points": ["−1.5", "±0", "+2"],
        "lost": ["−1.23", "−0.03", "−1.5", ""],
        "after_points": [10, 0, None],
        "ids": ["grip-nicht-gepruft", "grip-2", "item"],
    }
