"""Laws of the mark: it never falls when something gets better, and stays from 0 to the total."""

import math
from dataclasses import replace
from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from vrts.base.pose import Pose, rotation_about, translation
from vrts.check.goals.assignment import assigned
from vrts.check.goals.placed import errors_at
from vrts.check.goals.reached import with_phases
from vrts.check.mark.losses import touched_in
from vrts.check.rules.scheme import Contacts, MarkScheme, scaled
from vrts.check.task.goals import Goal, Phases
from vrts.check.task.score import (
    UNTOUCHED,
    Achieved,
    Touched,
    contact_loss,
    divided,
    rounded_mark,
    score,
    share_of,
)
from vrts.check.verdict import ContactEvent
from vrts.scene.default import robot_alone
from vrts.scene.things.forms import upright_box
from vrts.scene.things.symmetry import symmetries_of

SCHEME = MarkScheme()
PAR, LONGEST = Fraction(10), Fraction(20)
SHARES = st.fractions(0, 1, max_denominator=20)
GOALS = st.lists(st.tuples(st.sampled_from([Fraction(1), Fraction(2)]), SHARES), max_size=4)
TENTHS = st.integers(0, 40).map(lambda tenths: Fraction(tenths, 10))


@st.composite
def touches(draw: st.DrawFn) -> Touched:
    contacts = draw(st.integers(0, 7))
    some = st.fractions(0, 20, max_denominator=1000) if contacts else st.just(Fraction(0))
    return Touched(contacts, draw(st.integers(0, 3)), draw(some), draw(some))


@st.composite
def schemes(draw: st.DrawFn) -> MarkScheme:
    """Draw the numbers of a task: any total, and any way to weigh contacts."""
    total = Fraction(draw(st.integers(10, 1000)), 10)
    shares = [Fraction(draw(st.integers(0, 20)), 20) for _ in range(8)]
    whole = max(Fraction(1), sum(shares[:3], Fraction(0)))
    targets, vias, bonus = (total * share / whole for share in shares[:3])
    return MarkScheme(
        targets,
        vias,
        total * shares[3],
        total * shares[4],
        total * shares[5],
        bonus,
        Fraction(3),
        total,
        total * shares[6],
        draw(st.sampled_from(Contacts)),
        total * shares[7],
        total * shares[7] / 10,
    )


@st.composite
def achievements(draw: st.DrawFn) -> Achieved:
    vias = draw(st.integers(0, 4))
    broken = draw(TENTHS)
    return Achieved(
        goals=tuple(draw(GOALS)),
        vias=vias,
        vias_met=draw(st.integers(0, vias)),
        touched=draw(touches()),
        completed=draw(st.booleans()),
        duration_s=draw(st.none() | st.fractions(1, 40, max_denominator=20)),
        broken=broken,
        kept=not broken,
        within_limits=draw(st.booleans()),
    )


def mark(achieved: Achieved, scheme: MarkScheme = SCHEME) -> Fraction:
    return rounded_mark(score(achieved, scheme, PAR, LONGEST), scheme.total)


@given(achievements(), schemes())
def test_a_mark_is_a_number_of_tenths_from_0_to_the_total(
    achieved: Achieved, scheme: MarkScheme
) -> None:
    found = mark(achieved, scheme)
    assert 0 <= found <= scheme.total
    assert (found * 10).denominator == 1


@given(achievements(), schemes())
def test_a_broken_limit_never_raises_a_mark(achieved: Achieved, scheme: MarkScheme) -> None:
    within = mark(replace(achieved, within_limits=True), scheme)
    beyond = mark(replace(achieved, within_limits=False), scheme)
    assert beyond <= within


@given(
    achievements(),
    schemes(),
    st.fractions(0, 5, max_denominator=1000),
    st.fractions(0, 5, max_denominator=1000),
)
def test_a_longer_or_deeper_contact_never_costs_less(
    achieved: Achieved, scheme: MarkScheme, longer: Fraction, deeper: Fraction
) -> None:
    was = achieved.touched
    if not was.contacts:
        return
    more = replace(was, seconds=was.seconds + longer, depth_mm=was.depth_mm + deeper)
    assert contact_loss(was, scheme) <= contact_loss(more, scheme) <= scheme.contact_cap
    assert mark(replace(achieved, touched=more), scheme) <= mark(achieved, scheme)
    if scheme.contacts_by is not Contacts.EVENTS and was.contacts > 1:
        joined = replace(more, contacts=was.contacts - 1)  # two that grew into one
        assert contact_loss(was, scheme) <= contact_loss(joined, scheme)


