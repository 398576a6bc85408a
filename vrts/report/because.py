"""Chains of causes beside what they explain, and how much of them a reader may be told."""

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.why.asking import why_at, why_of
from vrts.why.chain import Chain
from vrts.why.losses import chains


def because(a: Assessment) -> tuple[Chain, ...]:
    """Return a chain for each loss, in their order; without a task for all that went wrong."""
    if a.run is None or a.judgement is None:
        return ()
    return chains(a.run, a.judgement, a.task, a.grade)


def asked(a: Assessment, name: str | None, time_s: float | None) -> Chain | None:
    """Return why a thing or a variable is as it is, or what the arm does, at a time.

    Raises:
        Unknown: Nothing has this name.
    """
    if a.run is None:
        return None
    if name is not None:
        return why_of(a.run, name, time_s)
    return None if time_s is None else why_at(a.run, time_s)


def told_to(a: Assessment, audience: Audience) -> Hints:
    """Return how much may be told: to students what the task allows, to those who mark all."""
    if audience is Audience.GRADER or a.task is None:
        return Hints.EDIT
    return a.task.hints
