"""Variables that are only compared: two values between the same numbers are one state."""

import math

import pytest

from tests.support_programs import compiled, program
from vrts.check.verdict import Answer
from vrts.engine.futures.regions import compared_only, region
from vrts.engine.futures.timers import ever_new, most_compared
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Proof
from vrts.prove.prove import prove
from vrts.scene.default import robot_alone

LATE = "TIMER 1 = 0\nWHILE SIG(-1001) DO\nlate = TIMER(1)\nIF late > 0.5 THEN\n{}\nEND\nEND\n"


def proved(body: str, states: int = 500) -> Proof:
    asking = Asking(states=states, collisions=False)
    return prove(compiled(program(body)), robot_alone(), Environment(), asking, entry="main")


def test_values_between_two_numbers_are_alike() -> None:
    assert [region(v, (1.0, 2.0)) for v in (0.5, 1.0, 1.5, 1.9, 2.0, 3.0)] == [0, 1, 2, 2, 3, 4]


@pytest.mark.parametrize(
    ("step", "held"),
    [
        ("x = 1", True),
        ("IF 7 <= late THEN\nx = 1\nEND", True),
        ("TYPE late", False),
        ("x = late", False),
        ("late = late+1", False),
        ("IF late > x THEN\nx = 1\nEND", False),
        ("PROMPT late", False),
        ("CASE late OF\nVALUE 1:\nx = 1\nEND", False),
        ("FOR late = 1 TO 3\nx = 1\nEND", False),
        ("CALL other(late)\n.END\n.PROGRAM other(a)\na = a+1", False),
    ],
)
def test_a_variable_is_only_compared_where_nothing_else_looks_at_it(step: str, held: bool) -> None:
    module = compiled(program(f"x = 0\nlate = TIMER(1)\nIF late > 2 THEN\nx = 2\nEND\n{step}"))
    assert ("late" in compared_only(module)) is held
    assert (most_compared(module) < math.inf) is held
    assert list(ever_new(module)) == ([] if held else [("main", 2)])


def test_a_reading_of_a_timer_that_is_kept_ends_no_search() -> None:
    found = proved(LATE.format("SIGNAL 1"))
    assert found.answer is Answer.HOLDS
    assert found.covered.states < 100


def test_what_comes_late_is_found_all_the_same() -> None:
    found = proved("x = 0\n" + LATE.format("x = 1/x"))
    assert found.answer is Answer.VIOLATED
    assert 0.5 < found.found[0].time_s < 0.6


def test_what_makes_every_state_another_is_named() -> None:
    found = proved("t = 0\n" + LATE.format("SIGNAL 1").replace("late > 0.5", "late-t > 0.5"), 100)
    assert found.answer is Answer.UNDETERMINED
    assert any(one.startswith("step 4 of `main`") for one in found.open)
