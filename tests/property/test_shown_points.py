"""Points as they are shown add up to the mark, and numbers beside limits compare as they do."""

import re
from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests import laws
from tests.places import ROOT
from vrts.base.beside import beside
from vrts.check.judge import judge
from vrts.check.mark.apportion import apportioned
from vrts.check.mark.grade import Grade
from vrts.check.mark.mark import grade
from vrts.check.rules.scheme import Contacts, MarkScheme, scaled
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.task import Task, ViaPoint
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.page.checks import checks_section
from vrts.report.quantities import MINUS, lost
from vrts.report.screen.first_screen_text import first_screen_text
from vrts.report.screen.palette import Palette

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
PROGRAMS = {
    "solution": SOLUTION,
    "one can": SOLUTION.replace("        CALL carry(can2_grip, base1_put)\n", ""),
    "beside": SOLUTION.replace("1100.00   230.00", "1117.00   230.00"),
    "both beside": SOLUTION.replace("1100.00   230.00", "1115.00   230.00").replace(
        "950.00  -130.00", "963.00  -130.00"
    ),
    "touches": (EXAMPLE / "submissions" / "hits-base.v2").read_text("utf-8"),
    "stops": SOLUTION.replace("MOVE safe\n        TYPE", "MOVE nowhere\n        TYPE"),
    "moves a limit": SOLUTION.replace("OPENI  ", "PARAMETER SPEED.MAX = 400\n\tOPENI  ", 1),
}
AMOUNTS = st.fractions(-10, 20, max_denominator=60)
THIRDS = st.sampled_from([Fraction(n, 3) for n in (1, 2, 3, 4, 7)])


@given(st.lists(AMOUNTS, min_size=1, max_size=8), st.fractions(-1, 1, max_denominator=100))
def test_what_is_apportioned_adds_up_and_stays_near(
    exact: list[Fraction], rounding: Fraction
) -> None:
    if not any(exact):
        return
    total = Fraction(round((sum(exact) + rounding / 20) * 100), 100)
    shown = apportioned(exact, total)
    assert sum(shown) == total
    assert all((points * 100).denominator == 1 for points in shown)
    for amount, points in zip(exact, shown, strict=True):
        assert points == 0 if amount == 0 else amount * points >= 0
        assert abs(amount - points) <= Fraction(7, 100) + Fraction(len(exact), 100)


@given(st.lists(st.fractions(0, 4, max_denominator=60), min_size=1, max_size=8))
def test_tenths_stay_as_they_are(exact: list[Fraction]) -> None:
    exact = [*exact, Fraction(3, 2), Fraction(1)]
    total = Fraction(round(sum(exact) * 10), 10)
    if any(amount % Fraction(1, 10) for amount in exact):
        assert apportioned(exact, total)[-2:] == (Fraction(3, 2), 1)


@given(
    st.fractions(0, 50, max_denominator=1000),
    st.fractions(-1, 1, max_denominator=1000),
    st.integers(0, 1),
)
def test_numbers_are_shown_so_that_they_compare_as_they_do(
    limit: Fraction, away: Fraction, least: int
) -> None:
    value = Fraction(round((limit + away) * 1000), 1000)
    limit = Fraction(round(limit * 1000), 1000)
    shown, allowed = (Fraction(text) for text in beside(value, limit, least=least, most=3))
    assert (shown > allowed) == (value > limit)
    assert (shown < allowed) == (value < limit)


def test_ten_and_a_bit_is_not_shown_as_ten() -> None:
    assert beside(Fraction("10.4"), Fraction(10), least=0) == ("10.4", "10")
    assert beside(Fraction("25.432"), Fraction("25.4"), most=3) == ("25.43", "25.4")
    assert beside(Fraction("25.6"), Fraction("25.4"), most=3) == ("25.6", "25.4")


@cache
def known(name: str) -> tuple[Assessment, Run, Task]:
    """Return what was found out about a program under the task as it is."""
    found = assess(Request(ProgramFile(PROGRAMS[name].encode(), "a.v2"), load_task(EXAMPLE)))
    assert found.run is not None
    assert found.task is not None
    return found, found.run, found.task


