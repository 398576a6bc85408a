"""Which programs of a class share most of what is rare.

What two programs share counts one, divided by the number of other programs that have it too: what
everybody writes counts next to nothing, whatever it is. What comes with the task counts nothing.
Programs that are the same throughout share all of it, unless most of the class has them.
"""

from collections import Counter, defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations, islice
from typing import Annotated, Literal, NamedTuple, TypeVar

import msgspec
from msgspec import Meta

from vrts.marking.result import Record
from vrts.marking.similarity.features.taught import Taught, taught
from vrts.marking.similarity.groups import Group
from vrts.marking.similarity.regions import Region, regions
from vrts.marking.similarity.symbols import Part, Readable, Reader, readable
from vrts.marking.similarity.winnowing import K, W, hashes, winnow

SCHEMA = "vrts.similarity/2"
NOTE = (
    "a ranking of what to look at, and no verdict: programs are alike for many reasons, such as one"
    " textbook, one lab, one table of locations, or help that was allowed"
)
COMMON_SHARE = 0.25  # of the class: what more programs have is common, and left out
COMMON_FLOOR = 12  # programs that may share something in any class
DOUBT = 1.0  # weight that two programs may share by chance
LEAST_SCORE = 0.08  # of a pair in the ranking
MOST_PAIRS = 200  # in the ranking
MOST_SHARED_VALUES = 100  # shown of a pair

Key = TypeVar("Key", bound=Hashable)
Share = Annotated[float, Meta(ge=0, le=1)]


class SharedValue(Record, frozen=True):
    """A taught value that two programs have, and few others."""

    numbers: tuple[float, ...]
    first: str  # name in the first program
    first_line: int
    second: str
    second_line: int
    others: Annotated[int, Meta(description="further programs that have it")]


class Pair(Record, frozen=True):
    """Two programs that share something."""

    first: str
    second: str
    score: Annotated[Share, Meta(description="of both shares together")]
    code: Annotated[Share, Meta(description="share of the code, what is rare counting more")]
    taught: Annotated[Share, Meta(description="share of the taught values, likewise")]
    regions: tuple[Region, ...]
    values: tuple[SharedValue, ...]


class Corpus(Record, frozen=True):
    """Programs of an earlier year or another folder."""

    name: str
    programs: int
    ran: Annotated[int, Meta(description="of which it is known what their runs did")]
    sha256: Annotated[str, Meta(description="of its programs.zip; empty: it has none")] = ""


class Ranking(Record, frozen=True):
    """Groups of programs that seem to come from one source, and pairs with equal text."""

    schema: Literal["vrts.similarity/2"]
    note: str
    compared: Annotated[int, Meta(description="programs that could be read")]
    symbols: Annotated[int, Meta(description="in a row that must be the same: K of winnowing")]
    window: Annotated[int, Meta(description="W of winnowing")]
    pairs: Annotated[tuple[Pair, ...], Meta(description="with equal text, most alike first")]
    groups: Annotated[tuple[Group, ...], Meta(description="most alike first")] = ()
    corpus: tuple[Corpus, ...] = ()


class Fingerprinted(NamedTuple):
    """A program, ready to be compared."""

    parts: tuple[Part, ...]
    prints: tuple[tuple[int, int, int], ...]  # hash, number of the part, place in it
    taught: tuple[Taught, ...]


def similarity(
    programs: Mapping[str, bytes],
    template: Iterable[bytes] = (),
    groups: Mapping[str, str] | None = None,
) -> Ranking:
    """Return the pairs of programs that are most alike.

    Args:
        programs: By identifier; what is no text is left out.
        template: Programs and locations that everybody was given.
        groups: By identifier, the same for those who handed in together: they are not compared.
    """
    reader = Reader()
    given, given_values = _given(template, reader)
    found: dict[str, Fingerprinted] = {}
    for name in sorted(programs):
        file = readable(programs[name], name)
        if file is not None:
            found[name] = _fingerprinted(file, reader, given, given_values)
    names = list(found)
    together = [(groups or {}).get(name, "") for name in names]
    code = _shares([{value for value, _, _ in found[name].prints} for name in names])
    code.update(dict.fromkeys(_same([found[name] for name in names]), 1.0))
    values = _shares([{value.numbers for value in found[name].taught} for name in names])
    scored: list[tuple[float, str, str, float, float]] = []
    for pair in code.keys() | values.keys():
        i, j = pair
        if together[i] and together[i] == together[j]:
            continue
        by_code, by_values = code.get(pair, 0.0), values.get(pair, 0.0)
        score = 1.0 - (1.0 - by_code) * (1.0 - by_values)
        if score >= LEAST_SCORE:
            scored.append((score, names[i], names[j], by_code, by_values))
    scored.sort(key=lambda row: (-round(row[0], 6), row[1], row[2]))
    owners = Counter(value.numbers for name in names for value in found[name].taught)
    common = _common(len(names))
    pairs = tuple(
        Pair(
            first,
            second,
            round(score, 3),
            round(by_code, 3),
            round(by_values, 3),
            _regions(found[first], found[second]),
            _shared_values(found[first], found[second], owners, common),
        )
        for score, first, second, by_code, by_values in scored[:MOST_PAIRS]
    )
    return Ranking("vrts.similarity/2", NOTE, len(names), K, W, pairs)


