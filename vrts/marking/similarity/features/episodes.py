"""Where and how a run takes each thing and puts it down, whatever the order of things.

Each number is compared with the same one of other runs by how near it is, so values that were
shifted a little still count. Motions put in between matter little. Places that the scene names are
no evidence.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import fsum
from typing import NamedTuple

from vrts.marking.similarity.features.motion import between, in_mm
from vrts.marking.submission.sketch import Sketch, Stop

ASIDE_MM = 60.0  # a stop at most this far aside of a place is above it, or below
LEAST_MM = 3.0  # from a place
SEARCHED = 3  # stops before and behind a place, among which is the one above it
FAMILIES = {  # kinds that follow from one decision
    **dict.fromkeys(("above", "raise", "over", "leave"), "heights"),
    **dict.fromkeys(
        (f"{kind} speed" for kind in ("take", "put", "above", "raise", "over", "leave")), "speeds"
    ),
    **dict.fromkeys(("take", "put", "together"), "places"),
    **dict.fromkeys(("take axis", "put axis"), "axes"),
}
MOST_OF_KEY = 12  # details of a kind and a thing
TURNED_MM = 100.0  # what a straight motion instead of another counts as

Vector = tuple[float, ...]


class Detail(NamedTuple):
    """A number or a point of a run."""

    kind: str
    thing: str  # that it is about; "": none
    at: Vector  # mm, percent, or hundredths of a direction
    line: int  # of the program


class _Episode(NamedTuple):
    """From where a thing is taken to where it is put."""

    thing: str
    taken: int  # numbers of stops
    put: int
    above: int | None  # the last stop above the place where it is taken, and so on
    raised: int | None
    over: int | None
    left: int | None


def by_key(sketch: Sketch | None) -> dict[tuple[str, str], list[Detail]]:
    """Return what there is to compare of a run, by kind and thing, no point twice."""
    found: dict[tuple[str, str], dict[Vector, Detail]] = {}
    if sketch is not None:
        for one in details_of(sketch):
            some = found.setdefault((one.kind, one.thing), {})
            if len(some) < MOST_OF_KEY:
                some.setdefault(one.at, one)
    return {key: list(some.values()) for key, some in found.items()}


def details_of(sketch: Sketch) -> Iterator[Detail]:
    """Yield what there is to compare of a run, by how near it is."""
    stops = sketch.stops
    before = 0  # the first stop that no episode has had
    places: list[tuple[str, Vector, int]] = []
    for one in _episodes(stops):
        yield from _details(one, stops)
        way = range(_or(one.raised, one.taken) + 1, _or(one.over, one.put))
        yield from _points("way", one.thing, [stops[k] for k in way])
        come = range(before, _or(one.above, one.taken))
        yield from _points("come", one.thing, [stops[k] for k in come])
        before = _or(one.left, one.put) + 1
        for kind, stop in (("take", stops[one.taken]), ("put", stops[one.put])):
            if not stop.named:
                places.append((f"{kind} {one.thing}", in_mm(stop.beside), stop.line))
    if places:
        yield from _points("go", "", stops[before:])
        yield from _together(places)


def _details(one: _Episode, stops: Sequence[Stop]) -> Iterator[Detail]:
    thing = one.thing
    for kind, place in (("take", one.taken), ("put", one.put)):
        stop = stops[place]
        if not stop.named:
            yield Detail(kind, thing, in_mm(stop.beside), stop.line)
            yield Detail(f"{kind} axis", thing, tuple(map(float, stop.axis)), stop.line)
        yield Detail(f"{kind} speed", thing, (float(stop.speed),), stop.line)
    beside = {
        "above": (one.above, one.taken),
        "raise": (one.raised, one.taken),
        "over": (one.over, one.put),
        "leave": (one.left, one.put),
    }
    for kind, (number, place) in beside.items():
        if number is not None:
            stop = stops[number]
            yield Detail(kind, thing, between(stops[place], stop), stop.line)
            yield Detail(f"{kind} speed", thing, (float(stop.speed),), stop.line)
    row = (one.above, one.taken, one.raised, one.over, one.put, one.left)
    manner = tuple(TURNED_MM * (0.5 if k is None else stops[k].straight) for k in row)
    yield Detail("manner", thing, manner, stops[one.taken].line)


def _episodes(stops: Sequence[Stop]) -> Iterator[_Episode]:
    last = -1
    for taken, stop in enumerate(stops):
        if stop.hand != "close" or taken <= last:
            continue
        put = next((k for k in range(taken + 1, len(stops)) if stops[k].hand == "open"), None)
        if put is None:
            return
        yield _Episode(
            stop.thing,
            taken,
            put,
            _above(stops, range(taken - 1, max(last, taken - 1 - SEARCHED), -1), taken),
            _above(stops, range(taken + 1, min(put, taken + 1 + SEARCHED)), taken),
            _above(stops, range(put - 1, max(taken, put - 1 - SEARCHED), -1), put),
            _above(stops, range(put + 1, min(len(stops), put + 1 + SEARCHED)), put),
        )
        last = put


def _above(stops: Sequence[Stop], numbers: range, place: int) -> int | None:
    for number in numbers:
        x, y, z = between(stops[place], stops[number])
        if x * x + y * y <= ASIDE_MM**2 and max(abs(x), abs(y), abs(z)) > LEAST_MM:
            return number
    return None


def _together(places: Sequence[tuple[str, Vector, int]]) -> Iterator[Detail]:
    """Yield places from the middle of all: the same when all are shifted alike."""
    if len(places) < 2:
        return
    middle = [fsum(at[k] for _, at, _ in places) / len(places) for k in range(3)]
    for kind, at, line in places:
        away = tuple(a - b for a, b in zip(at, middle, strict=True))
        yield Detail("together", kind, away, line)


def _or(number: int | None, place: int) -> int:
    return place if number is None else number


def _points(kind: str, thing: str, stops: Sequence[Stop]) -> Iterator[Detail]:
    for stop in stops:
        if not stop.named:
            yield Detail(kind, thing, in_mm(stop.at), stop.line)


_WORDS: Mapping[str, str] = {
    "take": "the hand takes {} at nearly the same point",
    "put": "the hand puts {} down at nearly the same point",
    "above": "nearly the same way down to {}",
    "raise": "{} is raised by nearly as much",
    "over": "nearly the same way down to where {} is put",
    "leave": "the hand leaves {} by nearly as much",
    "way": "nearly the same point on the way with {}",
    "come": "nearly the same point on the way to {}",
    "go": "nearly the same point at the end",
    "manner": "straight and other motions alike around {}",
    "together": "nearly the same point beside the others, to {}",
}


def words_of_detail(detail: Detail) -> str:
    """Return what two runs have nearly alike, in words."""
    kind, _, rest = detail.kind.partition(" ")
    if detail.kind == "together":
        deed, _, thing = detail.thing.partition(" ")
        return _WORDS["together"].format(f"{deed} `{thing}`")
    said = _WORDS[kind].format(f"`{detail.thing}`")
    if rest == "speed":
        return f"nearly the same speed of the motion: {said}"
    return f"nearly the same direction of the hand: {said}" if rest == "axis" else said