@st.composite
def tasks(draw: st.DrawFn) -> Task:
    """Draw a task that asks something of the cans of the example, out of any total."""
    _, _, task = known("solution")
    usual = scaled(Fraction(draw(st.sampled_from([10, 20, 37, 45, 100, 125, 1000])), 10))
    by = usual.total / 10
    first = draw(st.sampled_from([Fraction(3, 2), Fraction(3, 4), Fraction(1, 3)]))
    scheme = replace(
        usual,
        first_contact=first * by,
        time_bonus=draw(st.sampled_from([usual.time_bonus, by, Fraction(0)])),
        broken_limit=draw(st.sampled_from([usual.broken_limit, Fraction(1, 3) * by])),
        contacts_by=draw(st.sampled_from(Contacts)),
    )
    weights = [draw(THIRDS) for _ in task.goals]
    goals = tuple(
        goal._replace(weight=weight) for goal, weight in zip(task.goals, weights, strict=True)
    )
    places = st.sampled_from([(0.9, 0.03, 0.1), (0.2, 0.2, 0.9)])  # on every way, on no way
    vias = tuple(
        ViaPoint(f"via {k}", draw(places), 0.03, None) for k in range(draw(st.integers(0, 3)))
    )
    words = draw(st.lists(st.sampled_from(["CALL", "SIGNAL"]), max_size=2, unique=True))
    demands = tuple(
        Demand(Keeps.USES, f"must use {word}", draw(THIRDS) * by, None, word=word) for word in words
    )
    return replace(
        task,
        goals=goals if draw(st.booleans()) else goals[:1],
        vias=vias,
        demands=demands,
        mark=scheme,
        t_par=draw(st.sampled_from([task.t_par, 10.58, 8.0])),
    )


def under(name: str, task: Task) -> tuple[Assessment, Grade]:
    """Return a program as it is marked under a task."""
    a, run, _ = known(name)
    assert a.judgement is not None
    judgement = judge(run.scene, run, task, report=a.judgement.collisions)
    marked = grade(task, run, judgement)
    return replace(a, task=task, judgement=judgement, grade=marked), marked


def numbers(text: str) -> list[Fraction]:
    """Return the points that begin the lines of a table."""
    found = re.findall(r"^\s*([+−]?\d+\.\d+)  ", text, re.MULTILINE)
    return [Fraction(number.replace(MINUS, "-")) for number in found]


@pytest.mark.thorough
@settings(max_examples=laws.examples(200), deadline=None)
@given(st.sampled_from(sorted(PROGRAMS)), tasks())
def test_every_table_adds_up_to_the_mark(name: str, task: Task) -> None:
    a, marked = under(name, task)
    total = task.mark.total
    assert 0 <= marked.mark <= total
    assert sum(loss.points for loss in marked.losses) == total - marked.mark
    assert sum(row.points for row in marked.earned) == marked.mark
    rest = sum(loss.points for loss in marked.losses if loss.kind == "task")
    assert sum(row.most for row in marked.earned) == total - rest
    assert not any("rounding" in (x.kind, x.kind) for x in (*marked.losses, *marked.earned))
    for row in marked.earned:
        assert row.points <= row.most
        if row.kind == "target" and row.message == "":
            assert row.points == row.most
    text = first_screen_text(a, Palette(color=False))
    if marked.losses:
        *rows, shown = numbers(text)
        assert sum(rows) + total == shown == marked.mark
    page = checks_section(a, ())
    assert page is not None
    table = str(page).split('class="sum"')[1]
    cells = re.findall(r'<td class="number">([^<]*)</td>', table)
    *parts, whole = (Fraction(cell.replace(MINUS, "-")) for cell in cells)
    assert sum(parts) == whole == marked.mark
    assert sum(Fraction(lost(x.points).replace(MINUS, "-")) for x in marked.losses) == (
        marked.mark - total
    )


def test_the_usual_numbers_are_the_default() -> None:
    assert scaled(Fraction(10)) == MarkScheme()
