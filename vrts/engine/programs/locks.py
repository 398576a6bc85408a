"""What a program may not set: a task keeps the robot as it is installed.

A step that sets such a thing has no effect but a finding, so that no program gains by it.
"""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context

LOCKED_SETTING = Rule("V438", "locked-setting")


class Wish(NamedTuple):
    """What a step asks for."""

    name: str  # of a parameter or switch, or ACCEL
    words: str  # "PARAMETER SPEED.MAX"
    keeps: str  # "it stays at 100"


def refused(c: Context, wish: Wish, cause: Cause) -> None:
    """Tell that a step has no effect; of the same thing only the first is told."""
    told = f"locked {wish.name}"
    if told in c.system.warned:
        return
    c.system.warned |= {told}
    c.report(
        Diagnostic(
            LOCKED_SETTING,
            Severity.ERROR,
            f"`{wish.words}` is not for programs of this task to set: {wish.keeps}",
            Label(cause.span, "without effect"),
            notes=("it belongs to the robot as it is installed, not to the program",),
            help=("leave this step out; SPEED says how fast the program moves",),
            data={"setting": wish.name},
        ),
        cause,
    )