@given(achievements(), st.fractions(Fraction(1, 10), 100, max_denominator=10))
def test_the_usual_numbers_are_in_proportion_to_the_total(
    achieved: Achieved, total: Fraction
) -> None:
    achieved = replace(achieved, broken=Fraction(0))
    usual = score(achieved, SCHEME, PAR, LONGEST).unrounded
    assert score(achieved, scaled(total), PAR, LONGEST).unrounded == usual * total / 10


def events(spans: list[tuple[str, int, int, int]]) -> list[ContactEvent]:
    """Return contacts as the check tells them: those of one pair less than 0.5 s apart are one."""
    found: list[ContactEvent] = []
    for name, start, lasts, depth in sorted(spans):
        start_s, end_s, depth_m = start / 1000, (start + lasts) / 1000, depth / 100_000
        last = found[-1] if found else None
        if last is not None and last.second == name and start_s - last.end_s < 0.5:
            found[-1] = last._replace(
                end_s=max(last.end_s, end_s), depth_m=max(last.depth_m, depth_m)
            )
            continue
        parts = ("hand", name)
        found.append(
            ContactEvent(
                "robot", name, parts, start_s, end_s, start_s, depth_m, (0, 0, 0), None, None
            )
        )
    return found


SPANS = st.lists(
    st.tuples(
        st.sampled_from(["base1", "base2"]),
        st.integers(0, 20_000),
        st.integers(0, 3_000),
        st.integers(1, 5_000),
    ),
    min_size=1,
    max_size=6,
)


@given(SPANS, st.integers(0, 5), st.integers(0, 4_000), st.integers(0, 4_000), schemes())
def test_by_time_and_depth_real_contacts_never_cost_less_when_they_grow(
    spans: list[tuple[str, int, int, int]], which: int, longer: int, deeper: int, scheme: MarkScheme
) -> None:
    """Also where one grows into the next, so that there are fewer of them."""
    if scheme.contacts_by is Contacts.EVENTS:
        return
    k = which % len(spans)
    name, start, lasts, depth = spans[k]
    grown = [*spans[:k], (name, start, lasts + longer, depth + deeper), *spans[k + 1 :]]
    before = contact_loss(touched_in(events(spans)), scheme)
    assert before <= contact_loss(touched_in(events(grown)), scheme)


def test_five_seconds_inside_a_base_cost_more_than_two_brief_touches_by_time() -> None:
    brief = touched_in(events([("base1", 0, 50, 80), ("base1", 3_000, 50, 80)]))
    inside = touched_in(events([("base1", 0, 5_000, 2_000)]))
    by_time = replace(SCHEME, contacts_by=Contacts.TIME)
    by_depth = replace(SCHEME, contacts_by=Contacts.DEPTH)
    assert contact_loss(inside, SCHEME) < contact_loss(brief, SCHEME)  # as it was, and stays
    assert contact_loss(inside, by_time) == 5
    assert contact_loss(brief, by_time) == Fraction("1.6")
    assert contact_loss(inside, by_depth) == Fraction("3.5")
    assert contact_loss(brief, by_depth) == Fraction("1.58")


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
    assert mark(replace(achieved, within_limits=True)) >= found
    touched = achieved.touched
    if touched.contacts:
        fewer = replace(touched, contacts=touched.contacts - 1)
        assert mark(replace(achieved, touched=fewer)) >= found
    if achieved.vias_met < achieved.vias:
        assert mark(replace(achieved, vias_met=achieved.vias_met + 1)) >= found
    if achieved.duration_s is not None:
        assert mark(replace(achieved, duration_s=achieved.duration_s / 2)) >= found


@given(st.integers(0, 20))
def test_the_loss_by_contacts_grows_up_to_its_cap(count: int) -> None:
    less, more = (contact_loss(Touched(k), SCHEME) for k in (count, count + 1))
    assert 0 <= less <= more <= SCHEME.contact_cap


@given(st.fractions(0, 100, max_denominator=50), st.fractions(0, 10, max_denominator=50))
def test_a_share_falls_with_the_error(error: Fraction, more: Fraction) -> None:
    tolerance, zero_at = Fraction(10), Fraction(3)
    share = share_of(error, tolerance, zero_at)
    assert 0 <= share_of(error + more, tolerance, zero_at) <= share <= 1
    assert (share == 1) is (error <= tolerance)
    assert (share == 0) is (error >= 30)


WEIGHTS = st.fractions(0, Fraction(9, 20), max_denominator=20)


