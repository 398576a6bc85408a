"""A story as a scenario: replayed by the ordinary engine, it comes to the same."""

from collections.abc import Iterable
from dataclasses import replace

from vrts.prove.proof import Decided, What
from vrts.scene.model import Scenario

EARLIER = 0.5  # of a tick: inputs change so long before they are read


def scenario_of(base: Scenario, story: Iterable[Decided], tick_s: float) -> Scenario:
    """Return what a scenario says about a story.

    Args:
        base: What is the same in every future.
        story: What outside decided, in time order.
        tick_s: How often the controller looks [s].
    """
    decisions = tuple(story)
    inputs = [
        (max(decided.time_s - EARLIER * tick_s, 0.0), decided.number, decided.value)
        for decided in decisions
        if decided.what is What.INPUT and isinstance(decided.value, bool)
    ]
    answers = [
        decided.value
        for decided in decisions
        if decided.what is What.ANSWER and isinstance(decided.value, str)
    ]
    return replace(
        base,
        inputs=tuple(sorted((*base.inputs, *((round(t, 6), n, on) for t, n, on in inputs)))),
        answers=(*base.answers, *answers),
    )
