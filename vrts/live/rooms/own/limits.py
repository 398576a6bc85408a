"""How many robots of their own there may be, and when they fall asleep."""

from dataclasses import dataclass
from typing import Final

OPENED: Final = (1 / 10, 8.0)  # robots that an account opens: a second, and at once
WOKEN: Final = (1 / 10, 8.0)  # robots that an account wakes


@dataclass(frozen=True, slots=True)
class OwnLimits:
    """Of all robots of their own on a server."""

    each: int = 16  # that a person or a team has
    all: int = 2000
    awake: int = 40  # at once
    each_awake: int = 2  # of a person or a team at once
    empty_s: float = 300.0  # after which one sleeps where nobody is
    idle_s: float = 1800.0  # after which one sleeps where somebody is, but does nothing
    program_s: float = 1800.0  # that a program may run on longer than that
