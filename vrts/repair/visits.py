"""How a program goes to places, by its own habits: a program that repeats itself deviates once.

A visit is what programs do at a place: approach it, slow down, go there, wait, move the hand and
leave. Most of a program's visits are alike. What one of them lacks, or does otherwise, stands out.
"""

import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from enum import IntEnum
from typing import NamedTuple

from vrts.lang.syntax.expressions import Item, Number, Prefix
from vrts.repair.written import Written, WrittenRow, WrittenStep

MISSING = 1.0  # what a visit is the odder for, that lacks what most visits have
OTHERWISE = 0.5  # and for going, leaving or closing by another word than most
AGAIN = 1.0  # for a hand that does again what it did last, and a place gone to from itself
TOO_FAR = 0.7  # and for a distance that is far from what is usual
TOO_NEAR = 1.0  # or so short that nothing is cleared by it
SHORT = 30.0  # [mm] of such a distance
TIMES = 2.0  # how far from the usual a distance is that stands out
ELSEWHERE = 1.5  # for a visit that approaches one place and goes to another
TURNED = 0.5  # for a location that is turned otherwise than most
POSE = 6
SLOWER = 0.3  # of a visit that is not slowed down for like the others


class Part(IntEnum):
    """What a step is of a visit, in the order of its steps."""

    APPROACH = 0
    SPEED = 1
    PLACE = 2
    WAIT = 3
    HAND = 4
    LEAVE = 5


WORDS = {
    "APPRO": Part.APPROACH,
    "APPROS": Part.APPROACH,
    "MOVE": Part.PLACE,
    "MOVES": Part.PLACE,
    "BREAK": Part.WAIT,
    "DELAY": Part.WAIT,
    "OPEN": Part.HAND,
    "CLOSE": Part.HAND,
    "OPENI": Part.HAND,
    "CLOSEI": Part.HAND,
    "DEPART": Part.LEAVE,
    "DEPARTS": Part.LEAVE,
}
MOVING = frozenset({Part.APPROACH, Part.PLACE, Part.LEAVE})
ASKED = (Part.APPROACH, Part.SPEED, Part.PLACE, Part.HAND, Part.LEAVE)


class Stop(NamedTuple):
    """A step of a visit, as it is written."""

    part: Part
    word: str
    target: str  # the location that it goes to or near, lower case; "" where it names none
    distance: str  # as it is written, "" where it has none
    step: WrittenStep


class Visit(NamedTuple):
    """Steps at one place, one after another."""

    stops: tuple[Stop, ...]

    def of(self, part: Part) -> Stop | None:
        """Return the step that is a part of the visit; None: it has none."""
        return next((stop for stop in self.stops if stop.part is part), None)

    @property
    def target(self) -> str:
        """The location, as its approach or the way there names it; "" where neither does."""
        return next((stop.target for stop in self.stops if stop.target), "")

    @property
    def parted(self) -> bool:
        """Whether it approaches one place and goes to another."""
        near, there = self.of(Part.APPROACH), self.of(Part.PLACE)
        return near is not None and there is not None and near.target != there.target

    @property
    def lines(self) -> tuple[int, ...]:
        """The lines of its steps."""
        return tuple(stop.step.line for stop in self.stops)


def visits(written: Written) -> tuple[Visit, ...]:
    """Return the visits of a program in the order of its text."""
    found: list[Visit] = []
    program, moved = -1, False
    for group in _joined(_groups(written)):
        parts = {stop.part for stop in group.stops}
        if group.stops[0].step.program != program:
            program, moved = group.stops[0].step.program, False
        moved = moved or bool(parts & MOVING)
        if _is_visit(parts) and moved:
            found.append(group)
    return tuple(found)


def usual_parts(found: Sequence[Visit]) -> frozenset[Part]:
    """Return the parts that at least half of all visits have, of two or more."""
    if len(found) < 2:
        return frozenset()
    return frozenset(
        part for part in ASKED if 2 * sum(v.of(part) is not None for v in found) >= len(found)
    )


class Habits(NamedTuple):
    """What most places of a program have."""

    parts: frozenset[Part]  # of visits
    turned: tuple[float, ...]  # O, A, T [deg] of most locations; empty: there is no such


def habits(written: Written) -> Habits:
    """Return the habits of a program."""
    return Habits(usual_parts(visits(written)), _usual_turn(written))


def oddness(written: Written, usual: Habits | None = None) -> float:
    """Return how far a program is from its own habits; 0 where it keeps to all of them.

    Args:
        written: The program.
        usual: The habits that it is to have; None: its own.
    """
    usual = habits(written) if usual is None else usual
    found = visits(written)
    return (
        _lacking(found, usual.parts)
        + ELSEWHERE * sum(visit.parted for visit in found)
        + _other_words(found)
        + sum(how_far for _, how_far in odd_distances(found))
        + AGAIN * _repeated(written)
        + TURNED * sum(1 for _ in turned_rows(written, usual.turned))
    )