def _same(programs: Sequence[Fingerprinted]) -> Iterator[tuple[int, int]]:
    """Yield pairs of programs whose own code is the same throughout.

    What most of a class has in the same words was given to them, whoever forgot to say so.
    """
    alike: dict[tuple[int, ...], list[int]] = defaultdict(list)
    for k, program in enumerate(programs):
        if program.prints:
            alike[tuple(value for value, _, _ in program.prints)].append(k)
    most = max(COMMON_FLOOR, len(programs) // 2)
    groups = [members for members in alike.values() if len(members) <= most]
    pairs = (pair for members in groups for pair in combinations(members, 2))
    yield from islice(pairs, MOST_PAIRS)


def to_bytes(ranking: Ranking) -> bytes:
    """Return a ranking as JSON, laid out for people."""
    return msgspec.json.format(msgspec.json.encode(ranking), indent=1) + b"\n"


def _given(
    template: Iterable[bytes], reader: Reader
) -> tuple[frozenset[int], frozenset[tuple[float, ...]]]:
    """Return the hashes and values of what everybody was given."""
    prints: set[int] = set()
    values: set[tuple[float, ...]] = set()
    for data in template:
        file = readable(data, "template")
        if file is not None:
            for part in reader.parts(file):
                prints.update(hashes(part.symbols))
            values.update(value.numbers for value in taught(file))
    return frozenset(prints), frozenset(values)


def _fingerprinted(
    file: Readable,
    reader: Reader,
    given: frozenset[int],
    given_values: frozenset[tuple[float, ...]],
) -> Fingerprinted:
    parts = reader.parts(file)
    prints = tuple(
        (value, number, place)
        for number, part in enumerate(parts)
        for value, place in winnow(hashes(part.symbols), given)
    )
    own = tuple(value for value in taught(file) if value.numbers not in given_values)
    return Fingerprinted(parts, prints, own)


def _common(count: int) -> int:
    """Return the largest number of programs that may have something before it is common."""
    return max(COMMON_FLOOR, int(COMMON_SHARE * count))


def _shares(sets: Sequence[set[Key]]) -> dict[tuple[int, int], float]:
    """Return for pairs of sets that share something how large a share of both it is, by weight."""
    owners: defaultdict[Key, list[int]] = defaultdict(list)
    for number, keys in enumerate(sets):
        for key in keys:
            owners[key].append(number)
    totals = [0.0] * len(sets)
    shared: defaultdict[tuple[int, int], float] = defaultdict(float)
    common = _common(len(sets))
    for numbers in owners.values():
        if len(numbers) > common:
            continue
        weight = 1.0 / max(1, len(numbers) - 1)
        for k, i in enumerate(numbers):
            totals[i] += weight
            for j in numbers[k + 1 :]:
                shared[i, j] += weight
    return {
        (i, j): both / ((totals[i] + totals[j]) / 2.0 + DOUBT) for (i, j), both in shared.items()
    }


def _regions(first: Fingerprinted, second: Fingerprinted) -> tuple[Region, ...]:
    return regions(first.parts, first.prints, second.parts, second.prints)


def _shared_values(
    first: Fingerprinted,
    second: Fingerprinted,
    owners: Mapping[tuple[float, ...], int],
    common: int,
) -> tuple[SharedValue, ...]:
    theirs = {value.numbers: value for value in second.taught}
    rows = [
        SharedValue(
            value.numbers,
            value.name,
            value.line,
            theirs[value.numbers].name,
            theirs[value.numbers].line,
            owners[value.numbers] - 2,
        )
        for value in first.taught
        if value.numbers in theirs and owners[value.numbers] <= common
    ]
    return tuple(sorted(rows, key=lambda row: row.others)[:MOST_SHARED_VALUES])
