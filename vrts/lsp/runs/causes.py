"""What led to a finding, as places beside it: editors show them as related information."""

from collections.abc import Iterable
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Label
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Loss
from vrts.check.mark.mark import grade
from vrts.check.rules.hints import Hints
from vrts.check.task.task import Task
from vrts.engine.run import Run
from vrts.lsp.channel.findings import Found
from vrts.why.chain import Chain, words
from vrts.why.losses import chains


def with_causes(
    found: Iterable[Found], run: Run, judgement: Judgement, task: Task | None
) -> list[Found]:
    """Return findings with what led to those that cost points, as far as the task allows."""
    known = list(found)
    if task is None or task.hints is Hints.NOTHING:
        return known
    graded = grade(task, run, judgement)
    pairs = list(zip(graded.losses, chains(run, judgement, task, graded), strict=True))
    return [one._replace(diagnostic=_explained(one.diagnostic, pairs, task.hints)) for one in known]


def _explained(diagnostic: Diagnostic, pairs: list[tuple[Loss, Chain]], level: Hints) -> Diagnostic:
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
