"""Chains of causes beside what they explain, and how much of them a reader may be told."""

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.report.plain import one_line
from vrts.why.asking import why_at, why_of
from vrts.why.chain import Chain, line


def because(a: Assessment) -> tuple[Chain, ...]:
    """Return a chain for each loss, in their order; without a task for all that went wrong.

    Nothing where nobody asked for them: they were looked for when the run was judged.
    """
    return a.chains


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


ARROW = "←"


def chain_lines(chain: Chain, level: Hints) -> list[str]:
    """Return the links of a chain as lines, as far as they may be told."""
    if level is Hints.NOTHING:
        return []
    return [f"{ARROW} {one_line(line(link, level))}" for link in chain.links]


def told_to(a: Assessment, audience: Audience) -> Hints:
    """Return how much may be told: to students what the task allows, to those who mark all."""
    if audience is Audience.GRADER or a.task is None:
        return Hints.EDIT
    return a.task.hints
