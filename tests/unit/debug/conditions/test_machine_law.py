"""What was noted of the machine is what the machine itself tells where a run comes by once more."""

import random
from functools import cache

import numpy as np
import pytest

from tests.laws import first
from tests.unit.debug.conditions.walk import Present, Walk, as_context
from tests.unit.debug.history.test_tracks import drawn_run
from tests.whole_programs.drawing import drawn
from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import nobody
from vrts.debug.evaluating import CannotTell, read
from vrts.debug.passages import Instant, Passages
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.evaluate import compiler
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import Memory
from vrts.engine.run import Run
from vrts.ir.data import Assign
from vrts.ir.values import Value
from vrts.lang.dialect import DIALECTS, Dialect

MOST = 150  # instants of a program that are looked at
ASKED = (
    *("RANDOM()", "RANDOM()-2*RANDOM()", "DX(DEST)", "DY(DEST)", "DEXT(#DEST,3)", "SPEED(1)"),
    *("SPEED(2)", "SPEED(3)", "ADC(1)", "ADC(2)", "PRIORITY", "STATE(1)", "STATE(2)"),
    *('STATUS("main")', 'STATUS("sub")', 'STATUS("watch")', 'STATUS("no")', "ERROR()", "FREE(0)"),
    *("TIMER(1)", "TIMER(2)", "TIMER(ABS(-1))", "PARAMETER(HAND.TIME)"),
    *("INRANGE(DEST)", "INRANGE(SHIFT(DEST BY 500,0,0))"),
)


@cache
def evaluates(text: str, dialect: Dialect) -> Evaluate | None:
    """Return the engine's own closure for a text without variables; None: it means nothing."""
    try:
        _, module = read(text, {}, {}, dialect)
    except CannotTell:
        return None
    (program,) = module.programs.values()
    step = program.instructions[0]
    assert isinstance(step, Assign)
    layout = Layout()
    evaluate = compiler(layout).value(step.value)
    return None if layout.names else evaluate  # to some dialects a word is a variable


def told_by_machine(
    run: Run, texts: list[str], dialect: Dialect, instants: list[Instant], *, process: bool
) -> dict[tuple[str, int], Value | str]:
    """Return what a machine that goes through the run tells, by text and which instant."""
    found: dict[tuple[str, int], Value | str] = {}

    def see(k: int, machine: Machine) -> None:
        present = Present(machine, instants[k], Memory([]), process=process)
        for text in texts:
            present.system.random_state = machine.system.random_state
            evaluate = evaluates(text, dialect)
            assert evaluate is not None
            try:
                found[text, k] = evaluate(as_context(present))
            except RuntimeFault as fault:
                found[text, k] = fault.headline

    Walk(run).over(instants, see, nobody)
    return found


def told_alone(
    known: Expressions, text: str, at: Instant, *, process: bool
) -> tuple[Value | str, int]:
    expression = known.of(text)
    try:
        return expression.value(at, None, nobody, process=process), expression.forks
    except CannotTell as problem:
        return str(problem), expression.forks


@pytest.mark.parametrize("number", first(3, (0, 4, 13, *range(20, 60))))
def test_what_was_noted_is_what_the_machine_tells_there(number: int) -> None:
    run, dialect = drawn_run(number), DIALECTS[drawn(number).dialect]
    texts = [text for text in ASKED if evaluates(text, dialect) is not None]
    known, chance = Expressions(run, dialect), random.Random(number)
    for process in (False, True):
        passages = Passages(run, process=process)
        which = range(passages.count)
        chosen = sorted(chance.sample(which, min(MOST, passages.count)))
        instants = sorted({passages.instant(k) for k in chosen})
        wanted = told_by_machine(run, texts, dialect, instants, process=process)
        assert len(wanted) >= 0.5 * len(texts) * len(instants)
        for text in texts:
            nobodys = [None] * len(instants)
            who = [process] * len(instants)
            reals, sure = known.of(text).reals(instants, nobodys, who, nobody)
            for k, at in enumerate(instants):
                if (text, k) not in wanted:
                    continue
                found, forks = told_alone(known, text, at, process=process)
                assert (found, forks) == (wanted[text, k], 0), (text, at, process)
                if sure[k]:
                    assert float(reals[k]) == wanted[text, k], (text, at, process)
            assert np.count_nonzero(sure) >= 0.5 * len(instants) or "INRANGE" in text, text
