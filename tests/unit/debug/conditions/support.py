"""What a condition has for a value, as the controller tells it and as histories do."""

from vrts.debug.conditions.expression import Expressions
from vrts.debug.conditions.hearing import nobody
from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell, evaluate
from vrts.debug.frames import seen_by
from vrts.debug.passages import Instant
from vrts.engine.memory.trace import Activation


def told_both(
    d: Debugger, known: Expressions, text: str, at: Instant, activation: Activation | None
) -> tuple[object, object]:
    """Return the value by the controller, and that by histories; or why there is none."""
    wanted: object
    found: object
    try:
        wanted = evaluate(d.run, at, text, d.dialect, seen_by(d.run, at, activation))
    except CannotTell as problem:
        wanted = str(problem)
    try:
        found = known.of(text).value(at, activation, nobody)
    except CannotTell as problem:
        found = str(problem)
    return wanted, found
