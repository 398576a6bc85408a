"""The first example is marked as its file of expected results says.

When the difference is wanted: `python -m tests.golden.regenerate`, then read what changed.
"""

from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES, expected, mark, name, programs

EXAMPLE = EXAMPLES[0]


@pytest.mark.parametrize("path", programs(EXAMPLE), ids=name)
def test_a_program_gets_the_mark_and_the_first_message_that_are_expected(path: Path) -> None:
    assert mark(path) == expected(EXAMPLE)[name(path)]


def test_only_the_solution_and_the_slow_program_are_fit_for_the_real_robot() -> None:
    ready = {key for key, row in expected(EXAMPLE).items() if row["ready"]}
    assert ready == {"solution.v2", "submissions/slow.v2"}