@given(WEIGHTS, WEIGHTS, SHARES, SHARES)
def test_phases_never_cost_and_in_place_is_in_place(
    gripped: Fraction, lifted: Fraction, placed: Fraction, more: Fraction
) -> None:
    phases = Phases(gripped, lifted, 0.05)
    found = with_phases(placed, phases, gripped=False, lifted=False)
    for steps in ((False, True), (True, False), (True, True)):
        after = with_phases(placed, phases, *steps)
        assert placed <= found <= after <= 1
    better = with_phases(min(Fraction(1), placed + more), phases, gripped=True, lifted=True)
    assert with_phases(placed, phases, gripped=True, lifted=True) <= better
    assert with_phases(Fraction(1), phases, gripped=False, lifted=False) == 1
    carried = with_phases(placed, phases, gripped=True, lifted=True)
    assert carried == gripped + lifted + (1 - gripped - lifted) * placed  # as the page says


@given(st.booleans(), st.booleans(), st.fractions(0, 5), st.fractions(0, 5))
def test_the_points_of_what_a_task_has_not_go_to_the_other(
    targets: bool,
    vias: bool,
    for_targets: Fraction,
    for_vias: Fraction,
) -> None:
    scheme = replace(SCHEME, targets=for_targets, vias=for_vias)
    found = divided(scheme, targets=targets, vias=vias)
    assert sum(found) == for_targets + for_vias
    assert vias or not found[1]
    assert targets or not vias or not found[0]


@given(achievements())
def test_what_earns_everything_gets_everything(achieved: Achieved) -> None:
    """Whichever of goals and via points a task has: also with neither, or with one of them."""
    whole = replace(
        achieved,
        goals=tuple((weight, Fraction(1)) for weight, _ in achieved.goals),
        vias_met=achieved.vias,
        touched=UNTOUCHED,
        completed=True,
        duration_s=PAR,
        broken=Fraction(0),
        kept=True,
        within_limits=True,
    )
    assert mark(whole) == 10


@given(
    st.lists(st.lists(SHARES, min_size=4, max_size=4), min_size=1, max_size=4),
    st.integers(0, 3),
    st.integers(0, 3),
    SHARES,
)
def test_an_object_that_lies_better_never_costs_where_several_share_places(
    shares: list[list[Fraction]], row: int, column: int, more: Fraction
) -> None:
    def together(table: list[list[Fraction]]) -> Fraction:
        """Return the sum of the shares that count."""
        whole = [[int(share * 232792560) for share in each] for each in table]  # lcm of 1 to 20
        return sum((each[n] for each, n in zip(table, assigned(whole), strict=True)), Fraction(0))

    before = together(shares)
    better = [list(each) for each in shares]
    row %= len(better)
    better[row][column] = min(Fraction(1), better[row][column] + Fraction(round(more * 20), 20))
    assert before <= together(better) <= len(shares)


FLOOR = robot_alone().bodies[0]


def turned(X: Pose) -> float:
    """Return the turn of a pose about the vertical [degrees]."""
    return math.degrees(math.atan2(X.rotation[3], X.rotation[0]))


SIZES = st.sampled_from([(0.08, 0.06, 0.05), (0.08, 0.08, 0.05), (0.06, 0.06, 0.06)])


@given(SIZES, st.floats(-180, 180), st.floats(-40, 40), st.floats(0, 1))
def test_an_object_that_comes_nearer_to_its_goal_never_earns_less(
    size: tuple[float, float, float], turn: float, away: float, share: float
) -> None:
    """Nearer in place and in turn, to whichever of the turns that look alike is nearest."""
    brick = replace(FLOOR, pieces=upright_box(*size).pieces)
    known = [0.0, *(turned(t) for t in symmetries_of(brick).upright().turns[1:])]
    nearest = min(known, key=lambda angle: abs(math.remainder(turn - angle, 360.0)))
    rest = math.remainder(turn - nearest, 360.0)

    def earned(error_mm: float, error_deg: float) -> Fraction:
        X_WG = translation(0.9, 0.1, 0.0)
        spin = rotation_about((0.0, 0.0, 1.0), math.radians(nearest + error_deg))
        X_WO = Pose(spin, (0.9 + error_mm / 1000, 0.1, 0.0))
        goal = Goal("b", X_WG, 0.01, math.radians(5), Fraction(1), "", None)
        return errors_at(brick, goal.looks, X_WO, X_WG, goal, Fraction(3))[0]

    before = earned(away, rest)
    assert before <= earned(away * share, rest * share)
    assert earned(0.0, 0.0) == 1
