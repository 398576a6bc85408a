"""Laws of the mark: it never falls when something gets better, and stays from 0 to 10."""

from dataclasses import replace
from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from vrts.check.task.score import Achieved, contact_loss, rounded_mark, score, share_of
from vrts.check.task.task import MarkScheme

SCHEME = MarkScheme()
PAR, LONGEST = Fraction(10), Fraction(20)
SHARES = st.fractions(0, 1, max_denominator=20)
GOALS = st.lists(st.tuples(st.sampled_from([Fraction(1), Fraction(2)]), SHARES), max_size=4)


@st.composite
def achievements(draw: st.DrawFn) -> Achieved:
    vias = draw(st.integers(0, 4))
    return Achieved(
        goals=tuple(draw(GOALS)),
        vias=vias,
        vias_met=draw(st.integers(0, vias)),
        contacts=draw(st.integers(0, 7)),
        completed=draw(st.booleans()),
        duration_s=draw(st.none() | st.fractions(1, 40, max_denominator=20)),
    )


def mark(achieved: Achieved) -> Fraction:
    return rounded_mark(score(achieved, SCHEME, PAR, LONGEST))


@given(achievements())
def test_a_mark_is_a_number_of_tenths_from_0_to_10(achieved: Achieved) -> None:
    found = mark(achieved)
    assert 0 <= found <= 10
    assert (found * 10).denominator == 1


@given(achievements(), st.integers(0, 3), SHARES)
def test_a_goal_reached_better_never_costs(achieved: Achieved, index: int, more: Fraction) -> None:
    goals = list(achieved.goals)
    if index >= len(goals):
        return
    weight, share = goals[index]
    goals[index] = (weight, min(Fraction(1), share + more))
    assert mark(replace(achieved, goals=tuple(goals))) >= mark(achieved)


@given(achievements())
def test_everything_else_that_gets_better_never_costs(achieved: Achieved) -> None:
    found = mark(achieved)
    assert mark(replace(achieved, completed=True)) >= found
    if achieved.contacts:
        assert mark(replace(achieved, contacts=achieved.contacts - 1)) >= found
    if achieved.vias_met < achieved.vias:
        assert mark(replace(achieved, vias_met=achieved.vias_met + 1)) >= found
    if achieved.duration_s is not None:
        assert mark(replace(achieved, duration_s=achieved.duration_s / 2)) >= found


@given(st.integers(0, 20))
def test_the_loss_by_contacts_grows_up_to_its_cap(count: int) -> None:
    less, more = contact_loss(count, SCHEME), contact_loss(count + 1, SCHEME)
    assert 0 <= less <= more <= SCHEME.contact_cap


@given(st.fractions(0, 100, max_denominator=50), st.fractions(0, 10, max_denominator=50))
def test_a_share_falls_with_the_error(error: Fraction, more: Fraction) -> None:
    tolerance, zero_at = Fraction(10), Fraction(3)
    share = share_of(error, tolerance, zero_at)
    assert 0 <= share_of(error + more, tolerance, zero_at) <= share <= 1
    assert (share == 1) is (error <= tolerance)
    assert (share == 0) is (error >= 30)
