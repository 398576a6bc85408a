"""Where bodies are while a stretch of motion lasts, and by which rules they may be touched.

A situation is made of parts, each certified by itself: what is the same in two situations is
looked at once.
"""

from collections.abc import Mapping
from enum import Enum
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.engine.memory.records import Lie

DIGITS = 9  # [m] places that differ by less are the same


class Lying(NamedTuple):
    """A body as a stretch of motion meets it."""

    body: str
    lie: Lie  # resting, held or falling
    X: Pose
    before: str | None = None  # of what is held: what it stood on before
    after: str | None = None  # what it will stand on, where that is known
    falls_from_s: float = 0.0  # when its fall begins, in `s` of the stretch

    @property
    def still(self) -> bool:
        """Whether it does not move."""
        return self.lie is Lie.RESTING

    def against(self, other: str | None) -> "Lying":
        """Return it without what does not matter to a body."""
        before = self.before if self.before == other else None
        after = self.after if self.after == other else None
        return self._replace(before=before, after=after)


class What(Enum):
    """What is certified at once."""

    ITSELF = "arm against itself and fixed bodies"
    TOUCHED = "arm against a body"
    IN_HAND = "fingers against a body in the hand"
    FIXED = "body that moves against fixed bodies"
    MEETING = "body that moves against another"


class Part(NamedTuple):
    """What is certified at once."""

    what: What
    body: Lying | None = None
    other: Lying | None = None
    pads: tuple[bool, ...] = ()  # which fingers may press into the body
    closing: bool = False  # and which may, if the hand that closes will grasp it: all

    @property
    def falls(self) -> bool:
        """Whether something in it falls."""
        return any(one is not None and one.lie is Lie.FALLING for one in (self.body, self.other))

    @property
    def hopes(self) -> bool:
        """Whether what touches may be excused by what happens later."""
        carried = self.body is not None and self.body.lie is Lie.HELD
        return self.closing or (carried and self.what in (What.FIXED, What.MEETING))


def parts_of(
    lying: tuple[Lying, ...],
    pads: Mapping[str, tuple[bool, ...]],
    *,
    fixed: frozenset[str],
    fingers: int,
    closing: bool,
) -> tuple[Part, ...]:
    """Return what has to be certified.

    Args:
        lying: Every movable body.
        pads: Which fingers may press into a body; into others none may.
        fixed: Names of the bodies that are not movable.
        fingers: How many there are.
        closing: Whether the hand closes, and may grasp something.
    """
    found = [Part(What.ITSELF)]
    for one in lying:
        allowed = pads.get(one.body, (False,) * fingers)
        hopes = closing and one.still and not all(allowed)
        if one.lie is Lie.HELD:
            found.append(Part(What.TOUCHED, one.against(None)))
            found.append(Part(What.IN_HAND, one.against(None), None, allowed))
        else:
            found.append(Part(What.TOUCHED, one.against(None), None, allowed, hopes))
    for one in lying:
        if one.still:
            continue
        supports = [name for name in (one.before, one.after) if name in fixed]
        before = one.before if one.before in supports else None
        after = one.after if one.after in supports else None
        found.append(Part(What.FIXED, one._replace(before=before, after=after)))
        for other in lying:
            meets = other.still or (one.lie is Lie.FALLING and other.lie is Lie.HELD)
            if other is not one and meets:
                found.append(Part(What.MEETING, one.against(other.body), other.against(None)))
    return tuple(found)
