"""Programs with one mistake: what would mend them is found, small, and earns what is said."""

from functools import cache

import pytest

from tests.golden.examples import EXAMPLES
from tests.mutants.measure import size
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import Mended, mended
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.repair.search import Budget
from vrts.repair.trying.trial import Stage

EXAMPLE = EXAMPLES[0]
RIGHT = (EXAMPLE / "solution.v2").read_text()

MISTAKES = {  # kind of edit: what stands there wrongly, what it was, the line that is to blame
    "sense": ("        OPENI                           ; let go", "CLOSEI ; let go", 20),
    "number": ("APPRO start, 120", "APPRO start, -120", 13),
    "name": ("base1_put)", "base2_put)", 7),
    "superfluous": ("        MOVES start ", "        CLOSEI\n        MOVES start ", 15),
    "arguments": ("carry(can1_grip, base2_put)", "carry(base2_put, can1_grip)", 6),
    "row": ("750.00   450.00", "450.00   750.00", 25),
    "unit": ("750.00   450.00  -225.00", "29.53    17.72    -8.86", 25),
    "missing": ("        CLOSEI                          ; stop, close, wait", "; stop", 16),
    "misspelt": ("MOVE safe\n        CALL", "MOVE save\n        CALL", 5),
}


@cache
def setting() -> Setting:
    """Return the task of the first example."""
    return load_task(EXAMPLE / "task.toml")


def of(text: str, budget: Budget | None = None) -> Mended:
    """Return what would mend a program in the task of the first example."""
    program = ProgramFile(text.encode(), "program.v2")
    return mended(Request(program, setting()), budget)


DEAR = "number"  # which is mended by a command in the usual run: `test_fix_behaviour`


@pytest.mark.thorough
@pytest.mark.parametrize(
    "kind",
    [*(kind for kind in MISTAKES if kind != DEAR), pytest.param(DEAR, marks=pytest.mark.thorough)],
)
def test_one_mistake_is_mended_where_it_was_made(kind: str) -> None:
    before, after, line = MISTAKES[kind]
    wrong = RIGHT.replace(before, after, 1)
    assert wrong != RIGHT
    found = of(wrong)
    best = found.repairs[0]
    assert abs(best.change.line - line) <= 1
    assert best.mark == 10
    assert best.change.size <= size(RIGHT, wrong)


def test_what_is_told_is_so_when_it_is_written_and_verified_anew() -> None:
    """Each repair has the size that it claims, and its program the mark."""
    wrong = RIGHT.replace("DEPARTS 200", "DEPARTS 20")
    found = of(wrong)
    assert found.repairs
    for repair in found.repairs:
        again = of(repair.text)
        assert again.assessment.grade is not None
        assert again.assessment.grade.mark == repair.mark == 10
        assert repair.change.size == size(wrong, repair.text)


def test_a_right_program_is_left_alone() -> None:
    found = of(RIGHT)
    assert (found.repairs, found.executions, found.refused) == ((), 0, None)


def test_the_count_of_executions_ends_the_search() -> None:
    wrong = RIGHT.replace("SPEED 100 ALWAYS", "SPEED 1 ALWAYS").replace("OPENI", "CLOSEI")
    found = of(wrong, Budget(executions=3))
    assert found.executions == 3
    assert not found.repairs


def test_what_does_not_compile_is_refused_with_a_sentence() -> None:
    assert "does not compile" in (of("MOVE it move").refused or "")


def test_only_the_full_mark_counts() -> None:
    """The stages are in the order in which a candidate comes through them."""
    assert list(Stage)[-1] is Stage.FULL


def test_where_nothing_earns_the_full_mark_what_earns_most_is_known() -> None:
    """Two mistakes: within a few executions one of them is put right."""
    wrong = RIGHT.replace("base1_put        ", "base1_putt       ")
    wrong = wrong.replace("can1_grip, base2_put", "base2_put, base2_put")
    found = of(wrong, Budget(executions=30, helpers=0))
    grade = found.assessment.grade
    assert not found.repairs
    assert grade is not None
    assert found.better is not None
    assert grade.mark < found.better.mark < 10
