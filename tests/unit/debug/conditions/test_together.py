"""Many instants asked together give what each gives alone, and fail where it fails alone."""

import random
from collections.abc import Sequence

import numpy as np
import pytest

from tests.laws import first
from tests.unit.debug.conditions.test_expression import expression, there
from vrts.debug.breakpoints import Breakpoint, Watch
from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import Interrupted, nobody
from vrts.debug.debugger import Debugger, Why, Wishes
from vrts.debug.evaluating import CannotTell
from vrts.debug.messages import Message
from vrts.debug.passages import Instant
from vrts.engine.memory.trace import Activation

CERTAIN = (
    "HAND+TIMER(1)+DISTANCE(HERE, NULL)",
    "TIMER(2)/n > 3 AND DX(HERE:far)-g[n] < 700",
    "DZ(INVERSE(HERE)) <> INT(m) OR SIG(5,-2001)",
    "SQRT(z)+MAX(n, m, 2)+ROUND(n/3)",
    "DY(SHIFT(far BY n, 0, 0)) == SIGN(-n)",
)


def passed(
    d: Debugger, *, process: bool
) -> tuple[list[Instant], list[Activation | None], list[bool]]:
    passages = d.passages(process=process)
    trace = (d.run.history.process if process else d.run.history.robot).trace
    instants = [passages.instant(k) for k in range(passages.count)]
    return instants, [trace.activation(at.finished) for at in instants], [process] * len(instants)


def alone(d: Debugger, text: str, places: Sequence[tuple[Instant, Activation | None]]) -> list[str]:
    known = Expressions(d.run, d.dialect).of(text)
    found: list[str] = []
    for at, activation in places:
        try:
            found.append(repr(known.value(at, activation, nobody)))
        except CannotTell as problem:
            found.append(str(problem))
    return found


@pytest.mark.parametrize("seed", first(1, range(8)))
def test_many_instants_together_give_what_each_gives_alone(seed: int) -> None:
    d, chance = there(), random.Random(seed)
    asked = compared = 0
    for number in range(24):
        text = CERTAIN[number] if number < len(CERTAIN) else expression(chance, 2)
        process = chance.random() < 0.2
        instants, activations, processes = passed(d, process=process)
        together = Expressions(d.run, d.dialect).of(text)
        reals, sure = together.reals(instants, activations, processes, nobody)
        if number < len(CERTAIN) and not process:
            assert sure.sum() > 20, text
        lanes = np.flatnonzero(sure).tolist()
        wanted = alone(d, text, [(instants[k], activations[k]) for k in lanes])
        assert [repr(v) for v in reals[lanes].tolist()] == wanted, text
        asked += len(instants)
        compared += len(lanes)
    assert compared > 0.35 * asked, "many of those that were drawn mean something"


def test_many_log_points_together_write_what_each_writes_alone() -> None:
    d = there()
    shared = Expressions(d.run, d.dialect)
    text = "n {n}, g {g[n]} {x/m}, at {DX(HERE)}: {$s} {nothing} {far} {RANDOM() < 2}."
    message = Message(text, shared)
    instants, activations, processes = passed(d, process=False)
    apart = Message(text, Expressions(d.run, d.dialect))
    wanted = [apart.filled(*place) for place in zip(instants, activations, strict=True)]
    assert message.filled_all(instants, activations, processes) == wanted
    assert len(set(wanted)) > 10
    assert Message("here", shared).filled_all(instants, activations, processes)[-1] == "here"


def test_who_waits_is_heard_before_places_and_changes_are_listed() -> None:
    def pause() -> None:
        raise Interrupted

    for wish in ({"lines": [Breakpoint(1, "main.v2", 7)]}, {"watches": [Watch(1, "n")]}):
        d = there()
        d.wishes = Wishes(**wish)  # type: ignore[arg-type]
        d.hear = pause
        begin = d.at
        with pytest.raises(Interrupted):
            d.go_on()
        assert d.at == begin
        d.hear = nobody
        assert d.go_on().why in (Why.BREAKPOINT, Why.CHANGE)
