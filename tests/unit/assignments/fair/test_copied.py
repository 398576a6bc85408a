"""Pairs of students, of which one copies from the other."""

import pytest

from vrts.assignments.fair.copied import Copied, sample


@pytest.mark.parametrize("students", [2, 3, 14, 15, 40, 300])
def test_pairs_are_different_and_from_the_whole_class(students: int) -> None:
    pairs = sample(students, 200)
    assert len(set(pairs)) == len(pairs)
    assert all(a != b and 0 <= a < students and 0 <= b < students for a, b in pairs)
    every = students * (students - 1)
    assert len(pairs) == every if every <= 200 else 190 <= len(pairs) <= 200
    copiers = {b for _, b in pairs}
    assert len(copiers) >= min(students, 40)
    assert max(copiers) - min(copiers) >= 0.9 * (students - 1)


def test_nineteen_of_twenty_pairs_have_to_earn_at_most_half() -> None:
    assert not Copied(200, 10, 200).pays
    assert Copied(200, 11, 200).pays
    assert Copied(2, 1, 2).pays


def test_what_a_sample_does_not_show_is_not_taken_for_shown() -> None:
    """The limits are those of the tables of Clopper and Pearson."""
    assert Copied(200, 10, 200).shown  # these are all
    assert Copied(200, 4, 89_700).shown
    assert not Copied(200, 5, 89_700).shown
    assert not Copied(200, 5, 89_700).pays
    assert Copied(59, 0, 89_700).shown
    assert not Copied(58, 0, 89_700).shown
