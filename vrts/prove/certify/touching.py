"""What was found: touches and joints beyond their limits, each in a future that comes there."""

from enum import Enum
from typing import NamedTuple


class Hope(Enum):
    """What later excuses a touch."""

    GRASPED = "grasped"  # by the closing under way: pads may press into what they will hold
    SET_DOWN = "set down"  # it comes to stand on what it touches, which is lowered for that


class Unless(NamedTuple):
    """What has to become of a touch, lest it is a contact."""

    hope: Hope
    body: str  # that will be grasped, or is held
    on: str | None = None  # what it has to be set down on


class Outcome(NamedTuple):
    """What became, in a tick, of a closing hand or of a body in it."""

    time_s: float
    hope: Hope
    body: str | None  # what was grasped, None: nothing; or what was let go
    on: str | None = None  # what it comes to stand on, None: nothing

    def settles(self, unless: Unless) -> bool | None:
        """Return whether a touch is excused by this; None: this does not decide about it.

        The first outcome after the touch that decides counts.
        """
        if self.hope is not unless.hope:
            return None
        if self.hope is Hope.GRASPED:
            return self.body == unless.body
        return self.on == unless.on if self.body == unless.body else None


class Touching(NamedTuple):
    """A contact, or what may be one."""

    future: int
    time_s: float  # within the contact
    first: str  # as reports of collisions have them: "robot", or a body that falls
    second: str
    parts: tuple[str, str]
    depth_m: float  # at that time; not known: NaN
    certain: bool = True  # not: within 0.01 mm of what is allowed, or given up
    unless: Unless | None = None


class Beyond(NamedTuple):
    """A joint that leaves its range, or is too fast."""

    future: int
    time_s: float
    joint: int  # from 0
    speed: bool  # the value is a speed
    value: float  # [rad], [rad/s]
    limit: float
