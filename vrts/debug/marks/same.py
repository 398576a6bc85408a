"""Whether a run is at an instant what it was when somebody looked: a sign of all its state."""

from hashlib import sha256

from vrts.debug.passages import Instant, statements_at
from vrts.engine.run import Run

_LONG = 16  # characters of a sign


def comes_to(run: Run, instant: Instant) -> bool:
    """Return whether so many statements are finished at some moment of the tick of an instant."""
    if not 0.0 <= instant.time_s <= run.horizon_s:
        return False
    least, most = statements_at(run, instant.time_s)
    return least <= instant.finished <= most


def sign_of(run: Run, instant: Instant) -> str:
    """Return what tells the state at an instant from others: arm, programs, values, signals."""
    state = run.at_moment(instant.time_s, instant.finished)
    stacks = [
        [(cause.program, cause.step, cause.span.text.split()) for cause in stack]
        for stack in (state.call_stack, state.process_stack)
    ]
    values = [
        sorted((name, repr(v)) for name, v in of.items()) for of in (state.variables, state.locals)
    ]
    things = sorted((name, repr(pose)) for name, pose in state.poses.items())
    whole = (
        *(repr(state.time_s), instant.finished, repr(state.configuration), state.hand_opening),
        *(stacks, values, things, sorted(state.signals), state.held, state.output),
    )
    return sha256(repr(whole).encode("utf-8", "replace")).hexdigest()[:_LONG]
