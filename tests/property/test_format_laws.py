"""Laws of the canonical layout: it is stable, and it never changes what a program means."""

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, VAL2, Dialect
from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.writing.layout import layout

PROGRAMS = [
    path.read_text("utf-8", errors="replace")
    for folder in ("tests/golden/lang", "examples")
    for path in sorted((ROOT / folder).rglob("*.v2"))
]
LINES = sorted({line for text in PROGRAMS for line in text.splitlines() if line.strip()})


def ir_of(text: str, dialect: Dialect) -> str | None:
    module = compile_source(SourceFile("a.v2", text), Options(dialect)).module
    return None if module is None else dump(module)


def comments(text: str) -> list[str]:
    found: list[str] = []
    for line in text.split("\n"):
        cut = comment_start(line)
        if cut >= 0:
            found.append(line[cut:].rstrip())
    return found


def holds(text: str, dialect: Dialect) -> None:
    after = layout(SourceFile("a.v2", text), dialect)
    assert layout(SourceFile("a.v2", after), dialect) == after
    assert after.count("\n") == text.count("\n")
    assert comments(after) == comments(text)
    assert ir_of(after, dialect) == ir_of(text, dialect)


def test_there_are_programs() -> None:
    assert len(PROGRAMS) > 15


@pytest.mark.parametrize("text", PROGRAMS)
def test_real_programs_keep_their_meaning(text: str) -> None:
    holds(text, VAL2)


def squeezed(line: str) -> str:
    """Return a line without the blanks that need not be there, in the other case."""
    if '"' in line or ";" in line or "'" in line:
        return line
    return re.sub(r"\s*([-+*/=<>(),:])\s*", r"\1", line).swapcase()


@pytest.mark.parametrize("text", PROGRAMS)
def test_other_spellings_come_out_alike(text: str) -> None:
    other = "\n".join(squeezed(line) for line in text.split("\n"))
    holds(other, VAL2)


@given(
    st.lists(st.sampled_from(LINES), max_size=25),
    st.sampled_from(sorted(DIALECTS.values())),
)
def test_any_lines(lines: list[str], dialect: Dialect) -> None:
    holds("\n".join([".PROGRAM main(a, $b)", *lines, ".END"]), dialect)


WORDS = (
    'x $s #p 1 5. .5 1E-3 ^HFF \'a "t;" ( ) [ ] , + - * / : = == =< <> NOT AND MOD TO BY THEN '
    "MOVE SET TYPE IF FOR BASE SPEED ALWAYS SIN dx TRANS /F8.2 10 END DO ; & #[ .x ** ^ 2: WRITE"
)
PIECES = st.sampled_from([*WORDS.split(), "\t", "  "])


@given(
    st.lists(st.lists(PIECES, max_size=9), max_size=8),
    st.sampled_from(sorted(DIALECTS.values())),
)
def test_any_pieces(rows: list[list[str]], dialect: Dialect) -> None:
    body = [" ".join(row) for row in rows]
    holds("\n".join([".PROGRAM main", *body, ".END"]), dialect)
    holds("\n".join(["".join(row) for row in rows]), dialect)


@pytest.mark.parametrize("path", sorted((ROOT / "tests/data/lang_findings").glob("*")))
@pytest.mark.parametrize("dialect", sorted(DIALECTS.values()))
def test_what_fuzzing_found(path: Path, dialect: Dialect) -> None:
    holds(path.read_text("utf-8"), dialect)
