"""The first screen: the same answer, in the same order, on every medium."""

from dataclasses import replace
from fractions import Fraction

from tests.support_reports import HOSTILE, SYNTAX, broken, compiled, contact_loss, grade
from vrts.base.diagnostic import error
from vrts.base.source import SourceFile
from vrts.report.first_screen import NOTHING_LOST, first_screen
from vrts.report.screen.assessment_text import assessment_text


def test_the_costliest_cause_is_one_sentence_with_its_price() -> None:
    screen = first_screen(compiled(grade(contact_loss())))
    assert screen.cause == ("At 12.4 s, line 2 `MOVES base2_put`, the held can1 hits base1 (−1.5)")
    assert screen.hint == "how high is the underside of the can on its way?"
    assert screen.moment is not None
    assert screen.moment.time_s == 12.4
    assert screen.mark == Fraction(17, 2)


def test_a_clean_run_says_so() -> None:
    assert first_screen(compiled(grade(ready=True))).cause == NOTHING_LOST


def test_what_does_not_compile_shows_its_first_error_as_the_cause() -> None:
    screen = first_screen(broken())
    assert screen.cause == "Line 3: unexpected `THEN`"
    assert screen.hint == "begin with IF"
    assert screen.status == "does not compile"
    assert not screen.ready


def test_a_line_of_a_text_that_is_not_shown_has_no_number() -> None:
    typed = SourceFile("typed", "MOVE there")
    assert first_screen(replace(broken(), source=typed)).cause == "Unexpected `THEN`"


def test_the_text_keeps_the_order_of_the_first_screen() -> None:
    lines = assessment_text(compiled(grade(contact_loss())), color=False).split("\n")
    assert lines == [
        "8.5 / 10  submission-07.v2 · Two cans on two bases (graded)",
        "ready for the real robot: no",
        "At 12.4 s, line 2 `MOVES base2_put`, the held can1 hits base1 (−1.5)",
        "hint: how high is the underside of the can on its way?",
        "",
        "  points  lost by",
        "    −1.5  at 12.4 s, line 2 `MOVES base2_put`, the held can1 hits base1",
        "     8.5  mark, of 10",
    ]


def test_without_a_task_there_is_no_mark() -> None:
    screen = first_screen(compiled())
    assert screen.mark is None
    assert screen.status == "compiles"
    assert not screen.ready  # nothing was run, so nothing speaks for it
    assert assessment_text(compiled(), color=False).startswith("submission-07.v2 · ")


def test_names_cannot_break_a_line_or_steer_the_terminal() -> None:
    a = broken(error(SYNTAX, f"`{HOSTILE}\n` is bad", help=(HOSTILE,)), title=f"a{HOSTILE}\n.v2")
    screen = first_screen(a)
    assert "\n" not in screen.cause
    assert all(c.isprintable() for c in screen.cause)
    text = assessment_text(a, color=False)
    assert all(c.isprintable() or c == "\n" for c in text)
