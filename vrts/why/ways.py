"""Motions as causes: where one leads and why there, and by which settings."""

import math
from collections.abc import Iterator
from typing import cast

from vrts.base.pose import IDENTITY, Pose
from vrts.engine.memory.events import HandCommanded
from vrts.ir.expressions import Apply, Compose, Constant, Function, Place
from vrts.ir.motion import (
    Depart,
    Draw,
    Drive,
    Move,
    SetBase,
    SetBaseFrame,
    SetSpeed,
    SetTool,
)
from vrts.why.chain import Link
from vrts.why.shown import point, value
from vrts.why.slicing.entered import reacted
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.given import is_given
from vrts.why.slicing.read import Reading, element, places_in, readings
from vrts.why.slicing.sources import chain_of, chosen, element_text, telling, written

AXES = (("+X", "-X"), ("+Y", "-Y"), ("too low", "too high", "+Z", "-Z"))  # of what a link says
_NUMBERS_FROM = {Function.TRANS: 0, Function.TRANS_ZYZ: 0, Function.SHIFT: 1}  # X, then Y and Z
FAR_ROUND = 30.0  # [deg] of a way: where the tool turns so far, both ends matter [assumed]
SAME = 1e-6  # of poses that are told apart


def leads(steps: Steps, motion: int) -> Link:
    """Return that a motion leads to a place."""
    one = steps.run.motions[motion]
    verb = "goes to" if one.arrives and not one.blended else "sets out for"
    says = f"the tool {verb} {point(one.X_WT.translation)}{_chosen(steps, motion)}"
    return Link(one.start_s, one.cause.span, says)


def _chosen(steps: Steps, motion: int) -> str:
    """Return which elements a motion took, where their subscripts are computed."""
    step = steps.of_motion(motion)
    found: dict[str, str] = {}
    for each in () if step is None else readings(steps, step):
        if any(places_in(each.place.subscripts)) and each.known:
            real = element(steps, each.place, each.before, each.activation)
            found[element_text(each.place)] = real
    return "".join(f", where `{text}` is `{real}`" for text, real in found.items())


def decided(steps: Steps, motion: int, toward: str = "") -> Iterator[Link]:
    """Yield why a motion leads where it does: settings, values, numbers of the source.

    Args:
        steps: Of the run.
        motion: Its number.
        toward: In which direction its end is wrong, as a link says it: "too low for `can1`".
    """
    step = steps.of_motion(motion)
    if step is None:
        return
    settings = list(_settings(steps, step))
    yield from settings
    instruction = step.instruction
    if isinstance(instruction, Depart | Draw) and _written_out(instruction):
        return  # the line of the motion says it itself
    found = doubtful(steps, step)
    along = _along(instruction, toward)
    if along:  # of the numbers that make a location, those in the direction that is wrong
        found = [r for r in found if isinstance(r.value, Pose) or r.place in along] or found
    compound = isinstance(instruction, Move) and isinstance(instruction.target, Compose)
    beside = [] if compound else _numbers_beside(found)
    if beside:  # what was given a value last is told last
        most, *others = telling(steps, [found[0], *beside])
        for each in others[:1]:
            yield from (link._replace(minor=True) for link in chain_of(steps, each))
        yield from chain_of(steps, most)
    else:
        for each in reversed(found) if compound else found[:1]:  # what is nearest the tool first
            yield from chain_of(steps, each)
    if not found and not settings:
        for each in readings(steps, step)[:1]:
            yield from chosen(steps, each)
    yield from reacted(steps, step)


def way_begins(steps: Steps, motion: int, turn: float = 0.0) -> Iterator[Link]:
    """Yield where a way begins, and why there: of ways that turn the tool far both ends matter.

    Args:
        steps: Of the run.
        motion: Its number; it need not have begun.
        turn: By how much the tool turns on it [deg]; 0: that is told already.
    """
    if motion == 0:
        return
    before = steps.run.motions[motion - 1]
    says = f"the way begins at {value(before.X_WT)}, where this step leads"
    says += f": the tool is to turn by {turn:.0f} degrees on it" if turn else ""
    yield Link(before.start_s, before.cause.span, says)
    yield from decided(steps, motion - 1)


