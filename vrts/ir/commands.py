"""Commands that drive a controller. Live, monitor and offline runs use the same ones."""

from typing import NamedTuple, TypeAlias


class Execute(NamedTuple):
    """Run a program as the robot program."""

    program: str
    cycles: int = 1  # negative is endless; 0 counts as 1
    step: int = 1


Command: TypeAlias = Execute


class TimedCommand(NamedTuple):
    """A command and the simulated time [s] at which it is issued."""

    time_s: float
    command: Command
