"""Every further example is marked as expected, and every example has what it needs.

When the difference is wanted: `python -m tests.golden.regenerate`, then read what changed.
"""

from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES, example_of, expected, long_name, mark, name, programs
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.where import Where

FURTHER = [path for example in EXAMPLES[1:] for path in programs(example)]


def folder_name(example: Path) -> str:
    return example.name


each_example = pytest.mark.parametrize("example", EXAMPLES, ids=folder_name)


@pytest.mark.parametrize("path", FURTHER, ids=long_name)
def test_a_program_gets_the_mark_and_the_first_message_that_are_expected(path: Path) -> None:
    assert mark(path) == expected(example_of(path))[name(path)]


@each_example
def test_every_program_is_expected_and_nothing_else(example: Path) -> None:
    assert list(expected(example)) == [name(path) for path in programs(example)]


@each_example
def test_only_the_solution_has_full_marks_and_it_is_fit_for_the_real_robot(example: Path) -> None:
    rows = expected(example)
    assert {key for key, row in rows.items() if row["mark"] == 10.0} == {"solution.v2"}
    assert rows["solution.v2"]["ready"]


@each_example
def test_a_program_that_does_nothing_earns_nothing(example: Path, tmp_path: Path) -> None:
    empty = tmp_path / "empty.v2"
    empty.write_text(".PROGRAM main()\n.END\n")
    a = assess(request_for(empty, Where(task=example / "task.toml")))
    assert a.grade is not None
    assert float(a.grade.mark) == 0.0


@each_example
def test_an_example_has_submissions_that_went_wrong_in_different_ways(example: Path) -> None:
    messages = [row["message"] for row in expected(example).values()]
    assert len(messages) >= 5
    assert len(set(messages)) == len(messages)
