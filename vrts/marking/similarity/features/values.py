"""Taught values, exactly and within a tolerance, and the distances between them.

Distances stay when all values are shifted alike. Along one axis they stay to the last digit, also
when the other axes are shifted value by value.
"""

from collections.abc import Iterator
from itertools import combinations

from vrts.marking.similarity.features.feature import Channel, Feature, near
from vrts.marking.similarity.features.taught import DECIMALS, Taught, taught
from vrts.marking.similarity.symbols import Readable

NEAR_MM, FAR_MM = 8.0, 24.0  # of a cell
TURN_DEG = 8.0
APART_MM = 3.0  # of a cell of distances
GRID_MM = 0.5  # on which people write numbers: what lies on it tells nothing
MOST = 16  # values of which distances are compared
MOST_VALUES = 300  # of a program


def value_features(file: Readable) -> Iterator[Feature]:
    """Yield what there is to compare of the values that a program teaches."""
    values = taught(file)[:MOST_VALUES]
    for value in values:
        yield Feature(Channel.NUMBERS, "value", value.numbers, value.line)
        for size in (NEAR_MM, FAR_MM):
            yield from near(
                Channel.NUMBERS, "near", (len(value.numbers),), value.numbers[:3], size, value.line
            )
        if len(value.numbers) == 6:
            turned = value.numbers[3:]
            odd = [n for n in turned if abs(n / 90.0 - round(n / 90.0)) > 1e-6]
            if odd:
                yield from near(Channel.NUMBERS, "turn", (), turned, TURN_DEG, value.line)
    poses = [value for value in values if len(value.numbers) == 6][:MOST]
    for one, other in combinations(poses, 2):
        yield from _apart(one, other)
        yield from _along(one, other)


def _apart(one: Taught, other: Taught) -> Iterator[Feature]:
    by = tuple(b - a for a, b in zip(one.numbers[:3], other.numbers[:3], strict=True))
    first = next((n for n in by if abs(n) > APART_MM), 0.0)
    if first == 0.0:
        return
    sign = 1.0 if first > 0 else -1.0
    yield from near(Channel.NUMBERS, "apart", (), tuple(sign * n for n in by), APART_MM, other.line)


def _along(one: Taught, other: Taught) -> Iterator[Feature]:
    """Yield how far apart two values lie along each axis, to the last digit, unless it is round."""
    for axis, (a, b) in enumerate(zip(one.numbers[:3], other.numbers[:3], strict=True)):
        by = round(abs(b - a), DECIMALS)
        if abs(by / GRID_MM - round(by / GRID_MM)) > 1e-6:
            yield Feature(Channel.OFFSETS, "along", (axis, by), other.line)
