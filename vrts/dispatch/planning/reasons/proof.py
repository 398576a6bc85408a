"""What speaks against the real robot in one run: the same as a grade's "ready" goes by."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, error
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import REVIEW
from vrts.check.mark.losses import mishaps_of, stopped_by
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.check.verdict import Answer
from vrts.dispatch.planning.reasons.refusals import NOT_PROVEN, UNDECIDED
from vrts.engine.run import Run


class Case(NamedTuple):
    """One run, judged."""

    title: str  # of its scenario
    run: Run
    judgement: Judgement
    task: Task | None


def obstacles(case: Case) -> tuple[str, ...]:
    """Return what speaks against the real robot, most serious first; nothing if it is ready."""
    if case.task is not None:
        return grade(case.task, case.run, case.judgement).obstacles
    run, judgement = case.run, case.judgement
    found = [mishap.loss.sentence for mishap in mishaps_of(run, judgement)]
    stopped = stopped_by(run)
    if stopped is not None:
        found.append(stopped.sentence)
    found += [d.headline for d in run.findings if d.is_error and stopped is None]
    for verdict in judgement.verdicts:
        if verdict.answer is Answer.UNDETERMINED:
            found.append(f"{REVIEW}: {verdict.check}: {verdict.summary}")
        elif verdict.answer is Answer.VIOLATED and (verdict.check == "limits" or not found):
            found.append(verdict.summary)
    report = judgement.collisions
    if report is None:
        found.append("collisions were not checked")
    else:
        found += [f"{REVIEW}: two engines disagree: {words}" for words in report.disagreements]
    return tuple(found)


def unproven(case: Case, *, named: bool) -> Iterator[Diagnostic]:
    """Yield a refusal for everything that speaks against the real robot.

    Args:
        case: The run.
        named: Whether the scenario is to be named, because there are several.
    """
    notes = (f"in the scenario {case.title}",) if named else ()
    for sentence in obstacles(case):
        doubt = sentence.startswith(REVIEW)
        yield error(
            UNDECIDED if doubt else NOT_PROVEN,
            sentence.removeprefix(f"{REVIEW}: "),
            notes=notes,
            help=(_LOOK if doubt else _REPAIR,),
        )


_REPAIR = "look at it with `vrts verify --html`, and repair the program"
_LOOK = "look at this place with `vrts verify --html`, and decide"
