"""Who may execute robot instructions, and when."""

from vrts.engine.code.closures import Step
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context
from vrts.ir.runtime_errors import RuntimeErrorKind


def for_robot(step: Step, cause: Cause) -> Step:
    """Return the step of a robot instruction."""
    refused = _refusal_of_process(cause)

    def guarded(c: Context) -> int:
        if not c.is_robot:
            return refused(c)
        if not c.system.powered:
            raise RuntimeFault(
                RuntimeErrorKind.ROBOT_POWER_OFF,
                "the arm has no power",
                cause.span,
                help=("`ENABLE POWER` turns it on again",),
            )
        return step(c)

    return guarded


def _refusal_of_process(cause: Cause) -> Step:
    """Return what a robot instruction does in a process control program."""

    def refuse(c: Context) -> int:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_IN_PROCESS,
            f"`{cause.span.text}` moves the robot; a process control program may not",
            cause.span,
            help=("set a signal here, and let the robot program wait for it",),
        )

    return refuse
