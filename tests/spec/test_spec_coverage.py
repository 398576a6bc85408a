"""The pages of this folder hold every conformance case that can be judged today.

The cases are numbered in the language reference this project was written from.
"""

import re
from pathlib import Path

FOLDER = Path(__file__).parent
CASE = re.compile(r"\bC(\d+)(?: ?(?:-|to) ?C?(\d+))?\b")

# Judged by a run of the arm or of a second program: they belong to the engine.
LATER = {
    58: "EXECUTE with cycles",
    59: "EXECUTE with cycles",
    62: "POINT is a command of the monitor",
    63: "WHERE is a command of the monitor",
    64: "joints of the 560",
    65: "joints of the 560",
    76: "joints of the 560",
    77: "joints of the 560",
    80: "joints of the 560",
    82: "signals beside motion",
    83: "signals beside motion",
    84: "the hand beside motion",
    85: "the hand beside motion",
    86: "continuous path",
    87: "speed of motion",
    88: "monitor speed",
    89: "branch changes on straight lines",
    92: "reactions",
    93: "reactions",
    94: "reactions",
    95: "HERE in motion",
    96: "process control programs",
}


def covered() -> set[int]:
    found: set[int] = set()
    for page in FOLDER.glob("*.md"):
        for match in CASE.finditer(page.read_text("utf-8")):
            first = int(match[1])
            found.update(range(first, int(match[2] or first) + 1))
    return found


def test_every_case_is_covered_or_belongs_to_the_engine() -> None:
    assert sorted(set(range(1, 100)) - covered() - LATER.keys()) == []
