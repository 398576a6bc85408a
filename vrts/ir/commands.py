"""Commands that drive a controller. Live, monitor and offline runs use the same ones."""

from typing import NamedTuple, TypeAlias


class Execute(NamedTuple):
    """Run a program as the robot program."""

    program: str
    cycles: int = 1  # negative is endless
    step: int = 1


class SetMonitorSpeed(NamedTuple):
    """Set the monitor speed: time is stretched, the path stays."""

    percent: float


class Panic(NamedTuple):
    """Stop the program and decelerate the arm along its path."""


Command: TypeAlias = Execute | SetMonitorSpeed | Panic


class TimedCommand(NamedTuple):
    """A command and the simulated time [s] at which it is issued."""

    time_s: float
    command: Command
