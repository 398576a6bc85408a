"""What led to a finding, as places beside it: editors show them as related information."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Loss
from vrts.check.mark.mark import grade
from vrts.check.rules.hints import Hints
from vrts.check.task.task import Task
from vrts.engine.run import Run
from vrts.lsp.channel.findings import Found
from vrts.lsp.channel.verification import Lost
from vrts.why.chain import Chain, line, words
from vrts.why.losses import chains


class Causes(NamedTuple):
    """What a run loses points by, and how much may be told of it."""

    pairs: tuple[tuple[Loss, Chain], ...] = ()
    level: Hints = Hints.NOTHING
    mendable: bool = False  # points are lost, and the task lets the change be told that mends it


def causes_of(
    run: Run, judgement: Judgement, task: Task | None, said: Sequence[Diagnostic] = ()
) -> Causes:
    """Return what led to each lost point; nothing without a task, or where it allows no hints."""
    if task is None or task.hints is Hints.NOTHING:
        return Causes()
    graded = grade(task, run, judgement, said)
    pairs = tuple(zip(graded.losses, chains(run, judgement, task, graded), strict=True))
    edits = task.hints is Hints.EDIT and task.proof is None
    return Causes(pairs, task.hints, edits and graded.mark < graded.total)


def with_causes(found: Iterable[Found], causes: Causes) -> list[Found]:
    """Return findings with what led to those that cost points, as far as the task allows."""
    known, (pairs, level, _) = list(found), causes
    return [one._replace(diagnostic=_explained(one.diagnostic, pairs, level)) for one in known]


def lost_of(causes: Causes, path: str) -> tuple[Lost, ...]:
    """Return where points are lost in a text, with the step that is to blame for each."""
    found: dict[tuple[int, str], Lost] = {}
    for loss, chain in causes.pairs:
        blamed = chain.blamed
        if loss.span is None or loss.span.source.name != path or blamed is None:
            continue
        why = line(blamed._replace(time_s=None), causes.level)
        one = Lost(loss.span.start, loss.span.end, f"why -{float(loss.points):g}: {why}")
        found.setdefault((one.start, why), one)
    return tuple(found.values())


def _explained(
    diagnostic: Diagnostic, pairs: Sequence[tuple[Loss, Chain]], level: Hints
) -> Diagnostic:
    for loss, chain in pairs:
        if not _about(diagnostic, loss):
            continue
        labels = tuple(
            Label(link.span, words(link, level)) for link in chain.links if link.span is not None
        )
        return replace(diagnostic, secondary=(*diagnostic.secondary, *labels))
    return diagnostic


def _about(diagnostic: Diagnostic, loss: Loss) -> bool:
    """Return whether a finding tells of what a loss is for."""
    if diagnostic.moment is not None and diagnostic.moment == loss.moment:
        return True
    if loss.kind == "target" and diagnostic.primary is None and loss.moment is not None:
        return any(f"`{body}`" in diagnostic.headline for body in loss.moment.bodies)
    span = None if diagnostic.primary is None else diagnostic.primary.span
    return span is not None and span == loss.span and diagnostic.headline in loss.sentence
