"""The verdict on every future of a program: found by those who prove, and handed to the judge."""

from collections.abc import Sequence

from vrts.check.rules.proof_demand import EVERY_FUTURE
from vrts.check.task.demands import DEMAND
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, Verdict

CHECK = DEMAND + EVERY_FUTURE
NOT_LOOKED_AT = "the futures of the program were not looked at"


def verdicts(task: Task, given: Sequence[Verdict]) -> tuple[Verdict, ...]:
    """Return what is known of every future, where a task asks for it.

    Args:
        task: What is asked for.
        given: By those who proved; nothing: nobody did, so nobody can tell.
    """
    if task.proof is None:
        return ()
    found = tuple(verdict for verdict in given if verdict.check == CHECK)
    return found or (Verdict(CHECK, Answer.UNDETERMINED, NOT_LOOKED_AT),)
