"""Files that are no programs, and programs at the edge of what fits."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.ir.verify import verify
from vrts.lang.compiler import Compilation, compile_source
from vrts.lang.reading.decoding import decode


def compile_text(text: str) -> Compilation:
    return compile_source(SourceFile("test.v2", text))


def codes(compilation: Compilation) -> list[str]:
    return [d.rule.code for d in compilation.diagnostics]


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "V101"),
        (b" \r\n\x1a", "V101"),
        (b"PK\x03\x04word document", "V102"),
        (bytes(range(256)) * 4, "V102"),
        (b"\x00" * 500, "V102"),
        (b"x" * 10_000_000, "V103"),
        (b"TYPE 1\n" + b"1+" * 50_000, "V103"),
    ],
)
def test_what_is_no_text_is_one_diagnostic(data: bytes, code: str) -> None:
    answer = decode(data, "test.v2")
    assert isinstance(answer, Diagnostic)
    assert answer.rule.code == code
    assert answer.is_error


TEXT = ".PROGRAM main\n        READY ; grüße\n.END\n"


@pytest.mark.parametrize(
    "data",
    [
        TEXT.encode(),
        b"\xef\xbb\xbf" + TEXT.encode(),
        b"\xff\xfe" + TEXT.encode("utf-16-le"),
        TEXT.encode("utf-16-le"),
        TEXT.encode("utf-16-be"),
        TEXT.encode("cp1252"),
        TEXT.replace("\n", "\r\n").encode() + b"\x0c\r\n\x1a",
        TEXT.replace("\n", "\r").encode(),
    ],
)
def test_encodings_and_line_ends_of_real_files(data: bytes) -> None:
    source = decode(data, "test.v2")
    assert isinstance(source, SourceFile)
    compilation = compile_source(source)
    assert compilation.diagnostics == ()
    assert compilation.module is not None
    assert compilation.module.programs["main"].steps == (0,)


def test_a_json_file_is_named_for_what_it_is_not() -> None:
    assert codes(compile_text('{\n "a": 1,\n "b": [1, 2],\n "c": "d"\n}\n')) == ["V104"]


def test_parentheses_nest_two_hundred_deep_and_no_deeper() -> None:
    def program(depth: int) -> str:
        return f".PROGRAM main\nx={'-(' * (depth // 2)}1{')' * (depth // 2)}\n.END\n"

    assert "V113" not in codes(compile_text(program(160)))
    deep = ".PROGRAM main\nx=" + "(" * 201 + "\n.END\n"
    assert [c for c in codes(compile_text(deep)) if c != "V106"] == ["V113"]


def test_a_line_that_is_too_long_is_one_diagnostic() -> None:
    text = ".PROGRAM main\nx = " + "(" * 3000 + "1" + ")" * 3000 + "\n.END\n"
    assert codes(compile_text(text)) == ["V105"]


@pytest.mark.thorough
def test_sixty_five_thousand_steps() -> None:
    text = ".PROGRAM main\n" + "        n = n+1\n" * 65_000 + ".END\n.REALS\nn 0\n.END\n"
    compilation = compile_text(text)
    assert compilation.diagnostics == ()
    assert compilation.module is not None
    assert len(compilation.module.programs["main"].instructions) == 65_001
    assert verify(compilation.module) == []


def test_programs_that_call_each_other_compile() -> None:
    text = ".PROGRAM a\nIF SIG(1001) GOTO 10\nCALL b\n10\n.END\n.PROGRAM b\nCALL a\n.END\n"
    compilation = compile_text(text)
    assert compilation.diagnostics == ()
    assert compilation.module is not None


def test_more_than_two_hundred_problems_are_counted() -> None:
    compilation = compile_text(".PROGRAM main\n" + "MOVEE a\n" * 500 + ".END\n")
    assert len(compilation.diagnostics) == 201
    assert compilation.diagnostics[-1].headline == "and 300 more problems"
