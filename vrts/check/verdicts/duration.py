"""How long the program took, from EXECUTE to its end, at monitor speed 100."""

from fractions import Fraction

from vrts.check.rounding import exact_s
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, Verdict
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run


def duration(run: Run) -> Fraction | None:
    """Return the duration [s], to 1 ms; None when the program never came to an end."""
    if run.ended_s is None or run.ending is Ending.RUNNING:
        return None
    return exact_s(run.ended_s - run.started_s)


def verdict(run: Run, task: Task) -> Verdict:
    """Return whether the program ends within the longest time of the task."""
    took = duration(run)
    longest = f"{task.t_max:.1f} s"
    if took is None or took > exact_s(task.t_max):
        words = "does not end" if took is None else f"takes {float(took):.1f} s"
        summary = f"the program {words}; the longest time is {longest}"
        return Verdict("duration", Answer.VIOLATED, summary)
    return Verdict(
        "duration",
        Answer.HOLDS,
        f"the program takes {float(took):.1f} s of at most {longest}",
        evidence={"duration_s": float(took)},
    )
