"""Whatever is handed in is answered by a module or by diagnostics, never by an exception."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.places import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.cli.language.problems import FORMS, render
from vrts.ir.dump import dump
from vrts.ir.verify import verify
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import DIALECTS, VAL2, Dialect
from vrts.lang.problems import LIMIT
from vrts.lang.reading.decoding import decode
from vrts.lang.typed.execute_line import parse_command
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS
from vrts.lang.writing.layout import layout
from vrts.report.formats.checked import Checked

REAL = [
    path.read_text("utf-8")
    for folder in ("tests/golden/lang", "tests/data/lang_findings", "examples/01-cans-on-bases")
    for path in sorted((ROOT / folder).glob("*.*"))
    if path.suffix in (".v2", ".as", ".val")
]
FINDINGS = sorted((ROOT / "tests/data/lang_findings").iterdir())
DIALECT = st.sampled_from([None, *sorted(DIALECTS.values())])
WORDS = [*INSTRUCTIONS, *OPERATORS, *QUALIFIERS, "a", "b", "$s", "#p", "part", "TRANS", "DX"]
SIGNS = [*"=+-*/<>()[],:;.'^/%$#&!@?", '"', "==", "<>", "=<", ":=", "“", "”", "–", "ö", "\u00a0"]
ODD = [".x", ".$s", "#[1,2]", "**", "10.", "JOINT SPEED9 ACCU1", ".PROGRAM", ".END"]
NUMBERS = [
    "0",
    "1",
    "10",
    "3.5",
    "1E3",
    "1E99",
    "^17",
    "^H",
    "/F8.2",
    "/I0",
    "'A",
    '"text"',
]
TOKENS = st.sampled_from([*WORDS, *SIGNS, *NUMBERS, *ODD])

PROGRAM = """.PROGRAM main(a, $s, v[])
        OPENI
        FOR i = 1 TO 4 STEP 2
            CALL pick(i, part, , v[])
            IF (i == 2) AND NOT SIG(1001, -2) THEN
                TYPE "a", /F8.2, i*2+1, $s+"x", /S
            ELSE
                GOTO 10
            END
        END
10      CASE i OF
          VALUE 1, 2:
            READY
          ANY
            v[1] = a MOD 3
        END
        WHILE a < 3 DO
            a = a+1
        END
        DO
        UNTIL SIG(1001)
        SET tray[2] = frame:SHIFT(part BY 0,,10):TRANS(1,2,3,,,9)
        HERE frame:part
        BASE ,,300
        SPEED 50 MMPS ALWAYS
.END
.PROGRAM pick(n, l, x, q[])
        APPRO l, 60
        MOVES l
        CLOSEI
        DEPARTS 60
.END
.LOCATIONS
part            450.0 -120.0 -50.0 90.0 90.0 0.0
#safe           0 -90 90 0 0 0
.END
"""


def check(compilation: Compilation) -> None:
    if compilation.module is None:
        assert any(d.is_error for d in compilation.diagnostics)
    else:
        assert not any(d.is_error for d in compilation.diagnostics)
        assert verify(compilation.module) == []
        assert dump(compilation.module)
    assert len(compilation.diagnostics) <= LIMIT + 1
    for d in compilation.diagnostics:
        assert d.headline
        assert d.headline[-1] != "."
        for label in (d.primary, *d.secondary):
            if label is not None:
                start, end = label.span.start, label.span.end
                assert 0 <= start <= end <= len(label.span.source.text)
                assert "\n" not in label.span.text


def one_line(d: Diagnostic) -> tuple[object, ...]:
    place = d.primary and (d.primary.span.start, d.primary.span.end)
    return (place, d.rule, d.headline, d.notes, d.help)


def compile_text(text: str, dialect: Dialect | None = VAL2) -> Compilation:
    return compile_source(SourceFile("test.v2", text), Options(dialect))


def test_the_program_itself_compiles() -> None:
    assert compile_text(PROGRAM).module is not None


@pytest.mark.parametrize(
    "dialect", [None, *sorted(DIALECTS.values())], ids=lambda d: d.name if d else "auto"
)
@pytest.mark.parametrize("path", FINDINGS, ids=lambda path: path.stem)
def test_findings_of_fuzzing(path: Path, dialect: Dialect | None) -> None:
    text = path.read_text("utf-8")
    check(compile_text(text, dialect))
    once = layout(SourceFile("test.v2", text), dialect or VAL2)
    assert layout(SourceFile("test.v2", once), dialect or VAL2) == once


@given(st.binary(max_size=300), DIALECT)
def test_any_bytes(data: bytes, dialect: Dialect | None) -> None:
    source = decode(data, "test.v2")
    if not isinstance(source, Diagnostic):
        check(compile_source(source, Options(dialect)))


@given(st.text(max_size=300), DIALECT)
def test_any_text(text: str, dialect: Dialect | None) -> None:
    check(compile_text(text, dialect))


@given(st.lists(st.lists(TOKENS, max_size=10), max_size=12), st.sampled_from(["", " "]), DIALECT)
def test_token_soup(lines: list[list[str]], glue: str, dialect: Dialect | None) -> None:
    body = "\n".join(glue.join(line) for line in lines)
    check(compile_text(f".PROGRAM main(a)\n{body}\n.END\n", dialect))


@given(st.sampled_from(REAL), st.data(), DIALECT)
def test_mutated_real_programs(text: str, data: st.DataObject, dialect: Dialect | None) -> None:
    for _ in range(data.draw(st.integers(0, 3))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(len(text), start + 30)))
        text = text[:start] + data.draw(TOKENS) + text[end:]
    once = compile_text(text, dialect)
    check(once)
    again = compile_text(text, dialect)
    assert list(map(one_line, again.diagnostics)) == list(map(one_line, once.diagnostics))
    if once.module is not None and again.module is not None:
        assert dump(again.module) == dump(once.module)
    for form in FORMS:
        found = Checked("test.v2", once.diagnostics, once.module is not None)
        assert isinstance(render([found], form), str)


@given(st.lists(TOKENS, max_size=8), st.sampled_from(["", " "]))
def test_any_command(pieces: list[str], glue: str) -> None:
    command, found = parse_command(SourceFile("command", glue.join(["EX", *pieces])))
    assert command is not None or any(d.is_error for d in found) or not "".join(pieces)


@given(st.one_of(st.text(max_size=80), st.text(max_size=80).map("EX ".__add__)))
def test_any_text_as_a_command(text: str) -> None:
    parse_command(SourceFile("command", text))


@given(st.sampled_from(REAL), st.data(), DIALECT)
def test_mutated_programs_are_laid_out(
    text: str, data: st.DataObject, dialect: Dialect | None
) -> None:
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(len(text), start + 30)))
    text = text[:start] + data.draw(TOKENS) + text[end:]
    once = layout(SourceFile("test.v2", text), dialect or VAL2)
    assert layout(SourceFile("test.v2", once), dialect or VAL2) == once


@given(st.data())
def test_mutated_program(data: st.DataObject) -> None:
    text = PROGRAM
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(len(text), start + 12)))
        inserted = data.draw(st.one_of(TOKENS, st.just("\n"), st.just("")))
        text = text[:start] + inserted + text[end:]
    check(compile_text(text))


@given(st.permutations(PROGRAM.split("\n")))
def test_shuffled_lines(lines: list[str]) -> None:
    check(compile_text("\n".join(lines)))
