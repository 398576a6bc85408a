"""What two programs share, in words, what weighs most first."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from vrts.marking.similarity.features.counts import Counts
from vrts.marking.similarity.features.episodes import Detail, words_of_detail
from vrts.marking.similarity.features.extract import CHANNELS
from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.features.words import words_of
from vrts.marking.similarity.groups import Evidence
from vrts.marking.similarity.weighing.nearness import Near, as_near
from vrts.marking.similarity.weighing.shares import Shares

MOST = 24  # told of two programs
MOST_OF_CHANNEL = 7
LEAST = 0.7  # nats: what weighs less is left out


def evidence_of(
    first: Mapping[Channel, Mapping[int, Feature]],
    second: Mapping[Channel, Mapping[int, Feature]],
    found: tuple[Shares, ...],
    given: tuple[frozenset[int], ...],
) -> tuple[Evidence, ...]:
    """Return what two programs share; of what says nearly the same, the rarest.

    Args:
        first: Features of a program, by channel and digest.
        second: Of another.
        found: What is how rare in the class, for each channel.
        given: Digests of what everybody was given, for each channel.
    """
    told = chain.from_iterable(
        _of_channel(first[channel], second[channel], found[k], given[k])
        for k, channel in enumerate(CHANNELS)
    )
    return most_telling(told)


def nearness_told(
    near: Iterable[Near],
    first: Mapping[tuple[str, str], Sequence[Detail]],
    second: Mapping[tuple[str, str], Sequence[Detail]],
) -> list[Evidence]:
    """Return what two runs have nearly alike, the rarest first."""
    told: list[Evidence] = []
    kinds: set[str] = set()
    for one in sorted(near, key=lambda one: (-round(one.weight, 3), one.key, one.first)):
        if one.weight < LEAST or len(told) == MOST_OF_CHANNEL:
            break
        if one.key[0] in kinds:
            continue
        kinds.add(one.key[0])
        mine, theirs = first[one.key][one.first], second[one.key][one.second]
        words, weight = words_of_detail(mine), round(one.weight, 2)
        told.append(Evidence("motion", words, weight, one.others, mine.line, theirs.line))
    return told


def counts_told(first: Counts, second: Counts, weight: float, count: int) -> list[Evidence]:
    """Return whether two programs have each word of the language nearly as often.

    Args:
        first: How often a program has each word.
        second: Another.
        weight: How few of the class are as near, in nats.
        count: Programs of the class.
    """
    if weight < LEAST:
        return []
    one, other = dict(first), dict(second)
    apart = sum(abs(one.get(word, 0) - other.get(word, 0)) for word in one.keys() | other.keys())
    words = "each word of the language as often" + (f", {apart} more or fewer in all" * (apart > 0))
    return [Evidence("text", words, round(weight, 2), as_near(weight, count) - 1, 0, 0)]


def most_telling(told: Iterable[Evidence]) -> tuple[Evidence, ...]:
    """Return what weighs most, first."""
    return tuple(sorted(told, key=lambda one: (-one.weight, one.what, one.words)))[:MOST]


def _of_channel(
    first: Mapping[int, Feature],
    second: Mapping[int, Feature],
    shares: Shares,
    given: frozenset[int],
) -> list[Evidence]:
    rows: list[tuple[float, int, Feature, Feature]] = []
    for digest in first.keys() & second.keys():
        if digest not in given:
            weight, owners = shares.weight(digest)
            if weight >= LEAST:
                rows.append((weight, owners, first[digest], second[digest]))
    rows.sort(key=lambda row: (-round(row[0], 3), row[2].line, row[2].kind, repr(row[2].key)))
    told: list[Evidence] = []
    seen: set[tuple[object, ...]] = set()
    for weight, owners, one, other in rows:
        words = words_of(one)
        marks = {("words", words), ("lines", one.kind, one.line, other.line)}
        if marks & seen and one.line:
            continue
        seen |= marks
        others = max(0, owners - 2)
        told.append(
            Evidence(one.channel.value, words, round(weight, 2), others, one.line, other.line)
        )
        if len(told) == MOST_OF_CHANNEL:
            break
    return told
