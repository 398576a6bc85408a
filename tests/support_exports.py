"""Classes to export: plain ones, hostile ones, and any."""

import json
from collections.abc import Sequence
from fractions import Fraction

import msgspec
from hypothesis import strategies as st

from tests.places import TESTS
from vrts.base.diagnostic import Severity
from vrts.marking.exports.given import Given, Page
from vrts.marking.result import (
    Check,
    Finding,
    Kind,
    Loss,
    Metrics,
    Named,
    Program,
    Result,
    Versions,
)
from vrts.marking.row import Change, Class, HandedIn, Lateness, Row, Student, row_of

DATA = TESTS / "data"
HOSTILE: tuple[str, ...] = tuple(json.loads((DATA / "hostile_strings.json").read_text("utf-8")))
DIGEST = 64 * "a"
SECRET = "xyzzy-hidden"  # in everything that students may not see
PNG = "iVBORw0KGgo="


def goal(points: float, *, title: str = "can1 on base1", hidden: bool = False) -> Check:
    answer = "holds" if points == 5 else "violated"
    message = SECRET if hidden else "`can1` is 3 mm off"
    return Check(f"target {title}", title, "target", answer, points, 5.0, hidden, message)


def result(
    identifier: str = "anna", mark: float | None = 8.5, kind: Kind = Kind.GRADED, words: str = ""
) -> Result:
    """Return a student's result; `words` stand wherever a program's words can stand."""
    lost = Fraction(10) - Fraction(repr(0.0 if mark is None else mark))
    said = words or "line 17, the held `can1` hits `base1`"
    return Result(
        schema="vrts.result/1",
        id=identifier,
        kind=kind,
        mark=mark,
        lowest=None,
        review=(),
        ready=False,
        obstacles=(said,),
        cause=said,
        hint=words or "how high is `base1`?",
        line=17,
        time_s=12.4,
        parts=None,
        losses=()
        if mark is None
        else (Loss(float(lost), str(lost), "contact", said, words or "look", 17, 12.4),),
        checks=()
        if mark is None
        else (
            Check("target a", words or "can1 on base1", "target", "holds", 10.0, 10.0, False, ""),
            Check("c", "no contact", "contact", "violated", -float(lost), 0.0, False, said),
        ),
        metrics=Metrics(duration_s=12.5, contacts=1),
        findings=(
            Finding("V401", "contact", Severity.ERROR, said, 17, 3, 12.4, (words or "x",)),
            Finding("V401", "contact", Severity.WARNING, said, None, None, None, ()),
        ),
        stamps=(),
        more=0,
        task=Named("cans", words or "Cans on bases", DIGEST),
        scene=Named("cans", "Cans on bases", DIGEST),
        program=Program(words or "pick.v2", DIGEST, 120),
        versions=Versions("0.1", 1, "coal"),
        key=DIGEST,
    )


def secret(public: Result, mark: float) -> Result:
    """Return the staff's result of the same run, with a hidden check that lost points."""
    hidden = Check("demand h", SECRET, "demand", "violated", -1.5, 0.0, True, SECRET)
    loss = Loss(1.5, "3/2", "demand", SECRET, SECRET, None, None)
    return msgspec.structs.replace(
        public,
        mark=mark,
        cause=SECRET,
        checks=(*public.checks, hidden),
        losses=(loss, *public.losses),
        review=(SECRET,),
    )


def row(
    identifier: str = "anna",
    mark: float | None = 8.5,
    *,
    kind: Kind = Kind.GRADED,
    student: Student | None = None,
    late: Lateness | None = None,
    change: Change | None = None,
) -> Row:
    return row_of(
        result(identifier, mark, kind),
        student or Student(identifier.title()),
        HandedIn(f"{identifier}.v2", "the only one", "2026-11-01T12:00:00+01:00"),
        late,
        change,
    )


def given(
    rows: Sequence[Row], public: dict[str, Result] | None = None, title: str = "Lab 1"
) -> Given:
    """Return what exports are made of; students see the rows' own results unless told otherwise."""
    seen = {one.id: one.result for one in rows} | (public or {})

    def pages(identifier: str) -> tuple[Page, ...]:
        report = f'<p>{identifier}</p><img src="data:image/png;base64,{PNG}">'
        return (Page("report.html", report.encode()), Page("run.rrd", b"recording"))

    return Given(Class("vrts.class/1", title, tuple(rows)), seen, pages)


def hostile(words: str, number: int = 0) -> Row:
    """Return a row in which everything foreign says the same."""
    return row_of(
        result(f"s{number}", 4.5, words=words),
        Student(words, words, words, {"moodle": str(number), "canvas": str(1000 + number)}),
        HandedIn(words, words, words),
        Lateness(60, "1/2", words),
        Change("1/10", words, words, words),
    )


tenths = st.integers(0, 100).map(lambda n: n / 10)
fractions = st.fractions(-3, 3, max_denominator=12)


@st.composite
def rows(draw: st.DrawFn) -> tuple[Row, ...]:
    """Return the rows of any class."""
    count = draw(st.integers(0, 6))
    found: list[Row] = []
    for n in range(count):
        mark = draw(st.none() | tenths)
        kind = Kind.RESOURCE if mark is None else Kind.GRADED
        points = abs(draw(fractions))
        late = draw(st.none() | st.just(Lateness(60, str(points), "1 min late")))
        change = draw(st.none() | fractions.map(lambda f: Change(str(f), "r", "w", "2026-01-01")))
        words = draw(st.text(max_size=8) | st.sampled_from(HOSTILE))
        ids = {"moodle": str(100 + n), "canvas": str(500 + n)}
        student = Student(words, f"s{n}@example.org", f"login{n}", ids)
        found.append(row(f"s{n}", mark, kind=kind, student=student, late=late, change=change))
    return tuple(found)
