"""What a program did with the arm, from the sketch of its run.

Single places and short stretches are compared, so the order of goals and motions put in between
matter little. Places that the scene names are no evidence.
"""

from collections.abc import Iterator
from itertools import pairwise

from vrts.marking.similarity.features.feature import Channel, Feature, counted, near
from vrts.marking.submission.sketch import Sketch, Stop

PLACE_MM, HEIGHT_MM, STEP_MM, ROUGH_MM = 8.0, 4.0, 5.0, 25.0  # of a cell
LEAST_MM = 3.0  # of a stretch


def motion_features(sketch: Sketch) -> Iterator[Feature]:
    """Yield what there is to compare of a run."""
    yield from counted(tuple(_pieces(sketch)))


def _pieces(sketch: Sketch) -> Iterator[Feature]:
    stops = sketch.stops
    for stop in stops:
        if stop.named:
            continue
        beside = in_mm(stop.beside)
        exact = (stop.thing, *(round(n, 1) for n in beside))
        yield Feature(Channel.MOTION, "place", exact, stop.line)
        yield from near(Channel.MOTION, "near", (stop.thing,), beside, PLACE_MM, stop.line)
        yield from near(Channel.MOTION, "world", (), in_mm(stop.at), PLACE_MM, stop.line)
        where = (stop.thing, bool(stop.held))
        yield from near(Channel.MOTION, "height", where, beside[2:], HEIGHT_MM, stop.line)
        if max(map(abs, stop.axis)) < 99:  # not along an axis of the world
            yield Feature(Channel.MOTION, "axis", tuple(n // 4 for n in stop.axis), stop.line)
    for one, other in pairwise(stops):
        by = between(one, other)
        if max(map(abs, by)) < LEAST_MM:
            continue
        how = (other.straight, bool(other.held))
        yield from near(Channel.MOTION, "stretch", how, by, STEP_MM, other.line)
        length = round(sum(n * n for n in by) ** 0.5 / 10)
        key = (other.straight, other.speed, length, other.hand)
        yield Feature(Channel.MANNER, "manner", key, other.line)
    for one, two, three in zip(stops, stops[1:], stops[2:], strict=False):
        first, second, both = between(one, two), between(two, three), between(one, three)
        yield from near(Channel.MOTION, "turn", (), (*first, *second), ROUGH_MM, three.line)
        yield from near(Channel.MOTION, "across", (bool(three.held),), both, STEP_MM, three.line)
    for four in zip(stops, stops[1:], stops[2:], stops[3:], strict=False):
        yield Feature(Channel.MANNER, "deeds", tuple(_deed(s) for s in four), four[-1].line)


def _deed(stop: Stop) -> tuple[bool, bool, str, str]:
    return stop.straight, bool(stop.held), stop.hand, stop.thing


def between(one: Stop, other: Stop) -> tuple[float, ...]:
    """Return the way from a stop to another one, in mm."""
    return tuple((b - a) / 10 for a, b in zip(one.at, other.at, strict=True))


def in_mm(tenths: tuple[int, int, int]) -> tuple[float, ...]:
    """Return tenths of mm as mm."""
    return tuple(n / 10 for n in tenths)
