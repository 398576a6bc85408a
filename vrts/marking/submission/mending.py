"""What would mend a program that was marked: for those who mark, where they ask for it."""

from vrts.check.rules.hints import Hints
from vrts.marking.result import Mending
from vrts.marking.submission.one import Order
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.repair.ranking import standing_out
from vrts.repair.search import Budget
from vrts.repair.telling import away, cause, place


def would_do(order: Order, setting: Setting, executions: int) -> Mending | None:
    """Return what would earn a program the full mark, or more; None where nothing was found.

    What the task lets students know does not matter here: only those who mark read it.

    Args:
        order: The program.
        setting: Of the checks that students know.
        executions: Of changed programs, at most.
    """
    request = Request(ProgramFile(order.data, order.title), setting, identifier=order.identifier)
    found = mended(request, Budget(executions=executions), hints=Hints.EDIT)
    first = found.repairs[0] if found.repairs else found.better
    if first is None or found.assessment.source is None:
        return None
    best = standing_out(found.repairs) if found.repairs else first
    changes = first.change.each
    return Mending(
        " and ".join(cause(part, found.assessment.source) for part in changes),
        place(first.change) if best is None else away(best),
        tuple(part.line for part in changes),
        len(changes),
        found.executions,
        float(first.mark),
    )
