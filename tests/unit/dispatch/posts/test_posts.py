"""What steps become in other languages."""

from pathlib import Path

import pytest

from tests.support_programs import ROOT
from vrts.base.source import SourceFile
from vrts.dispatch.posts.post import Settled
from vrts.dispatch.posts.written import Written, written
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS

READY = Settled((0.0, -90.0, 90.0, 0.0, 0.0, 0.0))
PLACES = "a 900 200 100 90 90 0\nb 900 -200 100 90 90 0\n#p 0 -90 90 0 0 0\n"


def said(steps: str, target: str, dialect: str = "val2", more: str = "") -> Written:
    """Return a program with these steps in another language."""
    text = f".PROGRAM main\n{steps}\n.END\n{more}.LOCATIONS\n{PLACES}.END\n"
    compilation = compile_source(SourceFile("main.v2", text), Options(DIALECTS[dialect]))
    assert compilation.module is not None, compilation.diagnostics
    return written(compilation, target, READY)


def steps_in(text: str) -> str:
    """Return the steps of the first program, without blanks at the ends."""
    body = text.split(".END")[0].split("\n")[1:]
    return "\n".join(line.strip() for line in body if line.strip())


@pytest.mark.parametrize(
    ("step", "vplus", "kawasaki"),
    [
        ("MOVE a", "MOVE a", "JMOVE a"),
        ("MOVES a", "MOVES a", "LMOVE a"),
        ("APPROS a:b, 50", "APPROS a:b, 50", "LAPPRO a+b, 50"),
        ("DEPART 20+30", "DEPART 20+30", "JDEPART 20+30"),
        ("READY", "READY", "JMOVE #PPOINT(0,-90,90,0,0,0)"),
        ("MOVET a, 30", "MOVET a, 30", "OPEN\nJMOVE a"),
        ("MOVEST a, 0", "MOVEST a, 0", "CLOSE\nLMOVE a"),
        ("DRAW 10,,20", "MOVES SHIFT(DEST BY 10,,20)", "DRAW 10,,20"),
        ("GRASP 20, 10\n10 OPENI", "CLOSEI\nIF HAND < 20 GOTO 10\n10      OPENI", None),
        ("FLIP", "FLIP", "DWRIST"),
        ("COARSE ALWAYS", "COARSE ALWAYS", "ACCURACY 10 ALWAYS"),
        ("FINE", "FINE", "ACCURACY 1"),
        ("SPEED 200 MMPS ALWAYS", "SPEED 200 MMPS ALWAYS", "SPEED 200 MM/S ALWAYS"),
        ("SPEED 2+3 IPS", "SPEED 2+3 IPS", "SPEED (2+3)*25.4 MM/S"),
        ("SET c = a:INVERSE(b)", "SET c = a:INVERSE(b)", "POINT c = a-b"),
        ("SET c = INVERSE(a:b)", "SET c = INVERSE(a:b)", "POINT c = (-(a+b))"),
        (
            "SET c = TRANS(1,2,3,90,-90,15)",
            "SET c = TRANS(1,2,3,0,0,15)",
            "POINT c = TRANS(1,2,3,0,0,15)",
        ),
        (
            "SET c = TRANS(1,,,x,,x*2)",
            "SET c = TRANS(1,,,x-90,90,x*2)",
            "POINT c = TRANS(1,,,x-90,90,x*2)",
        ),
        ("SET c = TRANS(1)", "SET c = TRANS(1)", "POINT c = TRANS(1)"),
        ("BASE 10,,,30", "BASE 10,,,30", "BASE -TRANS(10,0,0,30,0,0)"),
        ("y = ^17+x", "y = 15+x", "y = 15+x"),
        ("y = x AND x == 2", "y = x AND x == 2", "y = (x AND x) == 2"),
        ("y = x == 2 AND x", "y = x == 2 AND x", "y = x == (2 AND x)"),
        ("y = (x == 2) AND x", "y = (x == 2) AND x", "y = (x == 2) AND x"),
        ("y = SQR(x+1)", "y = SQR(x+1)", "y = ((x+1)*(x+1))"),
        ("y = MAX(x,1)", "y = MAX(x,1)", "y = MAXVAL(x,1)"),
        ('y = POS("a,c",",")', 'y = POS("a,c",",")', 'y = INSTR(1,"a,c",",")'),
        ("y = SIGN(x)", "y = SIGN(x)", "y = ((x < 0)*2+1)"),
        ("REACTI 1001, halt1, 5", "REACTI 1001, halt1, 5", "ONI 1001 CALL halt1, 5"),
        ('TYPE "x", /F5.1, x', 'TYPE "x", /F5.1, x', 'PRINT "x", /F5.1, x'),
        ("INTOFF ALWAYS\nMOVE a", "; INTOFF ALWAYS\nMOVE a", "; INTOFF ALWAYS\nJMOVE a"),
    ],
)
def test_a_step_in_other_languages(step: str, vplus: str, kawasaki: str | None) -> None:
    more = ".PROGRAM halt1\nHALT\n.END\n"
    begun = f"x = 3\n{step}"
    for target, wanted in (("vplus", vplus), ("as", kawasaki)):
        if wanted is None:
            continue
        text, told = said(begun, target, more=more)
        assert not [d for d in told if d.is_error]
        assert steps_in(text) == f"x = 3\n{wanted}", target