def _along(node: object, toward: str) -> set[Place]:
    """Return what the numbers of a location were read from that lie in a direction."""
    axes = [axis for axis, words in enumerate(AXES) if any(word in toward for word in words)]
    if len(axes) != 1 or not isinstance(node, tuple):
        return set()
    if isinstance(node, Apply) and node.function in _NUMBERS_FROM:
        first = _NUMBERS_FROM[node.function]
        there = node.arguments[first + axes[0] : first + axes[0] + 1]
        return {*places_in(there), *_along(node.arguments[:first], toward)}
    parts = cast("tuple[object, ...]", node)
    return {place for part in parts for place in _along(part, toward)}


def _numbers_beside(found: list[Reading]) -> list[Reading]:
    """Return the numbers that lead away from a location: no subscripts of it."""
    if not found or not isinstance(found[0].value, Pose):
        return []
    chose = {place for r in found for each in r.place.subscripts for place in places_in(each)}
    return [r for r in found if not isinstance(r.value, Pose) and r.place not in chose]


def doubtful(steps: Steps, step: Executed) -> list[Reading]:
    """Return what a step read that may be wrong: not locations as the scene gives them."""
    found = [r for r in readings(steps, step) if r.known]
    return [r for r in found if not is_given(steps, r)]


def _written_out(instruction: Depart | Draw) -> bool:
    parts = (instruction.distance,) if isinstance(instruction, Depart) else instruction.offsets
    return all(part is None or isinstance(part, Constant) for part in parts)


def _settings(steps: Steps, step: Executed) -> Iterator[Link]:
    """Yield TOOL, BASE and the like where they are not what they were at the start."""
    memory = steps.history.memory
    at_first = steps.run.scene.X_FT, IDENTITY
    for name, cell, usual in zip(
        ("tool", "base"), (memory.tool, memory.base), at_first, strict=True
    ):
        source = written(steps, cell, step.number - 1)
        if source is None or source.step is None:
            continue
        if isinstance(source.step.instruction, SetTool | SetBase | SetBaseFrame):
            now = cell.at(step.number - 1)
            if isinstance(now, Pose) and not _alike(now, usual):
                says = f"the {name} set here is in force"
                yield Link(source.time_s, source.step.cause.span, says)


def _alike(one: Pose, other: Pose) -> bool:
    numbers = zip(
        (*one.rotation, *one.translation), (*other.rotation, *other.translation), strict=True
    )
    return all(math.isclose(a, b, abs_tol=SAME) for a, b in numbers)


def speed_of(steps: Steps, motion: int) -> Link | None:
    """Return the SPEED by which a motion went."""
    step = steps.of_motion(motion)
    if step is None:
        return None
    nearest: Executed | None = None
    for number in range(step.number - 1, 0, -1):
        found = steps.step(number)
        if found is None or not isinstance(found.instruction, SetSpeed):
            continue
        always = found.instruction.scope.value == "always"
        if always or not _moved_between(steps, number, step.number):
            nearest = found
            break
    if nearest is None:
        return None
    says = f"this speed is in force: {steps.run.motions[motion].speed_fraction * 100:g} %"
    return Link(steps.time_of(nearest), nearest.cause.span, says)


def _moved_between(steps: Steps, first: int, last: int) -> bool:
    """Return whether a motion was asked for between two statements."""
    for number in range(first + 1, last):
        found = steps.step(number)
        if found is not None and isinstance(found.instruction, Move | Depart | Drive | Draw):
            return True
    return False


def hand_told(steps: Steps, time_s: float, action: str) -> Link | None:
    """Return the step that told the hand to do something, the last before a time."""
    last = [
        e
        for e in steps.run.events
        if isinstance(e, HandCommanded) and e.action == action and e.time_s <= time_s + 1e-9
    ]
    if not last or last[-1].cause is None:
        return None
    return Link(last[-1].time_s, last[-1].cause.span, f"the hand is told to {action} here")
