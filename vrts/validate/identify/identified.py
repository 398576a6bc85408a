"""What a log says of a robot: causes with their intervals, and what cannot be told."""

from dataclasses import dataclass
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.robots.model import Arm
from vrts.validate.identify.causes import Cause


class Number(NamedTuple):
    """A number that is off."""

    cause: Cause
    value: float  # in s, rad, m; of speeds and of a rate a share
    low: float  # of an interval of 95 %
    high: float
    alike: tuple[tuple[Cause, ...], ...]  # that explain the log as well

    @property
    def half(self) -> float:
        """Half the interval."""
        return 0.5 * (self.high - self.low)


class Remaining(NamedTuple):
    """What is left of one channel of the log."""

    name: str  # "JT1", "X"
    before: float  # RMS with the clock alone [rad, m]
    after: float  # RMS with all causes
    patterned: float  # RMS of the part that lasts for several rows
    rounding: float  # what a step of the channel makes

    @property
    def joint(self) -> bool:
        """Whether it is a joint's."""
        return self.name.startswith("JT")


@dataclass(frozen=True, slots=True)
class Identified:
    """The answer."""

    arm: Arm  # as assumed before
    numbers: tuple[Number, ...]  # the one that explains most first
    clock_s: float  # added to times of the log, at its start
    clock_half_s: float
    own_rests: bool  # the robot rests otherwise than the run: each stretch has its own clock
    remaining: tuple[Remaining, ...]
    fits: bool  # what is left has no pattern
    silent: tuple[Cause, ...]  # of which the log says nothing
    pairs: tuple[tuple[Cause, Cause], ...]  # that cannot be told apart in this log
    rows: int
    log: str
    sha256: str
    synthetic: bool
    findings: tuple[Diagnostic, ...]
    controller: str
