"""Rows of a class with everything that an overview may have to show."""

from fractions import Fraction
from random import Random

from msgspec.structs import replace

from vrts.check.mark.grade import REVIEW
from vrts.marking.result import Check, Kind, Metrics, Named, Program, Result, Versions
from vrts.marking.row import Change, Class, HandedIn, Lateness, Row, Student, row_of

DIGEST = 64 * "a"
NAMES = ("Anna Ady", "Ben Bär", "Çelik Ömer", "Daria Dudek", "Eva-Maria von der Heide", "李 小龍")
KINDS = (Kind.DOES_NOT_COMPILE, Kind.STOPPED, Kind.MISSING, Kind.AMBIGUOUS, Kind.RESOURCE)
CAUSES = (
    "At 12.4 s, line 17 `MOVES base2_put`, the held `can1` hits `base1` (−1.5)",
    "`can2` is 23.4 mm from the middle of `base1`, where 10 mm are allowed (−2.1)",
    "Nothing was lost: every goal is reached and nothing was touched",
)


def plain_result(identifier: str = "anna") -> Result:
    """Return a result in full marks."""
    return Result(
        schema="vrts.result/1",
        id=identifier,
        kind=Kind.GRADED,
        mark=10.0,
        lowest=None,
        review=(),
        ready=True,
        obstacles=(),
        cause=CAUSES[-1],
        hint=None,
        line=None,
        time_s=None,
        parts=None,
        losses=(),
        checks=(
            Check("target can1", "can1 on base2", "target", "holds", 3.0, 3.0, False, ""),
            Check("target can2", "can2 on base1", "target", "holds", 3.0, 3.0, False, ""),
            Check("collision", "no contact", "contact", "holds", 0.0, 0.0, False, ""),
            Check("demand gentle", "gentle", "demand", "holds", 0.0, 0.0, True, ""),
        ),
        metrics=Metrics(duration_s=12.5, horizon_s=12.5, contacts=0),
        findings=(),
        stamps=(),
        more=0,
        task=Named("cans", "Cans on bases", DIGEST),
        scene=Named("cans", "Cans on bases", DIGEST),
        program=Program("pick.v2", DIGEST, 120),
        versions=Versions("0.1", 1, "coal"),
        key=DIGEST,
    )


def plain_row(identifier: str = "anna", name: str = "", **changed: object) -> Row:
    """Return the row of a result that differs in some fields."""
    return row_of(replace(plain_result(identifier), **changed), Student(name), HandedIn("a.v2"))


def failed(result: Result, *checks: str) -> tuple[Check, ...]:
    """Return the checks of a result, some of them violated, earning nothing and costing 1.5."""
    return tuple(
        replace(c, answer="violated", points=0.0 if c.most else -1.5) if c.id in checks else c
        for c in result.checks
    )


def some_class(count: int, seed: int = 7) -> Class:
    """Return a class with marks, lateness, changes and every kind of trouble."""
    draw = Random(seed)
    rows = tuple(_drawn(k, draw) for k in range(count))
    return Class("vrts.class/1", "Cans on bases, group 3", rows)


def _drawn(k: int, draw: Random) -> Row:
    name = NAMES[k % len(NAMES)] + ("" if k < len(NAMES) else f" {k // len(NAMES)}")
    result = replace(plain_result(f"s{k:04d}"), metrics=_metrics(draw))
    late: Lateness | None = None
    change: Change | None = None
    if draw.random() < 0.12:
        kind = draw.choice(KINDS)
        marked = kind in (Kind.DOES_NOT_COMPILE, Kind.STOPPED)
        checks = tuple(replace(c, answer="not reached", points=0.0) for c in result.checks)
        result = replace(
            result,
            kind=kind,
            mark=0.0 if marked else None,
            ready=False,
            cause=f"Line 3: found THEN ({kind.value})",
            checks=checks if marked else (),
            metrics=Metrics(),
            program=result.program if marked else None,
            review=() if marked or kind is Kind.MISSING else (f"{kind.value}: look by hand",),
        )
    elif draw.random() < 0.7:
        wrong = [c.id for c in result.checks if draw.random() < 0.4]
        lost = draw.choice((0.5, 1.5, 1.5, 2.5, 3.0, 4.2, 6.0))
        mark = round(10.0 - lost, 1)
        cause = CAUSES[k % 2]
        checks = failed(result, *wrong)
        result = replace(result, mark=mark, ready=False, cause=cause, checks=checks)
        if draw.random() < 0.1:
            lowest = round(max(0.0, mark - 1.5), 1)
            words = "left finger and can1 at 1.3 s: too close to call"
            between = f"{REVIEW}: the mark is between {lowest} and {mark}"
            result = replace(result, lowest=lowest, review=(between, f"{REVIEW}: {words}"))
    if draw.random() < 0.08:
        late = Lateness(90_000, "1/2", "1 day 1 h late: 0.5 points less")
    if draw.random() < 0.05:
        change = Change(str(Fraction(3, 2)), "the table was moved in the lab", "jh", "2026-11-21")
    student = Student(name, f"s{k}@example.org", f"login{k}")
    return row_of(result, student, HandedIn(f"{name}/pick.v2"), late, change)


def _metrics(draw: Random) -> Metrics:
    contacts = draw.choice((0, 0, 0, 1, 1, 2, 5, 9))
    took = round(draw.gauss(14, 3), 3)
    return Metrics(took, took, 40, contacts, 0, 3.2)
