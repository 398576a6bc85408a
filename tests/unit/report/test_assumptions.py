"""The list of decisions is made of the marks in the source."""

import subprocess
import sys
from pathlib import Path

from vrts.report.assumptions import assumptions_in, text_of

SOURCE = '''
"""A module."""

LIMIT = 5  # [m] farther is away [assumed, val2.md 1.2]
# assumed: no document says how long
TIME = 3.5
OTHER = 7  # measured


def rule(x):
    """Return the nearest. Halves go away from zero [assumed]. More words."""
'''


def test_marks_in_comments_and_docstrings() -> None:
    found = assumptions_in("a.b", SOURCE)
    assert [(entry.what, entry.why, entry.about) for entry in found] == [
        ("LIMIT = 5", "[m] farther is away", "val2.md 1.2"),
        ("TIME = 3.5", "assumed: no document says how long", ""),
        ("rule()", "Halves go away from zero", ""),
    ]
    assert text_of(found).splitlines()[:2] == [
        "a.b",
        "  LIMIT = 5  -- [m] farther is away; val2.md 1.2",
    ]


def test_a_module_without_marks_yields_nothing() -> None:
    assert assumptions_in("a", "X = 1\n") == []


def test_command_lists_known_decisions() -> None:
    vrts = Path(sys.executable).with_name("vrts")
    done = subprocess.run(
        [vrts, "explain", "--assumptions"], capture_output=True, text=True, check=True
    )
    for known in ("OUTPUTS = range(1, 33)", "HIGHEST_SUBSCRIPT = 32767", "SETTLING_TICKS = 3"):
        assert known in done.stdout
