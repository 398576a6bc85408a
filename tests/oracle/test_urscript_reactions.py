"""Timers, REACT, REACTI, IGNORE and LOCK in URScript, in both ways, beside the run."""

from typing import Any

import pytest

from tests.oracle.urscript.interpreter import Motion
from tests.support_urscript import AT_REST, TICK, InTime, exported, joints_alike, same_motions
from vrts.base.source import SourceFile
from vrts.dispatch.saying.table import read_table
from vrts.engine.memory.events import Printed
from vrts.engine.run import Run

PLACES = """.LOCATIONS
safe              460.00    50.00   200.00    90.00    90.00     0.00
left              440.00   110.00   250.00    85.00    88.00     5.00
right             470.00   -60.00   240.00    95.00    93.00    -8.00
.END
"""
TIMERS = """.PROGRAM main
MOVE safe
BREAK
TIMER 1 = 0
WAIT SIG(1001) OR (TIMER(1) > 1.5)
IF TIMER(1) > 1.5 THEN
SIGNAL 1
ELSE
SIGNAL 2
END
MOVES left
TIMER 2 = -1
SIGNAL 3
BREAK
WAIT TIMER(2) > 2
SIGNAL -3
x = TIMER(0)
WAIT (TIMER(0) - x) > 0.5
SIGNAL 3
.END
"""
REACT = """.PROGRAM main
n = 0
REACT 1001, seen
MOVE safe
MOVE left
MOVES right
BREAK
SIGNAL 1
DELAY 1
MOVES safe
BREAK
TYPE n
.END
.PROGRAM seen
SIGNAL 2
n = n + 1
REACT 1001, seen
SIGNAL -2
.END
"""
REACTI = """.PROGRAM main
REACTI 1001, guard
MOVE safe
BREAK
MOVES left
BREAK
SIGNAL 1
MOVES right
BREAK
.END
.PROGRAM guard
SIGNAL 2
TYPE "stopped"
BREAK
WAIT SIG(-1001)
SET p = HERE
SET d = DEST
DEPARTS 15
CALL back
MOVES p:TRANS(0,0,-3,90,-90,0)
MOVES d
BREAK
SIGNAL -2
.END
.PROGRAM back
DEPART 5
.END
"""
HALTS = REACTI.replace('TYPE "stopped"', 'BREAK\nTYPE "stopped"\nHALT')
IGNORED = REACTI.replace("MOVES left", "IGNORE 1001\nMOVES left")
LOCKED = REACT.replace("MOVE left", "LOCK 5\nMOVE left\nBREAK\nLOCK 0")
WAITS = REACTI.replace("MOVES left\nBREAK", "DELAY 2\nBREAK\nWAIT SIG(1002)\nMOVES left\nBREAK")
LATE = 2.0 * TICK  # [s] VAL-II notes at a tick and goes on at the next one


def beside(
    steps: str, *changes: tuple[float, int, bool]
) -> tuple[InTime, Run, list[Any], list[float]]:
    """Carry a program out beside its run, with inputs that change in time."""
    text = steps + PLACES
    folder, run = exported(text, inputs={}, changes=changes)
    assert folder.files is not None, folder.diagnostics
    table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
    timed = InTime(run, table.inputs)
    done = timed.carried_out(folder.files["program.script"].decode())
    same_motions(done, run, rounded=False)
    joints_alike(done, run)
    shown = [word for e in run.events if isinstance(e, Printed) for word in e.text.split()]
    told = [item[1] for item in done if not isinstance(item, Motion) and item[0] == "text"]
    assert [str(round(w)) if isinstance(w, float) else w for w in told] == shown
    later = timed.told_alike(table.outputs)
    assert all(-LATE < by < AT_REST + LATE for by in later), later
    return timed, run, done, later


@pytest.mark.parametrize("on_s", [3.0, 99.0], ids=["on", "never"])
def test_timers_count_while_the_arm_moves_and_rests(on_s: float) -> None:
    _, run, _, later = beside(TIMERS, (on_s, 1001, True))
    assert len(later) == 4
    assert len(run.motions) == 2


