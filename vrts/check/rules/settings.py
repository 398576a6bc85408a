"""Which parameters and switches of the controller a program may set under a task.

Parameters that say what the robot is like where it stands are not for programs: SPEED.MAX = 400
would make a mark of a robot that nobody has. A task may allow more, or less.
"""

from collections.abc import Collection

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.scene.model import Locks

# of the robot as it is installed
INSTALLED = ("HAND.MAX", "SPEED.MAX", "VEL.LIN", "TACC", "NEST.POS")
FREE_PARAMETERS = tuple(name for name in PARAMETERS if name not in INSTALLED)
FREE_SWITCHES = tuple(SWITCHES)
FULL_ACCELERATION = 100.0  # [%]


def locks_of(parameters: Collection[str], switches: Collection[str], acceleration: float) -> Locks:
    """Return what is locked where a program may set these, and accelerate so much [%]."""
    names = [name for name in PARAMETERS if name not in parameters]
    names += [name for name in SWITCHES if name not in switches]
    return Locks(tuple(names), acceleration)


USUAL_LOCKS = locks_of(FREE_PARAMETERS, FREE_SWITCHES, FULL_ACCELERATION)
