"""Where two programs are alike: runs of equal symbols, as long as they can be, as lines."""

from collections import defaultdict
from collections.abc import Sequence
from typing import Annotated

from msgspec import Meta

from vrts.marking.result import Record
from vrts.marking.similarity.symbols import Part
from vrts.marking.similarity.winnowing import K

MOST_REGIONS = 40  # of two programs
MOST_PLACES = 6  # of one fingerprint in one program: loops that are written out repeat themselves

Print = tuple[int, int, int]  # hash, number of the part, place in it


class Region(Record, frozen=True):
    """Lines of two programs that are the same but for names and numbers; from 1, both included."""

    first_start: int
    first_end: int
    second_start: int
    second_end: int
    symbols: Annotated[int, Meta(description="that are the same in a row")]


def regions(
    first: Sequence[Part],
    first_prints: Sequence[Print],
    second: Sequence[Part],
    second_prints: Sequence[Print],
) -> tuple[Region, ...]:
    """Return the regions in which two programs are alike, the longest first; none overlap."""
    places: defaultdict[int, list[tuple[int, int]]] = defaultdict(list)
    for value, part, place in second_prints:
        if len(places[value]) < MOST_PLACES:
            places[value].append((part, place))
    runs: set[tuple[int, int, int, int, int]] = set()  # length, part, start, part, start
    used: defaultdict[int, int] = defaultdict(int)
    reached: dict[tuple[int, int, int], int] = {}  # on a diagonal, the end of its last run
    for value, part, place in first_prints:
        if value not in places or used[value] >= MOST_PLACES:
            continue
        used[value] += 1
        for other, there in places[value]:
            diagonal = (part, other, place - there)
            if place < reached.get(diagonal, 0):
                continue
            run = _longest(first[part].symbols, place, second[other].symbols, there)
            if run is not None:
                runs.add((run[0], part, run[1], other, run[2]))
                reached[diagonal] = run[1] + run[0]
    taken: tuple[set[tuple[int, int]], set[tuple[int, int]]] = (set(), set())
    found: list[Region] = []
    for length, part, start, other, there in sorted(runs, key=lambda r: (-r[0], *r[1:])):
        mine = {(part, k) for k in range(start, start + length)}
        theirs = {(other, k) for k in range(there, there + length)}
        if mine & taken[0] or theirs & taken[1]:
            continue
        taken[0].update(mine)
        taken[1].update(theirs)
        a, b = first[part].lines, second[other].lines
        found.append(
            Region(a[start], a[start + length - 1], b[there], b[there + length - 1], length)
        )
        if len(found) == MOST_REGIONS:
            break
    return tuple(found)


def _longest(a: Sequence[int], i: int, b: Sequence[int], j: int) -> tuple[int, int, int] | None:
    """Return length and starts of the longest run round two places; None if it is shorter than K.

    Two fingerprints may be the same by chance while the symbols are not.
    """
    if a[i : i + K] != b[j : j + K]:
        return None
    back = 0
    while back < min(i, j) and a[i - back - 1] == b[j - back - 1]:
        back += 1
    on = K
    while on < min(len(a) - i, len(b) - j) and a[i + on] == b[j + on]:
        on += 1
    return back + on, i - back, j - back
