"""Every instruction with every kind of operand, right or wrong: the compiler always answers."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

COMMAS = "x = 1.200,5\nDRAW 0,0,12,5"  # a habit makes the compiler look at other lines, too
BARE = ("", ",")
OTHERS = ("x", "12,5", "p", "1,2,5,3", '"a"', "(1)", "#p", "$s", ":a", "1 2", "-", "BY", "[1]")
DIALECT = pytest.mark.parametrize("dialect", DIALECTS.values(), ids=list(DIALECTS))


@DIALECT
@pytest.mark.parametrize("operands", BARE)
def test_words_without_operands(dialect: Dialect, operands: str) -> None:
    compile_all(dialect, operands)


@pytest.mark.thorough
@DIALECT
def test_words_with_operands_of_every_kind(dialect: Dialect) -> None:
    for operands in OTHERS:
        compile_all(dialect, operands)


def compile_all(dialect: Dialect, operands: str) -> None:
    """Compile a file with a program for each instruction; most are wrong, and that is told."""
    programs = [("main", COMMAS)]
    programs += [(f"q{i}(mm)", f"{word} {operands}") for i, word in enumerate(INSTRUCTIONS)]
    text = "".join(f".PROGRAM {name}\n{body}\n.END\n" for name, body in programs)
    found = compile_source(SourceFile("every.v2", text), Options(dialect))
    assert found.module is None
    assert any(one.is_error for one in found.diagnostics)
