"""What steps become in other languages."""

from pathlib import Path

import pytest

from tests.support_programs import ROOT
from vrts.base.pose import translation
from vrts.base.source import SourceFile
from vrts.dispatch.posts.expressions_anew import Settled, Start
from vrts.dispatch.posts.other_arm import SAME, OtherArm
from vrts.dispatch.posts.written import Written, written
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS

READY = Settled((0.0, -90.0, 90.0, 0.0, 0.0, 0.0))
HOLDS = READY._replace(arm=SAME._replace(holds=1004))
PLACES = "a 900 200 100 90 90 0\nb 900 -200 100 90 90 0\n#p 0 -90 90 0 0 0\n"


def said(
    steps: str, target: str, dialect: str = "val2", more: str = "", settled: Settled = READY
) -> Written:
    """Return a program with these steps in another language."""
    text = f".PROGRAM main\n{steps}\n.END\n{more}.LOCATIONS\n{PLACES}.END\n"
    compilation = compile_source(SourceFile("main.v2", text), Options(DIALECTS[dialect]))
    assert compilation.module is not None, compilation.diagnostics
    return written(compilation, target, settled)


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
        ("READY", "MOVE #PPOINT(0,-90,90,0,0,0)", "JMOVE #PPOINT(0,-90,90,0,0,0)"),
        ("MOVET a, 30", "MOVET a, 30", "OPEN\nJMOVE a"),
        ("MOVEST a, 0", "MOVEST a, 0", "CLOSE\nLMOVE a"),
        ("DRAW 10,,20", "MOVES SHIFT(DEST BY 10,,20)", "DRAW 10,,20"),
        (
            "GRASP 20, 10\n10 OPENI",
            "CLOSEI\nIF SIG(-1004) GOTO 10\n10      OPENI",
            "CLOSEI\nIF SIG(-1004) GOTO 10\n10      OPENI",
        ),
        ('HALT "over"', 'TYPE "over"\nHALT', 'PRINT "over"\nHALT'),
        (
            "CASE x OF\nVALUE 1:\nMOVE a\nANY\nMOVE b\nEND",
            "CASE x OF\nVALUE 1:\nMOVE a\nANY\nMOVE b\nEND",
            "CASE x OF\nVALUE 1:\nJMOVE a\nANY:\nJMOVE b\nEND",
        ),
        ("DISABLE CP", "DISABLE CP", "cp OFF"),
        ("TOOL a", "TOOL a", "TOOL a"),
        (
            "TOOL TRANS(0,0,20,90,-90,0)",
            "TOOL TRANS(0,0,20,0,0,0)",
            "POINT .new.tool = TRANS(0,0,20,0,0,0)\nTOOL .new.tool",
        ),
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
        (
            "BASE 10,,,30",
            "BASE 10,,,30",
            "POINT .new.base = -TRANS(10,0,0,30,0,0)\nBASE .new.base",
        ),
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
def test_a_step_in_other_languages(step: str, vplus: str, kawasaki: str) -> None:
    more = ".PROGRAM halt1\nHALT\n.END\n"
    begun = f"x = 3\n{step}"
    for target, wanted in (("vplus", vplus), ("as", kawasaki)):
        text, told = said(begun, target, more=more, settled=HOLDS)
        assert not [d for d in told if d.is_error]
        assert steps_in(text) == f"x = 3\n{wanted}", target


