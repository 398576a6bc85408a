"""The `Change?` dialogue: components of a location, shown and changed until an empty answer."""

import re
from typing import NamedTuple

from vrts.base.oat import rotation_from_oat
from vrts.base.pose import Pose
from vrts.base.units import DEG, MM
from vrts.ir.commands import SetVariable
from vrts.ir.values import Joints
from vrts.lang.dialect import Angles
from vrts.monitor import words
from vrts.monitor.desk import Desk, Refused, Situation, Turn
from vrts.monitor.listings import COMPONENTS, location_row, printed

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)(E[+-]?\d+)?", re.IGNORECASE)
_COUNT = 6
_LARGEST = 1e6  # mm or degrees: more is a slip of the finger [assumed]


class Change(NamedTuple):
    """Waits for new components of a location."""

    name: str
    indices: tuple[int, ...]
    value: Pose | Joints
    angles: Angles = Angles.OAT

    @property
    def prompt(self) -> str:
        """Return the question."""
        return "Change?\n"

    def enter(self, line: str, desk: Desk, now: Situation) -> Turn:
        """Take up to six numbers; an empty line ends the dialogue."""
        if not line.strip():
            return Turn()
        try:
            numbers = _numbers(line)
        except Refused as refused:
            return Turn(refused.text, mode=self)
        changed = self._replace(value=with_components(self.value, numbers, self.angles))
        return Turn(f"{location_row(changed.value, self.angles)}\n", (changed.command,), changed)

    def interrupt(self, desk: Desk, now: Situation) -> Turn:
        """End the dialogue; what has been shown holds."""
        return Turn()

    @property
    def command(self) -> SetVariable:
        """Return what gives the location its value."""
        return SetVariable(self.name, self.indices, self.value)


def show_and_ask(name: str, indices: tuple[int, ...], value: Pose | Joints, angles: Angles) -> Turn:
    """Return the turn that gives a location a value, shows it and asks for changes."""
    change = Change(name, indices, value, angles)
    return Turn(f"{COMPONENTS}\n{location_row(value, angles)}\n", (change.command,), change)


def with_components(
    value: Pose | Joints, numbers: tuple[float | None, ...], angles: Angles = Angles.OAT
) -> Pose | Joints:
    """Return a location with some components changed: mm and degrees; None leaves one."""
    if not isinstance(value, Pose):
        joints = [old if n is None else n * DEG for old, n in zip(value, numbers, strict=True)]
        return (joints[0], joints[1], joints[2], joints[3], joints[4], joints[5])
    x, y, z = (
        old if n is None else n * MM for old, n in zip(value.translation, numbers[:3], strict=True)
    )
    rotation = value.rotation
    if any(n is not None for n in numbers[3:]):
        present = printed(value, angles)[3:]
        o, a, t = (old if n is None else n for old, n in zip(present, numbers[3:], strict=True))
        if angles is Angles.ZYZ:
            o, a = o + 90.0, a - 90.0
        rotation = rotation_from_oat(o, a, t)
    return Pose(rotation, (x, y, z))


def _numbers(line: str) -> tuple[float | None, ...]:
    """Return six numbers, None where one is left out."""
    parts = [part.strip() for part in line.split(",")]
    while parts and not parts[-1]:
        parts.pop()
    if len(parts) > _COUNT:
        raise Refused(words.starred(words.UNEXPECTED_TEXT, "a location has six components"))
    bad = next((part for part in parts if part and not _NUMBER.fullmatch(part)), None)
    if bad is not None:
        raise Refused(words.starred(words.INVALID_NUMBER, f"`{bad[:40]}` is not a number"))
    numbers = [float(part) if part else None for part in parts]
    if any(n is not None and not abs(n) <= _LARGEST for n in numbers):
        raise Refused(words.starred(words.ILLEGAL_VALUE, "no component is as large as that"))
    return (*numbers, *[None] * (_COUNT - len(numbers)))
