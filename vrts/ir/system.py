"""System switches and parameters: names and what they are at the start.

See [manual language/settings#switches, language/settings#parameters].
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from vrts.ir.taken import TAKEN


class SystemSwitch(NamedTuple):
    """A switch of the controller."""

    name: str  # upper case
    on: bool  # at the start
    about: str
    read_only: bool = False


class Parameter(NamedTuple):
    """A number of the controller that programs may read and set."""

    name: str  # upper case
    value: float | None  # at the start; None: the robot's data decide
    unit: str
    about: str
    numbers: int = 1  # how many; above 1 they have an index

    @property
    def cells(self) -> tuple[str, ...]:
        """The names of its numbers."""
        if self.numbers == 1:
            return (self.name,)
        return tuple(f"{self.name}[{number}]" for number in range(1, self.numbers + 1))


def _by_name(*items: SystemSwitch) -> Mapping[str, SystemSwitch]:
    return MappingProxyType({item.name: item for item in items})


SWITCHES = _by_name(
    SystemSwitch("CP", True, "continuous path: motions are blended"),
    SystemSwitch("POWER", True, "arm power"),
    SystemSwitch("MESSAGES", True, "TYPE writes to the terminal"),
    SystemSwitch("TRACE", False, "each step is listed as it is executed"),
    SystemSwitch("DRY.RUN", False, "programs run, the arm stands still (V+)"),
    SystemSwitch("UPPER", False, "comparisons of strings ignore case (V+)"),
    SystemSwitch("ROBOT", True, TAKEN),
    SystemSwitch("FORCE", False, TAKEN),
    SystemSwitch("SUPERVISOR", False, TAKEN),
    SystemSwitch("EXTERN.ALTER", False, TAKEN),
    SystemSwitch("INTERACTIVE", True, TAKEN),
    SystemSwitch("MCP.MESSAGES", False, TAKEN),
    SystemSwitch("TERMINAL", True, TAKEN),
)

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {
        item.name: item
        for item in (
            Parameter("HAND.TIME", None, "s", "wait after OPENI, CLOSEI, RELAXI and GRASP"),
            Parameter("HAND.MAX", None, "mm", "opening of the hand when fully open"),
            Parameter("SPEED.MAX", None, "%", "upper limit of the speed"),
            Parameter("VEL.LIN", None, "mm/s", "full speed of straight lines"),
            Parameter("TACC", None, "s", "time of an acceleration"),
            Parameter("NEST.POS", None, "deg", "joints of NEST and REST, indices 1 to 6", 6),
            Parameter("TERMINAL", 0.0, "", TAKEN),
            Parameter("KERMIT.RETRY", 15.0, "", TAKEN),
            Parameter("KERMIT.TIMEOUT", 8.0, "s", TAKEN),
        )
    }
)
