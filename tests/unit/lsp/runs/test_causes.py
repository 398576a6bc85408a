"""Editors show what led to a finding beside it, as far as the task lets students read it."""

from dataclasses import replace

import pytest

from tests.unit.report.test_because import lost
from vrts.check.rules.hints import Hints
from vrts.lsp.channel.findings import Found
from vrts.lsp.runs.causes import Causes, causes_of, lost_of, with_causes


def labels(level: Hints) -> list[str]:
    a = lost()
    assert a.task is not None
    assert a.run is not None
    assert a.judgement is not None
    known = [Found(d) for verdict in a.judgement.verdicts for d in verdict.findings]
    found = with_causes(known, causes_of(a.run, a.judgement, replace(a.task, hints=level)))
    return [label.text for one in found for label in one.diagnostic.secondary]


@pytest.mark.parametrize("level", Hints)
def test_a_goal_that_is_missed_shows_its_causes_as_far_as_is_allowed(level: Hints) -> None:
    text = "\n".join(labels(level))
    assert ("`c2` is X 450 Y 750 Z -225" in text) is (level >= Hints.PLACE)
    assert ("too far in" in text) is (level >= Hints.DIRECTION)
    assert ("mm too far in" in text) is (level >= Hints.NUMBER)


@pytest.mark.parametrize("level", Hints)
def test_a_lens_tells_why_a_point_is_lost_as_far_as_is_allowed(level: Hints) -> None:
    a = lost()
    assert a.task is not None
    assert a.run is not None
    assert a.judgement is not None
    causes = causes_of(a.run, a.judgement, replace(a.task, hints=level))
    text = "\n".join(one.why for one in lost_of(causes, span_of(causes)))
    assert ("why -4.25: line 27 `c2 450 750" in text) is (level >= Hints.PLACE)
    assert causes.mendable is (level is Hints.EDIT)


def span_of(causes: Causes) -> str:
    return next((loss.span.source.name for loss, _ in causes.pairs if loss.span is not None), "")
