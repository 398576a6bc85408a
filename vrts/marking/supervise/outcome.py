"""How a supervised process ended."""

from enum import Enum
from typing import NamedTuple


class Loss(Enum):
    """Why a process gave no answer."""

    TIME = "used too much processor time"
    WALL = "did not end in time"
    MEMORY = "used too much memory"
    CRASH = "crashed"
    ANSWER = "gave no readable answer"


class Answer(NamedTuple):
    """It did what it was told."""

    data: bytes


class Lost(NamedTuple):
    """It did not."""

    loss: Loss
    detail: str  # its last words, for whoever mends vrts


Outcome = Answer | Lost
