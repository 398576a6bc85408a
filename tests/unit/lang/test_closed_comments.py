"""Comments of other languages that end in the same line lose both their signs."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("{ pick it }", "; pick it"),
        ("/* pick it */", "; pick it"),
        ("(* pick it *)", "; pick it"),
        ("READY /* go home */", "READY ; go home"),
        ("// pick it */ then", "; pick it */ then"),
    ],
)
def test_both_signs_go(written: str, meant: str) -> None:
    text = f".PROGRAM main\n{written}\n.END\n"
    (one,) = compile_source(SourceFile("main.v2", text)).diagnostics
    assert one.fix is not None
    for edit in sorted(one.fix.edits, key=lambda e: -e.span.start):
        text = text[: edit.span.start] + edit.replacement + text[edit.span.end :]
    assert text == f".PROGRAM main\n{meant}\n.END\n"


def test_names_cut_to_one_are_told_where_they_stand_first() -> None:
    text = ".PROGRAM main\nconveyor_counter_left = 0\nconveyor_counter_right = 1\n"
    text += "TYPE conveyor_counter_left, conveyor_counter_right\n.END\n"
    found = compile_source(SourceFile("main.v2", text)).diagnostics
    (one,) = [d for d in found if d.rule.code == "V212"]
    assert one.primary is not None
    assert one.primary.span.start == text.index("conveyor_counter_left")
    assert [label.span.text for label in one.secondary] == ["conveyor_counter_right"]
