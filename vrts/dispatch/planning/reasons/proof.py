"""What speaks against the real robot in one run: the same as a grade's "ready" goes by."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, error
from vrts.check.judgement import Judgement
from vrts.check.mark import ready
from vrts.check.mark.grade import REVIEW
from vrts.check.task.task import Task
from vrts.dispatch.planning.reasons.refusals import NOT_PROVEN, UNDECIDED
from vrts.engine.run import Run


class Case(NamedTuple):
    """One run, judged."""

    title: str  # of its scenario
    run: Run
    judgement: Judgement
    task: Task | None
    said: tuple[Diagnostic, ...] = ()  # by the compiler, of the program as it was given


def obstacles(case: Case, *, parts: bool = True) -> tuple[str, ...]:
    """Return what speaks against the real robot, most serious first; nothing if it is ready.

    Args:
        case: The run.
        parts: Whether there is anything to grip; without, a hand may close on nothing.
    """
    asked = None if case.task is None else ready.of_task(case.task, case.run)
    found = ready.obstacles(case.run, case.judgement, asked, case.said)
    return tuple(one.sentence for one in found if parts or one.kind is not ready.Kind.GRIP)


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
