"""Precedence: VAL-II's table, and the warning where the other table reads differently."""

import pytest

from vrts.base.source import SourceFile
from vrts.ir.dump import text_of
from vrts.ir.instructions import Assign
from vrts.lang.compiler import compile_source


def compiled(expression: str) -> tuple[str, list[str]]:
    text = f".PROGRAM main(a, b, c)\nx = {expression}\n.END\n"
    compilation = compile_source(SourceFile("test.v2", text))
    assert compilation.module is not None, compilation.diagnostics
    instruction = compilation.module.programs["main"].instructions[0]
    assert isinstance(instruction, Assign)
    unused = "V225"  # x is
    codes = [d.rule.code for d in compilation.diagnostics if d.rule.code != unused]
    return text_of(instruction.value), codes


@pytest.mark.parametrize(
    ("expression", "tree"),
    [
        ("1+2*3", "(1 + (2 * 3))"),
        ("10-4-3", "((10 - 4) - 3)"),
        ("2*-3", "(2 * (-3))"),
        ("-2*3", "((-2) * 3)"),
        ("NOT 1 AND 0", "((not 1) and 0)"),
        ("NOT -1", "(not (-1))"),
        ("- - 1", "(-(-1))"),
        ("--1", "(-(-1))"),
        ("1--1", "(1 - (-1))"),
        ("COM 33", "(com 33)"),
        ("1 =< 2", "(1 <= 2)"),
        ("2 BOR 1 BAND 3", "(2 bor (1 band 3))"),
        ("SIG(1001) OR (TIMER(1) > 5)", "(sig(1001) or (timer(1) > 5))"),
        ("1 OR 0 + 1", "((1 or 0) + 1)"),
        ("TRUE", "-1"),
        ("'A", "65"),
        ("^H23FF + ^377 + ^B1001", "((9215 + 255) + 9)"),
        (".5", "0.5"),
    ],
)
def test_tree(expression: str, tree: str) -> None:
    assert compiled(expression) == (tree, [])


@pytest.mark.parametrize(
    ("expression", "tree"),
    [
        ("1 == 1 AND 2 == 2", "((1 == (1 and 2)) == 2)"),
        ("1 OR 0 == 1", "((1 or 0) == 1)"),  # C28
        ("10 MOD 4*2", "((10 mod 4) * 2)"),
    ],
)
def test_where_the_tables_differ_a_warning_says_so(expression: str, tree: str) -> None:
    assert compiled(expression) == (tree, ["V150"])


def test_the_help_writes_the_parentheses() -> None:
    text = ".PROGRAM main(a, b)\nIF a == 1 AND b == 2 THEN\nREADY\nEND\n.END\n"
    (warning,) = compile_source(SourceFile("test.v2", text)).diagnostics
    assert warning.help == ("write parentheses: (a == 1) AND (b == 2)",)
    assert warning.fix is not None
    assert warning.fix.replacement == "(a == 1) AND (b == 2)"
