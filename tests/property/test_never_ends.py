"""Two programs and their reactions, drawn by chance: "never" is never said of what happens.

The oracle is the same machine without the judgement: it goes on until the programs end, or to its
limit of time. What it does before the judgement says anything has to be the same.
"""

from random import Random

import pytest

from tests.laws import examples
from tests.support_programs import ALONE, compiled
from vrts.engine.controller import execute
from vrts.engine.machine import tick
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.scene.model import Limits, Scenario

LIMITS = Limits(statements=20_000, time_s=60.0)
JUDGED = {"V502", "V503", "V504"}
AT_A_LIMIT = {"V510", "V511"}
FOUND = 0.9  # share of the programs without an end that are found out

STEPS = """
WAIT SIG(2001) | WAIT SIG(2002) | WAIT SIG(-2001) | WAIT SIG(1001) | WAIT SIG(2001,2002) |
WAIT n == 1 |
WAIT n > k | WAIT m[1] == 2 | WAIT | WAIT | SIGNAL 2001 | SIGNAL -2001 | SIGNAL 2002 |
SIGNAL -2002 |
SIGNAL 2000+n | n = n+1 | n = 1 | k = k+1 | k = 0 | m[1] = n | IF n > 2 GOTO 20 |
IF SIG(2002) GOTO 10 |
IF k > 30 GOTO 20 | GOTO 10 | GOTO 20 | IF TIMER(1) > 3 GOTO 20 | TIMER 1 = 0 |
WAIT TIMER(1) > 2 | BITS 2001, 2 = n |
CALL sub(n) | CALL sub(k) | CALL sub(m[1]) | REACT 2001, hit | REACT 2002, hit, 5 |
REACT 1001, over | IGNORE 2001 |
LOCK 3 | LOCK 0 | REACTE catch | x = 1/n | PULSE 2002, 0.5 | DLYSIG 2001, 1 | TWAIT 0.3 |
n = TAS(k,2) |
IF STATUS("b") == 0 GOTO 20 | x = RANDOM | IF x > 0.5 GOTO 10 | PROMPT n | STOP | BRAKE
"""
OF_MAIN = """
DELAY 0.5 | BREAK | MOVE a | MOVE c | OPENI | PCABORT | PCEND | PCEND -1 | PCEXECUTE b |
WAIT DISTANCE(HERE,a) < 1 | HALT | SPEED 20
"""
STARTS = ("PCEXECUTE b, -1", "PCEXECUTE b, -1", "PCEXECUTE b", "PCEXECUTE b, 5", "n = 0")
CALLED = ("a1 = a1+1", "WAIT a1 > 1", "SIGNAL 2002", "n = 1", "RETURN", "WAIT SIG(2001)")


def drawn(number: int) -> tuple[Module, Scenario]:
    """Return two programs, what reacts, and what happens meanwhile."""
    draw = Random(number)
    shared = [step.strip() for step in STEPS.split("|")]
    main = [*shared, *(step.strip() for step in OF_MAIN.split("|"))]

    def some(pool: list[str], most: int) -> str:
        return "\n".join(draw.choice(pool) for _ in range(draw.randint(0, most)))

    def program(name: str, *parts: str) -> str:
        return f".PROGRAM {name}\n" + "\n".join(part for part in parts if part) + "\n.END\n"

    given = "n = 0\nk = 0\nx = 0\nm[1] = 0"
    text = (
        program(
            "main", given, draw.choice(STARTS), "10 WAIT", some(main, 6), "20 WAIT", some(main, 3)
        )
        + program("b", "10 WAIT", some(shared, 5), "20 k = k", some(shared, 2))
        + program("sub(a1)", some(list(CALLED), 2))
        + program("hit", some([*CALLED[2:], "k = 5", "HALT"], 2))
        + program("over", "n = 3")
        + program("catch", draw.choice(["RETURNE", "n = 1\nRETURNE", "RETURN"]))
        + ".LOCATIONS\na 900 200 100 90 90 0\nc 900 0 300 90 90 0\n.END\n"
    )
    inputs = ((draw.uniform(0.5, 9.0), 1001, True),) if draw.random() < 0.3 else ()
    scenario = Scenario(limits=LIMITS, inputs=inputs, answers=("1",) * draw.choice((0, 2)))
    return compiled(text, "val2+"), scenario


def says_nothing(*_: object) -> None:
    """Stand for the judgement."""


def codes(run: Run) -> set[str]:
    return {found.rule.code for found in run.findings if found.is_error}


def check(number: int, monkeypatch: pytest.MonkeyPatch) -> tuple[bool, bool]:
    """Compare both ways; return whether a program has no end, and whether that was found out."""
    module, scenario = drawn(number)
    run = execute(module, ALONE, scenario)
    assert "V505" not in {found.rule.code for found in run.findings}
    with monkeypatch.context() as patch:
        patch.setattr(tick, "judge", says_nothing)
        alone = execute(module, ALONE, scenario)
    ends = alone.ending is not Ending.LIMIT
    if ends or not codes(run) & JUDGED:
        assert run.events == alone.events
        assert run.ending is alone.ending
        return not ends, False
    assert codes(alone) & (JUDGED | AT_A_LIMIT)
    assert run.ended_s is not None
    until = run.ended_s - 0.001
    past = [event for event in run.events if event.time_s < until]
    assert past == [event for event in alone.events if event.time_s < until]
    return True, True


def test_what_happens_is_never_said_not_to(monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(examples(200)):
        check(number, monkeypatch)


@pytest.mark.thorough
@pytest.mark.parametrize("first", range(1000, 4000, 500))
def test_most_of_what_never_ends_is_found_out(first: int, monkeypatch: pytest.MonkeyPatch) -> None:
    found = [check(number, monkeypatch) for number in range(first, first + 500)]
    endless = [early for never, early in found if never]
    print(f"{len(endless)} of {len(found)} never end; {sum(endless)} of them are ended early")
    assert sum(endless) >= FOUND * len(endless)
