"""The numbers of a real robot as logs tell them."""

from dataclasses import dataclass
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.robots.model import Arm


class Estimate(NamedTuple):
    """A number, and the range that the motions allow: that of a controller that counts ticks."""

    value: float
    low: float
    high: float
    motions: int  # that tell it


class LogRead(NamedTuple):
    """A log that numbers are fitted from."""

    name: str
    sha256: str
    synthetic: bool


@dataclass(frozen=True, slots=True)
class FittedRobot:
    """What was fitted; None where no motion told it, so that the number stays *assumed*."""

    arm: Arm  # as assumed before
    speeds: tuple[Estimate | None, ...]  # of six joints at SPEED 100 [rad/s]
    linear_speed: Estimate | None  # of lines at SPEED 100 [m/s]
    acceleration_time: Estimate  # [s]
    blend_time: Estimate | None  # of a rounded corner [s]
    lag_s: float  # of the servos, first order
    residual: float  # RMS of what the fit leaves over [rad or m]
    motions: int  # that were fitted
    logs: tuple[LogRead, ...]
    findings: tuple[Diagnostic, ...]
    controller: str  # name of the model by which the program was run
