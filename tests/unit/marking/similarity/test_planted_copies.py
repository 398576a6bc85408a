"""Copies in a class of synthetic students are found, and few others shown first.

`compared` does what `vrts grade` does, without marks and without a process for each. How good
this is in classes of 300 is measured by `tests/bench/test_bench_likeness.py`.
"""

import pytest

from tests.support_likeness.classes import honest, with_copies
from tests.support_likeness.grading import compared
from tests.support_likeness.judging import Group, placed, ranks, told
from tests.support_likeness.marking import mark
from tests.support_likeness.scenes import CANS

KINDS = ("names", "steps", "combined")
INNOCENT = 2  # groups above them: those who build on the lesson's own lines are much alike


@pytest.mark.thorough
def test_copies_stand_first() -> None:
    whole = with_copies(honest("cans", 1, 40, "c"), KINDS, "c")
    assert [one.kind for one in whole.planted] == list(KINDS)
    for one in whole.planted:
        source, copy = (mark(whole.students[name].text, CANS).points for name in one.members)
        assert abs(source - copy) <= 1.0
    places = placed(whole.planted, compared(whole))
    assert len(ranks(places)) == len(KINDS), told(places)
    assert max(one.above for one in places) <= INNOCENT, told(places)


@pytest.mark.thorough
def test_a_copy_in_every_disguise_at_once_stands_before_all_innocent_groups() -> None:
    """Other loops, order, values, names and layout: some values still lie as far apart."""
    whole = with_copies(honest("pallet", 1, 28, "one"), ("combined",), "one")
    (one,) = whole.planted
    assert one.changes == ("loops+steps+values+names+layout",)
    (place,) = placed(whole.planted, compared(whole))
    assert (place.rank, place.above, place.strangers) == (1, 0, 0), told([place])


def test_a_seed_makes_the_same_class_each_time_and_another_seed_another() -> None:
    first, again, other = (honest("project", 2, 12, seed).texts for seed in (1, 1, 2))
    assert first == again
    assert len(set(first.values())) == len(first)
    assert set(first.values()).isdisjoint(other.values())


def test_a_copy_counts_once_and_a_crowd_is_no_finding() -> None:
    """The judge itself: two groups of one copy take one place, a group of all students none."""
    whole = with_copies(honest("cans", 1, 30, "judge"), ("names", "filler"), "judge")
    (a, b), (c, d) = (one.members for one in whole.planted)
    crowd = frozenset(whole.students)
    groups = [
        Group(crowd, 1.0, ""),
        Group(frozenset((a, b)), 0.9, ""),
        Group(frozenset((a, b, "x")), 0.9, ""),
        Group(frozenset((c, d)), 0.8, ""),
    ]
    places = placed(whole.planted, groups)
    assert [one.rank for one in places] == [2, 4]
    assert [one.above for one in places] == [1, 1]
    assert ranks(places) == [2, 3]
    assert placed(whole.planted, groups[:1])[0].rank is None
