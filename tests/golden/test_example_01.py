"""The first example is marked as its file of expected results says.

When the difference is wanted: `python -m tests.golden.regenerate`, then read what changed.
"""

import json
from pathlib import Path

import pytest

from tests.golden.example_01 import EXAMPLE, EXPECTED, mark, name, programs
from vrts.pipeline import assess


@pytest.mark.parametrize("path", programs(), ids=name)
def test_a_program_gets_the_mark_and_the_first_message_that_are_expected(path: Path) -> None:
    expected = json.loads(EXPECTED.read_text(encoding="utf-8"))
    assert mark(path) == expected[name(path)]


def test_every_program_is_expected_and_nothing_else() -> None:
    expected = json.loads(EXPECTED.read_text(encoding="utf-8"))
    assert list(expected) == [name(path) for path in programs()]


def test_only_the_solution_is_fit_for_the_real_robot_with_full_marks() -> None:
    expected = json.loads(EXPECTED.read_text(encoding="utf-8"))
    full = {key for key, row in expected.items() if row["mark"] == 10.0}
    assert full == {"solution.v2"}
    assert {key for key, row in expected.items() if row["ready"]} == {
        "solution.v2",
        "submissions/slow.v2",
    }


def test_a_program_that_does_nothing_earns_nothing(tmp_path: Path) -> None:
    empty = tmp_path / "empty.v2"
    empty.write_text(".PROGRAM main()\n.END\n")
    a = assess(empty, task=EXAMPLE / "task.toml")
    assert a.grade is not None
    assert float(a.grade.mark) == 0.0
