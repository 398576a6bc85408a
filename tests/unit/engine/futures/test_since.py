"""Variables that hold a reading of a timer: how long ago it was is all that tells states apart."""

import pytest

from tests.property.test_explored import compare, searched
from tests.support_programs import compiled, program
from tests.unit.engine.futures.test_regions import proved
from vrts.check.verdict import Answer
from vrts.engine.futures.since import since
from vrts.prove.environment.environment import Environment
from vrts.scene.default import robot_alone

TICK_S = 0.028
WAITS = "WHILE SIG(-1001) DO\n{0}\nDO\nWAIT\nUNTIL {1}\nIF SIG(1002) THEN\nSIGNAL 1\nEND\nEND\n"


def held(body: str, *, once: bool = True) -> dict[str, int]:
    module = compiled(program(body))
    found = since(module, TICK_S, "main", once=once)
    return {name: one.timer for name, one in found.items()}


@pytest.mark.parametrize(
    ("kept", "until"),
    [
        ("t0 = TIMER(1)", "TIMER(1)-t0 > 0.5"),
        ("t0 = TIMER(1)", "0.5 < TIMER(1)-t0"),
        ("t0 = TIMER(1)", "TIMER(1) > t0+0.5"),
        ("t0 = TIMER(1)", "(TIMER(1) > 0.5+t0) OR SIG(1002)"),
        ("t0 = TIMER(1)+0.5", "TIMER(1) > t0"),
        ("t0 = TIMER(1)-0.5", "TIMER(1)-t0 > 1"),
        ("t0 = TIMER(1)", "TIMER(1)-0.5 > t0"),
        ("t0 = TIMER(1)", "(TIMER(1)-t0 > 0.5) AND (TIMER(1)-t0 < 90)"),
    ],
)
def test_a_loop_that_waits_for_a_time_to_pass_costs_few_states(kept: str, until: str) -> None:
    body = WAITS.format(kept, until)
    if until == "TIMER(1)-0.5 > t0":
        assert held(body) == {}, "a form that is not known is followed as before"
        return
    assert held(body) == {"t0": 1}
    found = proved(body)
    assert found.answer is Answer.HOLDS
    assert found.covered.states < 130, "18 ticks, or 36, with two inputs"
    assert any(one.startswith("TIMER(1) is read within 2048 s") for one in found.covered.assumed)


def test_what_has_passed_may_be_kept_before_it_is_compared() -> None:
    body = WAITS.format("t0 = TIMER(1)", "d > 0.5").replace("WAIT\n", "WAIT\nd = TIMER(1)-t0\n")
    assert held(f"d = 0\n{body}") == {"t0": 1}
    found = proved(f"d = 0\n{body}")
    assert found.answer is Answer.HOLDS
    assert found.covered.states < 130


@pytest.mark.parametrize(
    "step",
    [
        "TYPE t0",
        "x = t0",
        "t0 = 3",
        "t0 = TIMER(2)",
        "t0 = TIMER(1)*2",
        "x = TIMER(1)-t0",
        "IF t0 > 1 THEN\nx = 1\nEND",
        "TIMER 1 = 0",
        "n = 1\nTIMER n = 0",
        "IF TIMER(1)-t0 > 0.56 THEN\nx = 1\nEND",
        "CALL other(t0)\n.END\n.PROGRAM other(a)\na = a+1",
    ],
)
def test_a_reading_of_which_more_is_asked_is_kept_as_it_is(step: str) -> None:
    body = f"x = 0\nt0 = TIMER(1)\nWAIT TIMER(1)-t0 > 2\n{step}"
    assert held(body) == {}, "0.56 s are 20 ticks: rounding decides"
    assert held(body.replace(step, "x = 2")) == {"t0": 1}


def test_a_timer_may_be_set_before_anything_is_kept_of_it() -> None:
    body = "x = 0\nTIMER 1 = 0\n" + WAITS.format("t0 = TIMER(1)", "TIMER(1)-t0 > 0.5")
    assert held(body) == {"t0": 1}
    assert held(body, once=False) == {}, "what an execution left is older than the timer"
    assert held(body.replace("TIMER 1", "t0 = TIMER(1)\nTIMER 1")) == {}
    looped = body.replace("TIMER 1 = 0", "FOR i = 1 TO 2\nTIMER 1 = 0\nEND")
    assert held(looped) == {}


def test_what_comes_late_is_found_at_its_time() -> None:
    body = "x = 0\n" + WAITS.format("t0 = TIMER(1)", "TIMER(1)-t0 > 0.5")
    found = proved(body.replace("SIGNAL 1", "x = 1/x"))
    assert found.answer is Answer.VIOLATED
    assert 0.5 < found.found[0].time_s < 0.6


@pytest.mark.parametrize("border", [0.05, 0.1])
@pytest.mark.parametrize("form", ["TIMER(1)-t0 > {}", "TIMER(1) >= t0+{}"])
def test_merging_by_what_has_passed_changes_no_answer(border: float, form: str) -> None:
    until = form.format(border)
    body = (
        "x = 0\nFOR i = 1 TO 2\nt0 = TIMER(1)\nDO\nWAIT\nIF SIG(1001) THEN\nt0 = TIMER(1)\n"
        f"x = x+1\nEND\nUNTIL ({until}) OR (x > 3)\nEND\nIF x == 3 THEN\nx = 1/0\nEND\n"
    )
    module, alone = compiled(program(body)), robot_alone()
    assert held(body) == {"t0": 1}
    apart = searched(module, alone, Environment(), 30_000, merging=False)
    assert apart.is_over
    compare(apart, searched(module, alone, Environment(), 30_000))
