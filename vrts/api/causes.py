"""Why points were lost: causes backward to the step that is to blame."""

from typing import NamedTuple

from vrts.api.assessments import ITS_OWN, Assessment
from vrts.api.errors import VrtsError, public, refusal, refuse
from vrts.api.given import File, Program, number, word
from vrts.api.scenes import Scene, Task
from vrts.api.verifying import verify
from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment as Inner
from vrts.report.audience import Audience
from vrts.report.because import asked, because, told_to
from vrts.report.screen.causes.why_text import why_text
from vrts.why.asking import Unknown
from vrts.why.chain import Chain as InnerChain
from vrts.why.chain import words


class Cause(NamedTuple):
    """One cause: what happened at a step, as far as the task lets it be told."""

    time_s: float | None  # None: before the run, as data
    line: int | None  # of the program
    words: str


class Chain(NamedTuple):
    """What went wrong, and why: what came last comes first."""

    effect: str  # one sentence
    causes: tuple[Cause, ...]


class Why(tuple[Chain, ...]):
    """Chains of causes, one for each loss. Made by `vrts.why`."""

    text: str

    def __new__(cls, chains: tuple[Chain, ...], text: str) -> "Why":
        """Keep the chains, and what `vrts why` prints."""
        found = super().__new__(cls, chains)
        found.text = text
        return found

    def __str__(self) -> str:
        """Return what `vrts why` prints."""
        return self.text


def chains_of(
    a: Inner, name: str | None, time_s: float | None
) -> tuple[tuple[InnerChain, ...], bool]:
    """Return the chains that are asked for, and whether they are those of all losses.

    Raises:
        VrtsError: The run does not last so long, or nothing has this name.
    """
    if a.run is not None and time_s is not None and not 0.0 <= time_s <= a.run.horizon_s:
        raise VrtsError(f"the run lasts from 0 to {a.run.horizon_s:.1f} s")
    try:
        one = asked(a, name, time_s) if name is not None or time_s is not None else None
    except Unknown as problem:
        raise VrtsError(str(problem)) from problem
    return (because(a), True) if one is None else ((one,), False)


@public
def why(
    program: Program | Assessment,
    *,
    of: str | None = None,
    at_s: float | None = None,
    scene: File | Scene | None = None,
    task: File | Task | None = None,
    scenario: File | None = None,
) -> Why:
    r"""Tell why points are lost, or why something is as it is.

    Args:
        program: What `vrts.verify` gave, or a program as for it.
        of: Why a thing is where it is, or a variable what it is.
        at_s: Why the arm does what it does at a time, in s; with `of`: at this time.
        scene: As for `vrts.verify`.
        task: As for `vrts.verify`.
        scenario: As for `vrts.verify`.

    Raises:
        VrtsError: Nothing has this name, the run does not last so long, or nothing ran that could
            be asked. An assessment has its own scene, task and scenario: give no others.

    >>> import vrts
    >>> task = vrts.task("01-cans-on-bases")
    >>> reasons = vrts.why(".PROGRAM lazy()\nDELAY 1\n.END\n", task=task)
    >>> reasons[0].causes[0].words
    'the hand is never told to close'
    """
    of = word(of, "of")
    at_s = None if at_s is None else number(at_s, "at_s")
    if isinstance(program, Assessment):
        refuse(ITS_OWN, scene=scene, task=task, scenario=scenario)
        found = program
    else:
        found = verify(program, scene=scene, task=task, scenario=scenario)
    inner = found.inner
    if inner.run is None and (of is not None or at_s is not None):
        raise refusal(found.simulated.diagnostics)
    chains, whole = chains_of(inner, of, at_s)
    level = told_to(inner, Audience.STUDENT)
    text = why_text(inner, chains, level, whole=whole, color=False)
    return Why(tuple(_chain(one, level) for one in chains), text)


def _chain(chain: InnerChain, level: Hints) -> Chain:
    links = chain.links if level is not Hints.NOTHING else ()
    return Chain(
        chain.effect,
        tuple(
            Cause(one.time_s, None if one.span is None else one.span.line, words(one, level))
            for one in links
        ),
    )
