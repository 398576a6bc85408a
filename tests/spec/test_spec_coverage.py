"""The pages of this folder hold every conformance case.

C1 to C99 are the cases that this project was to show at least, from constants (C1) to BITS (C99); a
page names those that it judges, in its headings or its prose.
"""

import re
from pathlib import Path

FOLDER = Path(__file__).parent
CASE = re.compile(r"\bC(\d+)(?: ?(?:-|to) ?C?(\d+))?\b")
ALL = frozenset(range(1, 100))


def covered() -> set[int]:
    found: set[int] = set()
    for page in FOLDER.glob("*.md"):
        for match in CASE.finditer(page.read_text("utf-8")):
            first = int(match[1])
            found.update(range(first, int(match[2] or first) + 1))
    return found


def test_the_pages_hold_every_case() -> None:
    assert sorted(ALL - covered()) == []


def test_the_pages_name_no_case_that_does_not_exist() -> None:
    assert sorted(covered() - ALL) == []