@pytest.mark.parametrize(
    ("step", "target", "headline"),
    [
        ("IOPUT 1 = 2", "vplus", "V+ has nothing that means IOPUT"),
        ("PCABORT", "vplus", "V+ has nothing that means PCABORT"),
        ("ENABLE CP", "as", "AS has nothing that means ENABLE"),
        ("PARAMETER HAND.TIME = 1", "as", "AS has nothing that means PARAMETER"),
        ("REACT 1001, main", "as", "AS has nothing that means REACT"),
        ("REACTI 1001", "as", "AS has nothing that means REACTI without a program"),
        ("home = 3", "as", "`home` is a word of AS"),
        ("y = BCD(3)", "as", "AS has nothing that means BCD"),
        ("y = SQR(RANDOM)", "as", "AS has no SQR, and its argument is a function"),
        ("SPEED 5 IPS\ny = SPEED(3)", "as", "SPEED would yield mm/s where it yields inches a"),
        ("y = HAND", "as", "AS has nothing that means HAND"),
        ("GRASP 20, 10\n10 OPENI", "as", "AS has nothing that means GRASP"),
        ('y = POS("abc", "b")', "as", "AS looks for strings whatever the case"),
        ("y = ADC(1)", "vplus", "V+ has nothing that means ADC"),
    ],
)
def test_what_cannot_be_written_is_refused_at_its_place(
    step: str, target: str, headline: str
) -> None:
    _, told = said(step, target)
    (found,) = [d for d in told if d.is_error]
    assert found.rule.code == "V860"
    assert found.headline.startswith(headline)
    assert found.help
    assert found.primary is not None
    span = found.primary.span
    assert span.source.text[span.start : span.end] in step


def test_powers_of_relatives_are_refused_for_val2() -> None:
    _, told = said("x = 2\ny = x**2", "val2", "vplus")
    assert [d.headline for d in told] == ["VAL-II has no `**`"]


def test_all_that_cannot_be_written_is_told_at_once() -> None:
    _, told = said("ENABLE CP\nMOVE a\nDISABLE CP", "as")
    assert [d.headline.split()[-1] for d in told] == ["ENABLE", "DISABLE"]


def test_what_is_left_out_is_told_once_with_its_places() -> None:
    _, told = said("NONULL ALWAYS\nMOVE a\nNONULL", "as")
    (found,) = told
    assert (found.rule.code, found.is_error) == ("V861", False)
    assert len(found.secondary) == 1


def test_comments_labels_and_blank_lines_stay() -> None:
    text, _ = said("; how it begins\n\n10 MOVE a  ; over there\nGOTO 10", "as")
    body = text.split(".END")[0].split("\n")[1:-1]
    assert body == ["; how it begins", "", "10      JMOVE a  ; over there", "        GOTO 10"]


def test_comments_before_a_program_move_into_it() -> None:
    text = "; by Anna\n.PROGRAM main\nREADY\n.END\n; the other one\n.PROGRAM two\n.END\n"
    compilation = compile_source(SourceFile("main.v2", text), Options(DIALECTS["val2"]))
    found = written(compilation, "vplus", READY).text
    assert found.startswith(
        ".PROGRAM main()\n; by Anna\n        READY\n.END\n.PROGRAM two()\n; the"
    )


def test_locations_that_are_passed_are_marked_in_as() -> None:
    more = ".PROGRAM carry(p, #q, n)\nMOVE p\nDEPART n\nMOVE #q\n.END\n"
    text, _ = said("CALL carry(a:b, #p, 5)\nCALL carry(a, #p, n)", "as", more="" + more)
    assert ".PROGRAM carry(.&p, .&#q, .n)\n        JMOVE .p\n        JDEPART .n" in text
    assert steps_in(text) == (
        "POINT .passed.1 = a+b\nCALL carry(.&passed.1, &#p, 5)\nCALL carry(&a, &#p, n)"
    )


def test_a_subroutine_in_as_leaves_the_variables_of_its_caller_alone() -> None:
    more = '.PROGRAM count(n, $s)\nAUTO k\nk = n+1\nn = 0\n$s = $s + "!"\nTYPE k, n, $s\n.END\n'
    text, told = said('n = 7\nk = 8\nCALL count(3, "a")\nTYPE n, k', "as", "vplus", more)
    assert not told
    assert ".PROGRAM count(.n, .$s)\n; AUTO k\n        .k = .n+1\n        .n = 0\n" in text
    assert steps_in(text) == 'n = 7\nk = 8\nCALL count(3,"a")\nPRINT n, k'
    compilation = compile_source(SourceFile("main.as", text), Options(DIALECTS["as"]))
    assert not [d for d in compilation.diagnostics if d.is_error]


def test_angles_of_locations_become_those_of_the_language() -> None:
    text, _ = said("MOVE a", "vplus")
    assert "a               900.0000 200.0000 100.0000 0.0000 180.0000 0.0000" in text
    text, _ = said("MOVE a", "as")
    assert ".TRANS\na " in text
    assert ".JOINTS\n#p " in text


def test_vplus_comes_back_as_val2() -> None:
    for place in sorted((ROOT / "examples").glob("*/solution.v2")):
        first = _written(place, "val2", "val2")
        plus = _written(place, "val2", "vplus")
        again = compile_source(SourceFile("plus", plus), Options(DIALECTS["vplus"]))
        assert written(again, "val2", READY).text == first


def _written(place: Path, dialect: str, target: str) -> str:
    source = SourceFile(place.name, place.read_text(encoding="utf-8"))
    return written(compile_source(source, Options(DIALECTS[dialect])), target, READY).text
