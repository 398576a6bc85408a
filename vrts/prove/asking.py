"""How far to look, and who is told: what `prove` is asked besides program, scene, environment."""

from collections.abc import Callable
from typing import NamedTuple

USUAL_STATES = 200_000  # a budget that does not depend on how fast a machine is


class Told(NamedTuple):
    """How far a search has come."""

    states: int
    open: int  # futures that wait to be looked at
    found: int  # things that go wrong


def _nobody(_: Told) -> None:
    """Tell nobody."""


class Asking(NamedTuple):
    """What a search is asked: `prove(module, scene, environment, asking, *, entry, task)`."""

    states: int = USUAL_STATES  # most states; more than these are open
    collisions: bool = True
    told: Callable[[Told], None] = _nobody  # now and then
    enough: Callable[[], bool] = bool  # asked now and then; true: tell what is known so far
