"""Steps that only VAL has."""

import pytest

from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import AS, VAL, Dialect


def compiled(step: str, dialect: Dialect = VAL) -> Compilation:
    text = f".PROGRAM main\n{step}\n10 DELAY 1\n.END\n"
    return compile_source(SourceFile("main.v2", text), Options(dialect))


def lines(step: str) -> str:
    module = compiled(step).module
    assert module is not None
    return dump(module)


@pytest.mark.parametrize("step", ["IFSIG 1,-2,, THEN 10", "IFSIG 1,-2 THEN 10"])
def test_signals_may_be_left_out(step: str) -> None:
    assert lines(step) == lines("IFSIG 1, -2 THEN 10")


def test_a_signal_between_others_may_be_left_out() -> None:
    assert lines("IFSIG 1,,-2 THEN 10") == lines("IFSIG 1, -2 THEN 10")


def test_one_signal_has_to_be_there() -> None:
    assert [d.rule.code for d in compiled("IFSIG , THEN 10").diagnostics] == ["V210"]


def test_go_is_a_word_of_val_and_short_for_goto_in_as() -> None:
    assert [d.rule.code for d in compiled("GO pick").diagnostics] == ["V161"]
    assert compiled("GO 10", AS).diagnostics == ()
