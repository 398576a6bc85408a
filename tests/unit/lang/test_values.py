"""What is known of numbers before a run also mends: the edits, and limits of what is followed."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source

MENDED = [
    ("READY; OPENI", "READY\nOPENI"),
    ("x = SQRT(2,25)", "x = SQRT(2.25)"),
    ("FOR n = 3 TO 1", "FOR n = 3 TO 1 STEP -1"),
    ("TYPE SIN(PI/2)", "TYPE SIN(90)"),
    ("WAIT SIG(1001) == 1", "WAIT SIG(1001)"),
    ('TYPE "n = "+5', 'TYPE "n = ", 5'),
]


@pytest.mark.parametrize(("wrong", "right"), MENDED)
def test_the_edit_makes_what_was_meant(wrong: str, right: str) -> None:
    closed = "\nEND" if wrong.startswith("FOR") else ""
    text = f".PROGRAM main\n{wrong}{closed}\n.END\n"
    (fix,) = [d.fix for d in compile_source(SourceFile("main.v2", text)).diagnostics if d.fix]
    mended = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
    assert mended == f".PROGRAM main\n{right}{closed}\n.END\n"
    assert all(d.fix is None for d in compile_source(SourceFile("main.v2", mended)).diagnostics)


def test_many_variables_and_loops_are_followed_in_little_time() -> None:
    names = [f"n{k}" for k in range(50)]
    body = "\n".join(f"{a} = {b}+1" for a, b in zip(names[1:], names, strict=False))
    loops = "\n".join(f"WHILE {name} < 5 DO\n{body}\nEND" for name in names)
    text = f".PROGRAM main\nn0 = 0\n{body}\n{loops}\nTYPE 1/(n49-n48-1)\n.END\n"
    assert compile_source(SourceFile("main.v2", text)).module is not None
