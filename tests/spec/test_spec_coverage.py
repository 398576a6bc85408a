"""The pages of this folder hold every conformance case that can be judged today.

The cases C1 to C99 are numbered in the language reference this project was written from; a page
names those that it judges, in its headings or its prose.
"""

import re
from pathlib import Path

FOLDER = Path(__file__).parent
CASE = re.compile(r"\bC(\d+)(?: ?(?:-|to) ?C?(\d+))?\b")
ALL = frozenset(range(1, 100))

# Judged when the program is compiled, or by what it computes and types.
TEXT = {*range(1, 14)}
OPERATORS = {*range(14, 29)}
FUNCTIONS = {*range(29, 45)}
CONTROL = {*range(45, 61)}
LOCATIONS = {61, 62, *range(66, 76), 78, 79, 81}
STOPS_AND_SIGNALS = {90, 91, 97, 98, 99}
JUDGED = TEXT | OPERATORS | FUNCTIONS | CONTROL | LOCATIONS | STOPS_AND_SIGNALS

# Judged by the arm in motion, by a second program, or by a robot that has no geometry yet.
LATER = {
    63: "joints of the 560",
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


def test_each_case_is_judged_or_has_a_reason_why_not() -> None:
    assert sorted(ALL - JUDGED - LATER.keys()) == []
    assert sorted(JUDGED & LATER.keys()) == []


def test_the_pages_hold_every_case_that_can_be_judged() -> None:
    assert sorted(JUDGED - covered()) == []


def test_a_case_on_a_page_is_listed_as_judged() -> None:
    assert sorted(covered() - JUDGED) == []
