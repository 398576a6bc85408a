"""Whether two runs are the same, and where they first differ.

Nothing is compared more finely than reports tell: 1 ms, 0.01 mm, 0.01 degrees; another processor
may round the last digit of a sine in another way.
"""

import math
from collections.abc import Iterator
from itertools import zip_longest

from vrts.base.diagnostic import Diagnostic, Label, error
from vrts.base.pose import Pose
from vrts.base.units import DEG, MM
from vrts.engine.memory.cells import Content
from vrts.engine.memory.events import Event, Found
from vrts.engine.motion.remarks import JOINT_SPEED
from vrts.engine.run import Run, State
from vrts.engine.storage.damage import DIFFERS
from vrts.ir.values import Value

SAME_TIME = 1e-3  # [s]
SAME_ANGLE = 0.01 * DEG
SAME_LENGTH = 0.01 * MM
SAME_REAL = 1e-6  # relative: a few units in the last place of single precision
SAMPLES = 200  # times at which the arm and the objects are compared


def difference(first: Run, second: Run) -> Diagnostic | None:
    """Return how the second run differs from the first, or None."""
    for time_s, what, label in _differences(first, second):
        return error(
            DIFFERS,
            f"executed again, the program does something else: {what} (at {time_s:.3f} s)",
            label,
            help=("save the run again; the file tells what an earlier vrts made of the program",),
            data={"time_s": round(time_s, 3)},
        )
    return None


def _differences(first: Run, second: Run) -> Iterator[tuple[float, str, Label | None]]:
    for before, after in zip_longest(_compared(first), _compared(second)):
        known = before or after
        assert known is not None
        if before is None or after is None or not _same_event(before, after):
            what = f"`{_kind(before)}` was saved, now it is `{_kind(after)}`"
            label = Label(known.cause.span) if known.cause else None
            yield known.time_s, what, label
    end = min(first.horizon_s, second.horizon_s)
    if abs(first.horizon_s - second.horizon_s) > SAME_TIME:
        yield end, "it lasts longer or shorter", None
    if first.statements != second.statements:
        what = f"{first.statements:,} statements were saved, now there are {second.statements:,}"
        yield end, what, None
    for k in range(SAMPLES + 1):
        time_s = min(end * k / SAMPLES, end)  # which rounding may miss by a last digit
        before, after = first.at(time_s), second.at(time_s)
        label = Label(before.span) if before.span else None
        for what in _state_differences(before, after):
            yield before.time_s, what, label


def _compared(run: Run) -> Iterator[Event]:
    """Return the events, without joint speeds that are foretold: motions are compared instead."""
    for event in run.events:
        if not (isinstance(event, Found) and event.diagnostic.rule == JOINT_SPEED):
            yield event


def _kind(event: Event | None) -> str:
    return "nothing" if event is None else type(event).__name__


def _same_event(before: Event, after: Event) -> bool:
    if type(before) is not type(after) or abs(before.time_s - after.time_s) > SAME_TIME:
        return False
    if isinstance(before, Found) and isinstance(after, Found):
        return before.diagnostic.rule == after.diagnostic.rule and before.cause == after.cause
    pairs = zip(before[1:], after[1:], strict=True)
    return all(_same(a, b) for a, b in pairs)


def _same(a: object, b: object) -> bool:
    if isinstance(a, Pose) and isinstance(b, Pose):
        return _same_pose(a, b)
    if isinstance(a, float) and isinstance(b, float):
        return math.isclose(a, b, rel_tol=SAME_REAL, abs_tol=SAME_LENGTH)
    return a == b


def _same_pose(a: Pose, b: Pose) -> bool:
    turned = max(abs(x - y) for x, y in zip(a.rotation, b.rotation, strict=True))
    return turned <= SAME_ANGLE and math.dist(a.translation, b.translation) <= SAME_LENGTH


def _state_differences(a: State, b: State) -> Iterator[str]:
    if any(abs(x - y) > SAME_ANGLE for x, y in zip(a.configuration, b.configuration, strict=True)):
        yield "the arm is elsewhere"
    if abs(a.hand_opening - b.hand_opening) > SAME_LENGTH:
        yield "the hand is open by another amount"
    for name, X in a.poses.items():
        if not _same_pose(X, b.poses[name]):
            yield f"`{name}` is elsewhere"
    if a.signals != b.signals:
        yield "other signals are on"
    if a.call_stack != b.call_stack:
        yield "the program is at another step"
    for name in sorted(a.variables.keys() | b.variables.keys()):
        before, after = a.variables.get(name), b.variables.get(name)
        if not _same_value(before, after):
            yield f"`{name}` has another value"


def _same_value(a: Value | Content | None, b: Value | Content | None) -> bool:
    if isinstance(a, tuple) and isinstance(b, tuple) and not isinstance(a, Pose):
        return all(_same(x, y) for x, y in zip(a, b, strict=True))
    return _same(a, b)
