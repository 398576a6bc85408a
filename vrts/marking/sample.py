"""Marks again what was marked, and compares: the same program must have the same result."""

import random
from collections.abc import Iterator, Sequence
from copy import copy
from typing import NamedTuple

import msgspec

from vrts.marking.differences import Difference, differences
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker
from vrts.marking.supervise.scratch import scratch_folder

OTHERS = ("variant",)  # depends on the others of the class
STAFF, STUDENT = "for those who mark", "for the student"


class Unlike(NamedTuple):
    """A result that is another one when it is made again."""

    identifier: str
    whose: str  # which of the two results of a submission
    first: Difference


def verify_sample(
    marker: Marker, done: Sequence[Done], *, count: int, seed: int, jobs: int = 1
) -> tuple[Unlike, ...]:
    """Mark a random sample again, and return the first difference of every result that differs.

    Nothing is written; recordings and pages are not compared. What was lost to the limits of a
    process is left out: it has no mark.

    Args:
        marker: With which they were marked.
        done: What was marked.
        count: How many to mark again at most.
        seed: Decides which.
        jobs: Processes at a time.
    """
    chosen = sampled(done, count, seed)
    before = {one.entry.identifier: one for one in chosen}
    found: dict[str, tuple[Unlike, ...]] = {}
    for one in mark_again(marker, [one.entry for one in chosen], jobs=jobs):
        name = one.entry.identifier
        pairs = (
            (STAFF, before[name].result, one.result),
            (STUDENT, before[name].student, one.student),
        )
        found[name] = tuple(
            Unlike(name, whose, difference)
            for whose, old, new in pairs
            if (difference := next(differences(old, new, OTHERS), None)) is not None
        )
    return tuple(unlike for one in chosen for unlike in found[one.entry.identifier])


def sampled(done: Sequence[Done], count: int, seed: int) -> tuple[Done, ...]:
    """Return a random sample of what was marked, the same for the same seed."""
    marked = [
        one
        for one in sorted(done, key=lambda one: one.entry.identifier)
        if one.entry.data is not None and one.result.kind is not Kind.RESOURCE
    ]
    return tuple(random.Random(seed).sample(marked, min(count, len(marked))))  # noqa: S311


def mark_again(marker: Marker, entries: Sequence[Entry], *, jobs: int = 1) -> Iterator[Done]:
    """Mark programs in processes of their own, writing nothing; keys are as if all was written."""
    quiet = copy(marker)
    quiet.wanted = msgspec.structs.replace(marker.wanted, pages=False, recordings=False)
    with scratch_folder() as staging:
        for one in mark_class(quiet, entries, None, jobs=jobs, staging=staging):
            assert one.entry.data is not None
            own = marker.of(one.entry.student)
            keys = own.key(one.entry.data), own.public_key(one.entry.data)
            yield one._replace(
                result=msgspec.structs.replace(one.result, key=keys[0]),
                student=msgspec.structs.replace(one.student, key=keys[1]),
            )