@pytest.mark.parametrize(
    ("step", "target", "headline"),
    [
        ("IOPUT 1 = 2", "vplus", "V+ has nothing that means IOPUT"),
        ("PCABORT", "vplus", "V+ has nothing that means PCABORT"),
        ("ENABLE DRY.RUN", "as", "AS has nothing that means the switch DRY.RUN"),
        ("GRASP 20, 10\n10 OPENI", "vplus", "V+ has nothing that means GRASP"),
        ("PARAMETER HAND.TIME = 1", "as", "AS has nothing that means PARAMETER"),
        ("REACT 1001, main", "as", "AS has nothing that means REACT"),
        ("REACTI 1001", "as", "AS has nothing that means REACTI without a program"),
        ("home = 3", "as", "`home` is a word of AS"),
        ("y = BCD(3)", "as", "AS has nothing that means BCD"),
        ("y = SQR(RANDOM)", "as", "AS has no SQR, and its argument is a function"),
        ("SPEED 5 IPS\ny = SPEED(3)", "as", "SPEED would yield mm/s where it yields inches a"),
        ("OPENI 50", "as", "AS has nothing that means OPENI with a distance"),
        ("WAIT", "as", "AS has nothing that means WAIT without a condition"),
        ("SET c = SCALE(a BY 0.9)", "as", "AS has nothing that means SCALE"),
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
    _, told = said("PARAMETER HAND.TIME = 1\nMOVE a\nREACT 1001, main", "as")
    assert [d.headline.split()[-1] for d in told] == ["PARAMETER", "REACT"]


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
        ".PROGRAM main()\n; by Anna\n        MOVE #PPOINT(0,-90,90,0,0,0)\n.END\n"
        ".PROGRAM two()\n; the"
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


def test_tool_and_base_are_set_where_the_program_begins_and_nowhere_else() -> None:
    settled = READY._replace(start=Start("main", translation(0.0, 0.0, 0.15)))
    more = ".PROGRAM two\nMOVE a\n.END\n"
    text, told = said("; first\nMOVE a\nCALL two", "as", more=more, settled=settled)
    assert not told
    assert steps_in(text) == (
        "; first\nPOINT .begin.tool = TRANS(0,0,150,0,0,0)\nTOOL .begin.tool\nBASE NULL\n"
        "JMOVE a\nCALL two"
    )
    assert text.count("TOOL") == 1
    text, _ = said("AUTO n\nn = 1\nMOVE a", "vplus", "vplus", settled=settled)
    assert steps_in(text) == "AUTO n\nTOOL TRANS(0,0,150,0,0,0)\nBASE 0, 0, 0, 0\nn = 1\nMOVE a"
    _, told = said("IF x THEN\nCALL main\nEND", "as", settled=settled)
    assert [d.headline.split(",")[0] for d in told if d.is_error] == [
        "the program that is executed is called too"
    ]


def test_joint_values_become_those_of_the_other_arm_or_are_refused() -> None:
    arm = OtherArm("other", (1, 3, 2, 4, 5, 6), (1, -1, 1, 1, -1, 1), (0, 5, -90, 0, 0, 10.5))
    steps = "READY\nMOVE #PPOINT(1,2,x+1,,x)\nDRIVE 3, 20-x, 50\nDRIVE 2, 5\nMOVE #p"
    text, told = said(f"x = 1\n{steps}", "as", settled=READY._replace(arm=arm))
    assert not told
    assert steps_in(text).split("\n")[1:] == [
        "JMOVE #PPOINT(0,-85,-180,0,0,10.5)",
        "JMOVE #PPOINT(1,5-(x+1),-88,0,-x,10.5)",
        "DRIVE 2, -(20-x), 50",
        "DRIVE 3, 5",
        "JMOVE #p",
    ]
    assert "#p              0.0000 -85.0000 -180.0000 0.0000 0.0000 10.5000" in text
    _, told = said(f"x = 1\n{steps}", "as", settled=READY._replace(arm=None))
    places = [d.primary.span.text for d in told if d.is_error and d.primary is not None]
    assert places[:4] == ["READY", "#PPOINT(1,2,x+1,,x)", "DRIVE 3, 20-x, 50", "DRIVE 2, 5"]
    assert places[4].startswith("#p")
    assert {d.headline for d in told} == {"how the other arm counts its joints is not known"}


def test_numbers_and_strings_of_data_stand_behind_an_equals_sign_in_as() -> None:
    more = '.REALS\nn 3\n.END\n.STRINGS\n$s "a"\n.END\n'
    text, _ = said("x = n\nTYPE $s", "as", more=more)
    assert ".REALS\nn = 3\n.END" in text
    assert '.STRINGS\n$s = "a"\n.END' in text


def test_what_only_relatives_have_is_refused_or_said_otherwise() -> None:
    for step, target, headline in (
        ("IFSIG 1001 THEN 10\n10 READY", "as", "AS has nothing that means IFSIG"),
        ("RETURN 1", "as", "AS has nothing that means RETURN that skips steps"),
        ("PULSE 7", "as", "AS has nothing that means PULSE without a time"),
        ("REACT 1001, main ALWAYS", "vplus", "V+ has nothing that means REACT ALWAYS"),
        ("DRAW 1,2,3,4", "vplus", "V+ has nothing that means DRAW that turns"),
    ):
        _, told = said(step, target, "val2+")
        assert next(d.headline for d in told if d.is_error).startswith(headline)
    text, _ = said("x = 2\ny = (-x)**2\nACCEL 50, 70 ALWAYS", "as", "vplus")
    assert steps_in(text) == "x = 2\ny = (-x)^2\nACCEL 50 ALWAYS\nDECEL 70 ALWAYS"
    text, _ = said("x = 2\ny = MAXVAL(x, 1)", "vplus", "val2+")
    assert steps_in(text) == "x = 2\ny = MAX(x,1)"
