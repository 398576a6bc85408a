"""How long the program took, from EXECUTE to its end, at monitor speed 100."""

from fractions import Fraction

from vrts.base.beside import beside
from vrts.check.goals.too_fast import overruns
from vrts.check.rounding import exact_s
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, Verdict
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run


def duration(run: Run) -> Fraction | None:
    """Return the duration [s], to 1 ms; None when the program never came to an end.

    A motion that is too fast for a joint counts as long as it would take at the joint's limit, so
    that nobody gains time by it.
    """
    if run.ended_s is None or run.ending is Ending.RUNNING:
        return None
    longer = sum(more for end_s, more in overruns(run) if end_s <= run.ended_s)
    return exact_s(run.ended_s - run.started_s + longer)


def verdict(run: Run, task: Task) -> Verdict:
    """Return whether the program ends within the longest time of the task."""
    took, longest = duration(run), exact_s(task.t_max)
    if took is None or took > longest:
        words = f"does not end; the longest time is {float(longest):.1f} s"
        if took is not None:
            shown, limit = beside(took, longest, most=3)
            words = f"takes {shown} s; the longest time is {limit} s"
        return Verdict("duration", Answer.VIOLATED, f"the program {words}")
    shown, limit = beside(took, longest, most=3)
    return Verdict(
        "duration",
        Answer.HOLDS,
        f"the program takes {shown} s of at most {limit} s",
        evidence={"duration_s": float(took)},
    )