def odd_distances(found: Sequence[Visit]) -> Iterator[tuple[Stop, float]]:
    """Yield the steps whose distances stand out, and how much."""
    for part in (Part.APPROACH, Part.LEAVE):
        stops = [stop for visit in found if (stop := visit.of(part)) is not None]
        values = [abs(x) for stop in stops if (x := number(stop.distance))]
        for stop in stops:
            value = number(stop.distance)
            if value is None:
                continue
            others = [x for x in values if x != abs(value)]
            usual = sorted(others)[len(others) // 2] if others else abs(value)
            if value < SHORT:
                yield stop, TOO_NEAR
            elif max(value / usual, usual / value) > TIMES and values.count(value) == 1:
                yield stop, TOO_FAR


def turned_rows(
    written: Written, usual: tuple[float, ...]
) -> Iterator[tuple[WrittenRow, tuple[float, ...]]]:
    """Yield the locations that are turned otherwise than is usual, and how: O, A, T [deg]."""
    found = [(row, _turn(row)) for row in _poses(written)]
    yield from ((row, turn) for row, turn in found if usual and turn != usual)


def _usual_turn(written: Written) -> tuple[float, ...]:
    """Return O, A, T of more than half of all locations, of three at least; else nothing."""
    angles = [_turn(row) for row in _poses(written)]
    most = Counter(angles).most_common(1)
    return next((turn for turn, times in most if times > 2 and 2 * times > len(angles)), ())


def _poses(written: Written) -> list[WrittenRow]:
    rows = [row for row in written.rows if row.kind == "locations"]
    poses = [row for row in rows if len(row.node.values) == POSE]
    return [row for row in poses if not any(map(math.isnan, _turn(row)))]


def _turn(row: WrittenRow) -> tuple[float, ...]:
    return tuple(map(_value, row.node.values[3:]))


def _value(item: Item) -> float:
    match item:
        case Number():
            return item.value
        case Prefix("-", Number() as inner):
            return -inner.value
        case _:
            return math.nan


def number(text: str) -> float | None:
    """Return the number that a text is; None where it is another expression."""
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def stop_of(step: WrittenStep) -> Stop | None:
    """Return what a step is of a visit; None: nothing."""
    words = step.text.split(None, 1)
    word = words[0].upper()
    rest = words[1].strip() if len(words) > 1 else ""
    if word == "SPEED":
        return None if rest.upper().endswith("ALWAYS") else Stop(Part.SPEED, word, "", rest, step)
    part = WORDS.get(word)
    if part is None:
        return None
    if part is Part.LEAVE:
        return Stop(part, word, "", rest, step)
    if part is Part.APPROACH:
        target, _, distance = rest.rpartition(",")
        return Stop(part, word, _same(target), distance.strip(), step)
    return Stop(part, word, _same(rest) if part is Part.PLACE else "", "", step)


def _same(text: str) -> str:
    return "".join(text.split()).lower()


def _groups(written: Written) -> Iterator[Visit]:
    """Yield steps that may belong together: parts in their order, waiting between any of them.

    Nothing is yielded as a group of its own where other steps stand between two.
    """
    group: list[Stop] = []
    program = -1
    for step in written.steps:
        stop = stop_of(step)
        if stop is None or step.program != program:
            yield from (Visit(tuple(group)), Visit(()))
            group = []
        program = step.program
        if stop is None:
            continue
        last = next((each for each in reversed(group) if each.part is not Part.WAIT), None)
        if last is not None and stop.part is not Part.WAIT and stop.part <= last.part:
            yield Visit(tuple(group))
            group = []
        group.append(stop)
    if group:
        yield Visit(tuple(group))


def _joined(groups: Iterable[Visit]) -> Iterator[Visit]:
    """Yield groups, and one for two where a place is gone to, and then again: it is approached."""
    waiting: Visit | None = None
    for group in groups:
        if waiting is not None and group.stops and group.target == waiting.target:
            near = [
                stop._replace(part=Part.APPROACH) if stop.part is Part.PLACE else stop
                for stop in waiting.stops
            ]
            yield Visit((*near, *group.stops))
            waiting = None
            continue
        if waiting is not None:
            yield waiting
        only = {stop.part for stop in group.stops} - {Part.WAIT} == {Part.PLACE}
        waiting = group if only else None
        if not only and group.stops:
            yield group
    if waiting is not None:
        yield waiting


def _is_visit(parts: Collection[Part]) -> bool:
    """Return whether steps belong to a visit: the hand, an approach, or a place and a way out."""
    return Part.HAND in parts or Part.APPROACH in parts or {*parts, Part.APPROACH} >= MOVING


def _lacking(found: Sequence[Visit], usual: Collection[Part]) -> float:
    total = 0.0
    for visit in found:
        for part in usual:
            if visit.of(part) is None:
                total += SLOWER if part is Part.SPEED else MISSING
    return total


def _other_words(found: Sequence[Visit]) -> float:
    """Return what words speak against visits that use others than most."""
    total = 0.0
    for part in (Part.APPROACH, Part.PLACE, Part.LEAVE):
        stops = [stop for visit in found if (stop := visit.of(part)) is not None]
        words = Counter(stop.word for stop in stops if WORDS[stop.word] is part)
        total += OTHERWISE * (sum(words.values()) - max(words.values(), default=0))
    waits = Counter(
        stop.word.endswith("I") for visit in found if (stop := visit.of(Part.HAND)) is not None
    )
    return total + OTHERWISE * (sum(waits.values()) - max(waits.values(), default=0))


def _repeated(written: Written) -> int:
    """Return how often the hand does again what it did last, or a motion goes where it is."""
    count = 0
    program, hand, place, near = -1, "", "", ""
    for step in written.steps:
        if step.program != program:
            program, hand, place, near = step.program, "", "", ""
        stop = stop_of(step)
        if stop is None:
            if step.text.split()[0].upper() in ("CALL", "FOR", "WHILE", "IF", "ELSE", "END"):
                hand, place, near = "", "", ""
            continue
        if stop.part is Part.HAND:
            count += stop.word[:4] == hand
            hand = stop.word[:4]
        elif stop.part is Part.PLACE:
            count += stop.target in (place, near)
            place, near = stop.target, ""
        elif stop.part is Part.LEAVE:
            place, near = "", place
        elif stop.part in (Part.APPROACH, Part.WAIT):
            place, near = "", ""
    return count
