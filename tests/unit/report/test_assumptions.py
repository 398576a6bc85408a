"""The list of decisions is made of the marks in the source."""

import subprocess
import sys
from pathlib import Path

import pytest

from vrts.report.assumptions import assumptions_in, decisions, text_of

SOURCE = '''
"""A module."""

LIMIT = 5  # [m] farther is away [assumed, manual language/numbers#subscripts]
# assumed: no document says how long
TIME = 3.5
OTHER = 7  # measured


def rule(x):
    """Return the nearest. Halves go away from zero [assumed]. More words."""
'''


def test_marks_in_comments_and_docstrings() -> None:
    found = assumptions_in("a.b", SOURCE)
    assert [(entry.what, entry.why, entry.about) for entry in found] == [
        ("LIMIT = 5", "[m] farther is away", "manual language/numbers#subscripts"),
        ("TIME = 3.5", "assumed: no document says how long", ""),
        ("rule()", "Halves go away from zero", ""),
    ]
    assert text_of(found).splitlines()[:2] == [
        "a.b",
        "  LIMIT = 5  -- [m] farther is away; manual language/numbers#subscripts",
    ]


FIELDS = '''
"""Rules of the house. Names are long [assumed, manual language/names#longest]."""

class Limits:
    depth: int = 200  # calls [assumed]

ARM = Arm(
    name="arm",
    speed=degrees(
        90,
    ),  # assumed
)
TABLE = _by_name(Row("SPEED", 100.0, "upper limit [assumed]"))
'''


def test_fields_tables_and_modules_are_named() -> None:
    found = assumptions_in("a.b", FIELDS)
    assert [(entry.what, entry.why, entry.about) for entry in found] == [
        ("a.b", "Names are long", "manual language/names#longest"),
        ("Limits.depth = 200", "calls", ""),
        ("ARM.speed = degrees(90)", "assumed", ""),
        ("'SPEED' = 100.0", "upper limit", ""),
    ]


def test_uses_are_found_by_name_and_by_import() -> None:
    constant = "LIMIT = 5  # [assumed]\n\ndef one():\n    return LIMIT\n"
    user = "from vrts.a.b import LIMIT\n\ndef two():\n    return LIMIT\n"
    stranger = "LIMIT = 7\n\ndef three():\n    return LIMIT\n"
    field = "class Limits:\n    depth: int = 2  # [assumed]\n"
    reader = "def four(limits):\n    return limits.depth\n"
    sources = {"a.b": constant, "c": user, "d": stranger, "e": field, "f": reader}
    found = decisions(sources)
    assert [(entry.name, entry.uses) for entry in found] == [
        ("LIMIT", ("a.b.one", "c.two")),
        ("Limits.depth", ("f.four",)),
    ]
    assert text_of(found).splitlines()[-1] == "      a field `depth` is read in f.four"


def test_a_module_without_marks_yields_nothing() -> None:
    assert assumptions_in("a", "X = 1\n") == []


@pytest.mark.thorough
def test_command_lists_known_decisions() -> None:
    vrts = Path(sys.executable).with_name("vrts")
    done = subprocess.run(
        [vrts, "explain", "--assumptions"], capture_output=True, text=True, check=True
    )
    for known in ("OUTPUTS = range(1, 33)", "HIGHEST_SUBSCRIPT = 32767"):
        assert known in done.stdout
