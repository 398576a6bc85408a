"""A program in one scenario on its way to a controller."""

from typing import NamedTuple

from vrts.dispatch.manifest import Margin
from vrts.dispatch.planning.beside.worlds import World
from vrts.dispatch.planning.reasons.nearness import Nearness
from vrts.dispatch.planning.reasons.proof import Case


class Scened(NamedTuple):
    """One scenario, and the runs in it."""

    world: World
    given: Case  # with the values of the file
    held: Case  # with the values as the controller will hold them
    near: Nearness
    margins: tuple[Margin, ...]
    first_to_fail: str
    stops: tuple[Margin, ...]  # what may be typed after a stop
