"""Which programs of a class seem to come from one source: groups, with the evidence in words."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vrts.base.workers import Workers
from vrts.marking.similarity.evidence import (
    counts_told,
    evidence_of,
    most_telling,
    nearness_told,
)
from vrts.marking.similarity.features.counts import Counts
from vrts.marking.similarity.features.episodes import FAMILIES, Detail, by_key
from vrts.marking.similarity.features.extract import (
    CHANNELS,
    Digests,
    Program,
    digests_of,
    features_of,
)
from vrts.marking.similarity.features.feature import Channel, Feature
from vrts.marking.similarity.groups import Evidence, Group, Link, strength_of
from vrts.marking.similarity.symbols import Reader
from vrts.marking.similarity.weighing.chance import Chances, chances, sameness
from vrts.marking.similarity.weighing.counted import counted
from vrts.marking.similarity.weighing.grouping import Group as Together
from vrts.marking.similarity.weighing.grouping import groups_of
from vrts.marking.similarity.weighing.nearness import Nearness, nearness
from vrts.marking.similarity.weighing.shares import Shares, shares

MOST_EXPECTED = 20.0  # pairs by chance: links of which more are expected say nothing
MOST_LINKS = 400  # of a group, told one by one
WRITTEN = (Channel.STEPS, Channel.NUMBERS, Channel.WORDS)  # the same where a file is the same
REMEMBERED = 64  # programs whose features are kept while pairs are told
CHUNKS = 16  # parts of a class that a worker reads at a time

Names = tuple[str, ...]
Corpora = Mapping[str, Mapping[str, Program]]
Details = Mapping[tuple[str, str], Sequence[Detail]]


class Likeness(NamedTuple):
    """What was found out about a class."""

    groups: tuple[Group, ...]
    evidence: Callable[[str, str], tuple[Evidence, ...]]  # of a link, found when it is asked for


def likeness(
    programs: Mapping[str, Program],
    given: Iterable[bytes] = (),
    together: Mapping[str, str] | None = None,
    corpora: Corpora | None = None,
    jobs: int | None = None,
) -> Likeness:
    """Return the groups of programs that seem to come from one source, most alike first.

    Args:
        programs: Of the class, by identifier.
        given: Programs and locations that everybody was given.
        together: By identifier, the same for those who handed in together: no evidence.
        corpora: Programs of earlier years and other folders, by name and identifier.
        jobs: Processes at a time; None: one for each core, at most two.
    """
    own = sorted(programs)
    others = [
        (f"{name}/{one}", program)
        for name, corpus in sorted((corpora or {}).items())
        for one, program in sorted(corpus.items())
    ]
    names: Names = (*own, *(name for name, _ in others))
    all_programs = [*(programs[name] for name in own), *(program for _, program in others)]
    if not own or len(names) < 2:
        return Likeness((), _nothing)
    digests = _digests(all_programs, jobs or min(2, os.cpu_count() or 1))
    known = _given(given)
    compared = _compared(own, len(names), together or {}, digests)
    found = tuple(
        shares(
            [one.channels[k] for one in digests[: len(own)]],
            [one.channels[k] for one in digests[len(own) :]],
            known[k],
        )
        for k in range(len(CHANNELS))
    )
    written = [one for one, channel in zip(found, CHANNELS, strict=True) if channel in WRITTEN]
    details = [by_key(program.sketch) for program in all_programs]
    near = nearness([_vectors(one) for one in details], len(own), FAMILIES)
    words = [one.words for one in digests]
    as_often = counted(words, len(own))
    chance = chances(
        tuple(one.share for one in found),
        compared,
        _folders(len(own), corpora or {}),
        sameness([one.same for one in written], [one.common for one in written]),
        near.total,
        np.array([program.sketch is not None for program in all_programs]),
        as_often,
    )
    groups = groups_of(chance.surprise, chance.expected, compared, MOST_EXPECTED)
    return _told(
        groups, names, all_programs, _Found(found, chance, known, near, details, words, as_often)
    )


def _nothing(_first: str, _second: str) -> tuple[Evidence, ...]:
    return ()


class _Found(NamedTuple):
    """What was found out, in numbers."""

    shares: tuple[Shares, ...]
    chance: Chances
    given: tuple[frozenset[int], ...]
    near: Nearness
    details: Sequence[Details]
    words: Sequence[Counts]
    counted: NDArray[np.float64]


def _vectors(details: Details) -> Mapping[tuple[str, str], Sequence[tuple[float, ...]]]:
    return {key: [one.at for one in some] for key, some in details.items()}


def _folders(start: int, corpora: Corpora) -> list[slice]:
    """Return the columns of each folder, behind those of the class."""
    found: list[slice] = []
    for _, corpus in sorted(corpora.items()):
        found.append(slice(start, start + len(corpus)))
        start += len(corpus)
    return found


def _digests(programs: Sequence[Program], jobs: int) -> list[Digests]:
    """Return the programs as numbers, read in several processes."""
    reader = Reader()
    size = max(1, len(programs) // (CHUNKS * max(1, jobs)))
    chunks = [programs[k : k + size] for k in range(0, len(programs), size)]

    def read(chunk: Sequence[Program]) -> list[Digests]:
        return [digests_of(program, "program", reader) for program in chunk]

    return [one for answer in Workers(jobs).answers(read, chunks) for one in answer]


def _given(given: Iterable[bytes]) -> tuple[frozenset[int], ...]:
    reader = Reader()
    found = [digests_of(Program(data), "given", reader) for data in given]
    return tuple(
        frozenset(d for one in found for d in one.channels[k]) for k in range(len(CHANNELS))
    )


def _compared(
    own: Sequence[str], total: int, together: Mapping[str, str], digests: Sequence[Digests]
) -> NDArray[np.bool_]:
    """Return which pairs are compared: each once, and not those who handed in together."""
    compared = np.triu(np.ones((len(own), total), dtype=np.bool_), 1)
    numbers = {group: k for k, group in enumerate(sorted({*together.values()} - {""}), start=1)}
    groups = np.array([numbers.get(together.get(name, ""), 0) for name in own])
    same = (groups[:, None] == groups[None, :]) & (groups[:, None] > 0)
    compared[:, : len(own)] &= ~same
    empty = np.array([not any(one.channels) for one in digests])
    return compared & ~empty[: len(own), None] & ~empty[None, :]


def _told(
    groups: Sequence[Together],
    names: Names,
    programs: Sequence[Program],
    found: _Found,
) -> Likeness:
    reader = Reader()
    numbers = {name: number for number, name in enumerate(names)}

    @lru_cache(REMEMBERED)
    def features(number: int) -> dict[Channel, dict[int, Feature]]:
        return _by_digest(programs[number], reader)

    def evidence(first: str, second: str) -> tuple[Evidence, ...]:
        i, j = numbers[first], numbers[second]
        shared = evidence_of(features(i), features(j), found.shares, found.given)
        nearly = nearness_told(found.near.of(i, j), found.details[i], found.details[j])
        weight = float(found.counted[i, j])
        often = counts_told(found.words[i], found.words[j], weight, len(found.counted))
        return most_telling([*shared, *nearly, *often])

    told: list[Group] = []
    for group in groups:
        links: list[Link] = []
        for i, j in _some_links(group):
            expected = float(found.chance.expected[i, j])
            links.append(Link(names[i], names[j], _score(expected), strength_of(expected)))
        strongest = links[0]
        told.append(
            Group(
                tuple(names[k] for k in group.members),
                _score(group.expected),
                strength_of(group.expected),
                float(f"{group.expected:.3g}"),
                tuple(links),
                evidence(strongest.first, strongest.second),
            )
        )
    return Likeness(tuple(told), evidence)


def _some_links(group: Together) -> list[tuple[int, int]]:
    """Return the strongest links of a group, and the strongest of each member."""
    some = list(group.links[:MOST_LINKS])
    seen = {member for link in some for member in link}
    for link in group.links[MOST_LINKS:]:
        if not seen.issuperset(link):
            some.append(link)
            seen.update(link)
    return some


def _by_digest(program: Program, reader: Reader) -> dict[Channel, dict[int, Feature]]:
    found: dict[Channel, dict[int, Feature]] = {channel: {} for channel in CHANNELS}
    for feature in features_of(program, "program", reader):
        found[feature.channel].setdefault(feature.digest, feature)
    return found


def _score(expected: float) -> float:
    """Return 1 where chance explains nothing, 0.5 where one such pair is expected by chance."""
    return round(1.0 / (1.0 + expected), 4)