@pytest.mark.parametrize(
    "changes",
    [
        (),
        ((1.0, 1001, True),),
        ((1.0, 1001, True), (1.2, 1001, False), (4.5, 1001, True)),
        ((0.0, 1001, True), (2.0, 1001, False), (4.9, 1001, True), (5.0, 1001, False)),
    ],
    ids=["never", "once", "twice", "was-on"],
)
def test_a_reaction_comes_at_once_and_the_arm_moves_on(
    changes: tuple[tuple[float, int, bool], ...],
) -> None:
    _, _, done, _ = beside(REACT, *changes)
    assert not any(not isinstance(item, Motion) and item[0] == "stopj" for item in done)


@pytest.mark.thorough
@pytest.mark.parametrize("steps", [REACTI, HALTS, IGNORED, WAITS], ids=["on", "halt", "no", "wait"])
@pytest.mark.parametrize("on_s", [0.4, 1.1, 99.0])
def test_reacti_stops_the_arm_and_goes_on_behind_the_motion(steps: str, on_s: float) -> None:
    changes = ((on_s, 1001, True), (on_s + 2.0, 1001, False), (9.0, 1002, True))
    _, run, done, _ = beside(steps, *changes)
    stops = sum(not isinstance(item, Motion) and item[0] == "stopj" for item in done)
    assert stops == sum(motion.cut for motion in run.motions)


@pytest.mark.parametrize("on_s", [1.0, 2.5])
def test_lock_lets_reactions_wait(on_s: float) -> None:
    beside(LOCKED, (on_s, 1001, True))


BESIDE = """.PROGRAM main
n = 0
PCEXECUTE lamp, CYCLES
MOVE safe
MOVES left
BREAK
IF SIG(1001) THEN
PCEND
END
MOVES right
BREAK
DELAY 1.5
BREAK
TYPE n
SIGNAL 1
MOVE safe
BREAK
WAIT SIG(-2)
PCABORT
SIGNAL -1
.END
.PROGRAM lamp
SIGNAL 2
TIMER 1 = 0
CALL blink
WAIT TIMER(1) > 0.9
n = n + 1
.END
.PROGRAM blink
WAIT TIMER(1) > 0.5
SIGNAL -2
.END
"""


@pytest.mark.parametrize("cycles", [1, 3, -1])
@pytest.mark.parametrize("on_s", [0.3, 99.0], ids=["end", "never"])
def test_a_second_program_is_a_thread(cycles: int, on_s: float) -> None:
    text = BESIDE.replace("CYCLES", str(cycles)) + PLACES
    folder, run = exported(text, inputs={}, changes=((on_s, 1001, True),))
    assert folder.files is not None, folder.diagnostics
    table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
    timed = InTime(run, table.inputs)
    done = timed.carried_out(folder.files["program.script"].decode())
    same_motions(done, run, rounded=False)
    told = [item for item in done if not isinstance(item, Motion) and item[0] == "text"]
    shown = [e.text for e in run.events if isinstance(e, Printed)]
    assert [f"{item[1]:.0f}" for item in told] == [text.strip() for text in shown]
    stops = 5  # of the arm and of the waits: VAL-II takes a little longer at each
    later = timed.told_alike(table.outputs)
    assert all(abs(by) < stops * AT_REST for by in later), later


def test_what_both_programs_know_is_not_looked_at_while_the_arm_moves() -> None:
    for steps, says in (
        (BESIDE.replace("MOVES left\n", "MOVES left\nn = 3\n"), "the second program knows `n`"),
        (BESIDE.replace("n = 0\n", "n = 0\nREACT 1002, blink\n"), "the program watches inputs"),
        (BESIDE.replace("PCEND", "PCEND -1"), "PCEND takes back"),
        (BESIDE.replace("lamp, CYCLES", "lamp, 2, 3"), "PCEXECUTE goes on with a program"),
    ):
        folder, _ = exported(steps.replace("CYCLES", "2") + PLACES, inputs={1001: True})
        headlines = [d.headline for d in folder.diagnostics if d.is_error]
        assert headlines, steps
        assert headlines[0].startswith(says)
