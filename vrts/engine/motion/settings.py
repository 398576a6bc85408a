"""Settings of motions: what holds always, and what holds for the next motion only."""

import math
from typing import NamedTuple

from vrts.base.units import INCH, MM
from vrts.controllers.model import Stops
from vrts.ir.instructions import Accuracy, SpeedUnit
from vrts.robots.model import Arm


class Speed(NamedTuple):
    """A program speed."""

    value: float
    unit: SpeedUnit

    def fraction(self, arm: Arm, most: float) -> float:
        """Return the share of full speed, at most that of a largest percentage."""
        match self.unit:
            case SpeedUnit.PERCENT:
                percent = self.value
            case SpeedUnit.MM_PER_S:
                percent = 100.0 * self.value * MM / arm.linear_speed
            case SpeedUnit.INCH_PER_S:
                percent = 100.0 * self.value * INCH / arm.linear_speed
        return min(percent, most) / 100.0


FULL_SPEED = Speed(100.0, SpeedUnit.PERCENT)


class Settings(NamedTuple):
    """Everything a motion is carried out with. The defaults hold when a cycle begins."""

    speed: Speed = FULL_SPEED
    rotation: float | None = None  # [%] of the turning speed; None: as `speed`
    acceleration: float = 100.0  # [%]
    deceleration: float = 100.0  # [%]
    duration: float = 0.0  # [s] at least
    accuracy: Accuracy = Accuracy.FINE
    accuracy_percent: float = 100.0  # of the tolerance (V+); kept
    nulling: bool = True
    integration: bool = False  # without effect on an ideal servo
    multiple: bool = True  # joints 4 and 6 may go beyond half a turn

    def acceleration_times(self, arm: Arm) -> tuple[float, float]:
        """Return the times to reach full speed and to stop from it [s], even numbers of ticks."""
        return (
            _even(arm.acceleration_time * 100.0 / self.acceleration, arm.tick),
            _even(arm.acceleration_time * 100.0 / self.deceleration, arm.tick),
        )

    def settling_ticks(self, stops: Stops) -> int:
        """Return the ticks until a stop counts as reached [manual language/settings#settling]."""
        if not self.nulling:
            return 0
        return stops.fine_ticks if self.accuracy is Accuracy.FINE else stops.coarse_ticks


class InForce:
    """The settings that hold while a program is executed."""

    def __init__(self) -> None:
        """Start with those of a fresh execution cycle."""
        self.always = Settings()
        self.next: dict[str, object] = {}  # of the next motion only

    def copy(self) -> "InForce":
        """Return independent settings that are the same so far."""
        other = InForce.__new__(InForce)
        other.always, other.next = self.always, self.next.copy()
        return other

    @property
    def speeds(self) -> tuple[float, float]:
        """What SPEED tells of all motions, and of the next one, in the units they were given."""
        always = self.always.speed
        following = self.next.get("speed", always)
        return always.value, following.value  # type: ignore[attr-defined]

    def take(self, *, but_speed: bool = False) -> Settings:
        """Return the settings of the motion now given; those for one motion are used up."""
        if not self.next:
            return self.always
        kept: dict[str, object] = {}
        if but_speed and "speed" in self.next:
            kept = {"speed": self.next.pop("speed")}
        settings = self.always._replace(**self.next)  # type: ignore[arg-type]
        self.next = kept
        return settings


def _even(time_s: float, tick: float) -> float:
    return 2.0 * tick * max(math.ceil(0.5 * time_s / tick - 1e-9), 1)
