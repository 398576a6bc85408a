"""A step that stands in a program again has the same tree, at its own place."""

import re
from typing import get_args

import pytest

from tests.places import TESTS
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source
from vrts.lang.dialect import AS, VAL, VAL2, VAL2_PLUS, VPLUS, Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Line
from vrts.lang.steps.step_parser import MAX_SEEN, StepParser
from vrts.lang.syntax.moved import moved
from vrts.lang.syntax.statements import Bad, Statement

BY = 7
FENCED = re.compile(r"^```[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
PAGES = sorted((TESTS / "spec").glob("lang-*.md"))
MORE = """
SHIFT a BY 1, , 3
ACCEL (2) 50, 25 ALWAYS
WRITE (5) "a", x[1, 2]
AUTO REAL a, b[10]
ATTACH (1, 4)
SETI n = 3
PACK $a, 1, 2 = $b
SET a = SHIFT(p BY 1, 2, 3):b[i+1]
CALLS $name(a, (b))
IF a == -1 GOTO 10
IFSIG 1, -2 THEN 10
IGNORE 1001 ALWAYS
GOTO there
VALUE 1, 2:
"""


def steps() -> list[str]:
    """Return what stands on the lines of the language's specification, and rarer forms."""
    texts = [found for page in PAGES for found in FENCED.findall(page.read_text("utf-8"))]
    lines = [line.partition(";")[0].strip() for text in (*texts, MORE) for line in text.split("\n")]
    return [line for line in dict.fromkeys(lines) if line and line[0] != "."]


def read(text: str, before: int, dialect: Dialect) -> Statement | None:
    """Return a step that stands behind blanks, where nothing was to be said of it."""
    problems = Problems(SourceFile("", " " * before + text), dialect)
    step = StepParser(problems).step(Line(1, text, before, before + len(text)))
    return None if problems.found else step.statement


@pytest.mark.thorough
@pytest.mark.parametrize("dialect", [VAL2, VAL2_PLUS, VAL, VPLUS, AS], ids=lambda d: d.name)
def test_a_moved_step_is_the_step_read_there(dialect: Dialect) -> None:
    found = [(read(text, 0, dialect), read(text, BY, dialect)) for text in steps()]
    read_twice = [(one, other) for one, other in found if one is not None and other is not None]
    assert len(read_twice) > 100
    for one, other in read_twice:
        assert moved(one, BY) == other
        assert type(moved(one, BY)) is type(other)
        assert moved(other, -BY) == one


@pytest.mark.thorough
def test_every_form_of_a_step_is_moved() -> None:
    seen = {
        type(read(text, 0, dialect))
        for dialect in (VAL2, VAL2_PLUS, VAL, VPLUS, AS)
        for text in steps()
    }
    assert seen >= set(get_args(Statement)) - {Bad}


def test_a_step_that_was_warned_of_is_warned_of_again() -> None:
    body = "IF a == 1 OR b == 2 AND c THEN\nEND\n" * 3
    problems = Problems(SourceFile("", body))
    parser = StepParser(problems)
    at = 0
    for number, text in enumerate(body.splitlines(), 1):
        parser.step(Line(number, text, at, at + len(text)))
        at += len(text) + 1
    assert [d.primary.span.line for d in problems.found if d.primary is not None] == [1, 3, 5]


def test_no_more_steps_are_kept_than_fit() -> None:
    lines = [f"x = {number}" for number in range(MAX_SEEN + 50)]
    problems = Problems(SourceFile("", "\n".join(lines)))
    parser = StepParser(problems)
    at = 0
    for number, text in enumerate(lines, 1):
        parser.step(Line(number, text, at, at + len(text)))
        at += len(text) + 1
    assert len(parser.seen) == MAX_SEEN


def test_the_same_line_twice_comes_from_two_places() -> None:
    text = ".PROGRAM main\nTYPE 1+1\nTYPE 1+1\n.END\n"
    module = compile_source(SourceFile("main.v2", text)).module
    assert module is not None
    assert [origin.span.line for origin in module.programs["main"].origins] == [2, 3, 4]
