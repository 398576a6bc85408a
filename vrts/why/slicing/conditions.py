"""Conditions: what their variables were when they were asked for, and where that came from."""

from collections.abc import Iterator

from vrts.why.chain import Link
from vrts.why.shown import value
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.read import Reading, places_in, reading
from vrts.why.slicing.sources import chain_of, element_text, telling


def asked_for(steps: Steps, condition: object, step: Executed) -> list[Reading]:
    """Return the variables of a condition that had a value when a step asked for them."""
    places = {element_text(place): place for place in places_in(condition)}
    asked = [reading(steps, each, step.number - 1, step.activation) for each in places.values()]
    return [r for r in asked if r.known]


def with_values(steps: Steps, condition: object, step: Executed) -> str:
    """Return what the variables of a condition were: " with `i` at 1 and `n` at 3".

    Of one alone nothing: the next link tells it.
    """
    asked = asked_for(steps, condition, step)[:2]
    shown = " and ".join(f"`{element_text(r.place)}` at {value(r.value)}" for r in asked)
    return f" with {shown}" if len(asked) > 1 else ""


def by_values(steps: Steps, condition: object, step: Executed) -> Iterator[Link]:
    """Yield where the variables of a condition came from: of two, what was set later at the end."""
    asked = telling(steps, asked_for(steps, condition, step)[:2])
    for each in asked[1:]:
        yield from (link._replace(minor=True) for link in chain_of(steps, each))
    for each in asked[:1]:
        yield from chain_of(steps, each)
