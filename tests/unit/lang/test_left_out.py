"""Signs left out, ranges, formats the wrong way round: the cause, and the edit where it is sure."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, mendable, with_edits

_TAUGHT = ".LOCATIONS\npick 450 -120 -250 90 90 0\nover 450 -120 -100 90 90 0\n.END\n"


def _program(body: str) -> str:
    return f".PROGRAM main\nn = 4\n{body}\nTYPE n\n.END\n.PROGRAM fence\nREADY\n.END\n{_TAUGHT}"


def _told(body: str) -> tuple[str, str, str]:
    """Return headline and help of the one message, and the program after the sure edits."""
    text = _program(body)
    compilation = compiled(text)
    found = list(said(compilation))
    assert len(found) == 1, found
    assert compilation.source is not None
    mended = with_edits(text, edits_of(mendable(compilation.source, found)))
    after = mended.split("\nTYPE n\n.END")[0].removeprefix(".PROGRAM main\nn = 4\n")
    return found[0].headline, "; ".join(found[0].help), after


@pytest.mark.parametrize(
    ("body", "help_", "after"),
    [
        ("n = SQTR(n)", "`SQRT`", "n = SQRT(n)"),
        ("CASE n OF\nVALUE 1 TO 3:\nREADY\nEND", "`VALUE 1, 2, 3:`", None),
        ("CASE n OF\nVALUE 7, 2..4:\nREADY\nEND", "`VALUE 7, 2, 3, 4:`", None),
        ("10 READY\nGOTO10", "`GOTO 10`", "10 READY\nGOTO 10"),
        ("10 READY\nIF n > 3 GOTO10", "`GOTO 10`", "10 READY\nIF n > 3 GOTO 10"),
        ("SPEED50\nMOVE pick", "`SPEED 50`", "SPEED 50\nMOVE pick"),
        ("TYPE /8.2F, n", "`/F8.2`", "TYPE /F8.2, n"),
        ("TYPE /6.1f, n, /4I, n", "`/F6.1, n, /I4`", "TYPE /F6.1, n, /I4, n"),
    ],
)
def test_what_is_surely_meant_is_mended(body: str, help_: str, after: str | None) -> None:
    _, helped, mended = _told(body)
    assert help_ in helped
    if after is None:
        before, _, _ = body.partition("VALUE")
        after = f"{before}{help_[1:-1]}\nREADY\nEND"
    assert mended == after


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ("PROMPT number of parts, n", '`PROMPT "number of parts ", n`'),
        ("CASE n OF\nVALUE 1 TO 300:\nREADY\nEND", "`VALUE 1, 2, 3:`"),
        ("CASE n OF\nVALUE 3 TO 1:\nREADY\nEND", "name each number"),
        ("CLOSE\nMOVE pick\nGRASP", "`GRASP distance` or `GRASP distance, label`"),
        ("IGNORE fence", "takes a signal number: write `IGNORE 1001`"),
        ("LOCK fence", "LOCK takes a priority"),
        ("n = 10(n+1)", "`n = 10*(n+1)`"),
        ("n = (1+n)(3+4)", "`n = (1+n)*(3+4)`"),
        ("n = n(2+1)", "`n*(2+1)`"),
        ("SET q = TRANS(400,100,50,90,90,0,0)\nMOVE q", "TRANS(x, y, z, o, a, t)"),
    ],
)
def test_nothing_is_mended_where_the_meaning_is_open(body: str, help_: str) -> None:
    _, helped, mended = _told(body)
    assert help_ in helped
    assert mended == body


def test_ignore_names_the_signal_of_the_react() -> None:
    _, helped, _ = _told("REACT 1003, fence, 2\nMOVE pick\nBREAK\nIGNORE fence")
    assert "`IGNORE 1003`" in helped


@pytest.mark.parametrize(
    "body",
    [
        "CASE n OF\nVALUE 1, 2, -3:\nREADY\nEND",
        'PROMPT "number of parts ", n',
        "n = 10*(n+1)",
        "GRASP 20",
        "SPEED 50\nMOVE pick",
        "n1 = 3\nTYPE n1, /F8.2, n",
    ],
)
def test_right_programs_stay_right(body: str) -> None:
    assert said(compiled(_program(body))) == []


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ('TYPE "first\\nsecond"', '`"first", /C1, "second"`'),
        ('TYPE "a\\tb\\n"', '`"a", /X4, "b"`'),
        ('TYPE "a\\n", n', '`"a", /C1`'),
    ],
)
def test_signs_of_c_in_a_text_have_controls(body: str, help_: str) -> None:
    assert help_ in _told(body)[1]


def test_a_sum_behind_a_semicolon_is_told_there_and_not_at_the_loop() -> None:
    headline, _, _ = _told("WHILE n < 8 DO\nMOVE pick\nCLOSEI; n = n+1\nEND")
    assert "`n = n+1` is never carried out" in headline


def test_a_remark_that_looks_like_an_assignment_stays_one() -> None:
    assert said(compiled(_program("MOVE pick ; n = 4 here\nMOVE over ; n = 4"))) == []


def test_a_semicolon_between_two_locations_is_a_colon() -> None:
    headline, helped, mended = _told("SET goal = pick;over\nMOVE goal")
    assert "`over` is not part of this SET" in headline
    assert "`pick:over`" in helped
    assert mended == "SET goal = pick;over\nMOVE goal"


def test_remarks_written_without_blanks_stay_remarks() -> None:
    body = "SET goal = pick;home\nMOVE goal;this is where it waits"
    assert said(compiled(_program(body))) == []
