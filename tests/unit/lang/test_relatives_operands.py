"""Operands of V+ and AS of another kind or in another order, and what other languages write."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.lang.dialect import AS, VPLUS, Dialect

HEAD = '.PROGRAM main()\nPOINT part = TRANS(1)\nn = 1\nm = 2\n$s = "a"\n'
FOOT = "\nPRINT n, m, $s\nCALL watch(n)\n.END\n.PROGRAM watch(.a)\nPRINT .a\n.END\n"
HEAD_VPLUS = HEAD.replace("POINT", "SET")
FOOT_VPLUS = FOOT.replace("PRINT", "TYPE").replace(".a", "a")


def told(body: str, dialect: Dialect) -> list[Diagnostic]:
    """Return what is said of some steps within a program that is right, but for the simulator."""
    text = f"{HEAD}{body}{FOOT}" if dialect is AS else f"{HEAD_VPLUS}{body}{FOOT_VPLUS}"
    found = said(compiled(text, dialect))
    return [d for d in found if not d.headline.endswith("is not simulated")]


def mended(body: str, dialect: Dialect) -> str:
    """Return what stands in the place of some steps after the one edit about them."""
    (found,) = told(body, dialect)
    assert found.primary is not None
    text = with_edits(found.primary.span.source.text, edits_of([found]))
    head, foot = (HEAD, FOOT) if dialect is AS else (HEAD_VPLUS, FOOT_VPLUS)
    return text.removeprefix(head).removesuffix(foot)


@pytest.mark.parametrize(
    ("step", "instead"),
    [
        ("TWAIT SIG(1008)", "WAIT SIG(1008)"),
        ("STABLE NOT SIG(1008)", "WAIT NOT SIG(1008)"),
        ("TWAIT 1008", "SWAIT 1008"),
        ("DLYSIG 0.5, 3", "DLYSIG 3, 0.5"),
        ("PULSE 0.2, 14", "PULSE 14, 0.2"),
        ("SWAIT SIG(1001), SIG(1002)", "SWAIT 1001, 1002"),
        ("SWAIT n == 2", "WAIT n == 2"),
        ("ONI SIG(1003) CALL watch", "ONI 1003 CALL watch"),
        ("XMOVE part TILL SIG(1001)", "XMOVE part TILL 1001"),
        ("XMOVE part, 1001", "XMOVE part TILL 1001"),
        ("SETHOME #rest, 10", "SETHOME 10, #rest"),
        ("UTIMER cure = 0", "UTIMER @cure = 0"),
        ("DRAW part", "LMOVE part"),
        ("ACCEL 80, 50 ALWAYS", "ACCEL 80 ALWAYS\nDECEL 50 ALWAYS"),
        ("CALL $s", "SCALL $s"),
        ("IF SIG[1004] THEN\nHOME\nEND", "IF SIG(1004) THEN\nHOME\nEND"),
        ("n = INT($s)", "n = VAL($s)"),
        ('IF "b" IN $s THEN\nHOME\nEND', 'IF (INSTR($s, "b") > 0) THEN\nHOME\nEND'),
        ("$s = $s[0:3]", "$s = $MID($s, 1, 3)"),
        ('IF $s.equals("R") THEN\nHOME\nEND', 'IF $s == "R" THEN\nHOME\nEND'),
        ("n > 2 THEN\nHOME\nEND", "IF n > 2 THEN\nHOME\nEND"),
        (",m = n+1", ".m = n+1"),
        ("SIGNAL 9, 10,", "SIGNAL 9, 10"),
        ("TWAIT 0..5", "TWAIT 0.5"),
        ("JMOVE # park", "JMOVE #park"),
        ("WAIT TIMER(1) == 3", "WAIT TIMER(1) >= 3"),
        ("DO\nn = n+1\nUNTIL n == 9 THEN", "DO\nn = n+1\nUNTIL n == 9"),
        ("CIRC part, goal", "C1MOVE part\nC2MOVE goal"),
        ("ClkReset clock1", "TIMER 1 = 0"),
    ],
)
def test_steps_of_as_are_mended(step: str, instead: str) -> None:
    wanted = instead.replace(",m", ".m")
    assert mended(step, AS) == wanted


@pytest.mark.parametrize(
    ("step", "instead"),
    [
        ("DELAY SIG(1001)", "WAIT SIG(1001)"),
        ("WAIT.EVENT 0.5", "WAIT.EVENT , 0.5"),
        ("REACTI SIG(1001), watch", "REACTI 1001, watch"),
        ("OPENI 1", "OPENI"),
        ("CALL $s", "CALLS $s"),
        (
            "ON n GOTO 10, 20\n10 READY\n20 READY",
            "IF n == 1 GOTO 10\nIF n == 2 GOTO 20\n10 READY\n20 READY",
        ),
        ("IF n B_AND 1 THEN\nREADY\nEND", "IF n BAND 1 THEN\nREADY\nEND"),
        ("n = m << 2", "n = m*4"),
        ("IF n IN (1, 2) THEN\nREADY\nEND", "IF ((n == 1) OR (n == 2)) THEN\nREADY\nEND"),
        ("[n, m] = watch($s)", "CALL watch($s, n, m)"),
        ("CALL watch(&n)", "CALL watch(n)"),
        ("CALLwatch(n)", "CALL watch(n)"),
        ("n = atoi($s)", "n = VAL($s)"),
        ('IF strcmp($s, "a") == 0 THEN\nREADY\nEND', 'IF $s == "a" THEN\nREADY\nEND'),
        ("IF get_digital_in(3) THEN\nREADY\nEND", "IF SIG(1003) THEN\nREADY\nEND"),
        ("n = pow(m, 2)", "n = SQR(m)"),
        ("SPEED 50 ,ALWAYS", "SPEED 50 ALWAYS"),
        ("SET part = SHIFT(BY part, 0, 0, 80)", "SET part = SHIFT(part BY 0, 0, 80)"),
        ("SETI n = 0", "n = 0"),
        ("MOVE part[1)", "MOVE part[1]"),
    ],
)
def test_steps_of_vplus_are_mended(step: str, instead: str) -> None:
    found = told(step, VPLUS)[0]
    assert found.primary is not None
    text = with_edits(found.primary.span.source.text, edits_of([found]))
    assert text == f"{HEAD_VPLUS}{instead}{FOOT_VPLUS}"


@pytest.mark.parametrize(
    ("step", "says"),
    [
        ("HOME 3", "two homes"),
        ("C2MOVE part, goal", "one location"),
        ("OPENI gripper", "number of a clamp"),
        ("LDEPART part", "a distance"),
        ("LAPPRO part, part", "a distance"),
        ("SIGNAL 0.5", "whole number"),
        ('CASE n OF\nVALUE 1:\nHOME\nVALUE "2":\nHOME\nEND', "compares numbers"),
        ("FOR n = 1 TO 3\nIF SIG(1) THEN\nNEXT\nEND\nHOME\nEND", "NEXT"),
    ],
)
def test_what_is_wrong_is_said_once(step: str, says: str) -> None:
    (found,) = told(step, AS)
    assert says in found.headline


@pytest.mark.parametrize(
    ("step", "dialect"),
    [
        ("TWAIT n", AS),
        ("HOME 2", AS),
        ("HOME n", AS),
        ("LMOVE part, 1", AS),
        ("LMOVE part, n", AS),
        ("C1MOVE part, -n", AS),
        ("PULSE 3, 0.5", AS),
        ("DLYSIG n, m", AS),
        ("SWAIT -1001, 1002", AS),
        ("SETHOME 10, #rest", AS),
        ("UTIMER @cure = 0", AS),
        ("DRAW n", AS),
        ("ACCEL 80 ALWAYS", AS),
        ("CALL watch(&n)", AS),
        ("POINT part = -part", AS),
        ("WAIT.EVENT 1", VPLUS),
        ("WAIT.EVENT , n", VPLUS),
        ("DELAY n", VPLUS),
        ("ACCEL 80, 50", VPLUS),
        ("OPENI", VPLUS),
    ],
)
def test_what_is_right_is_let_be(step: str, dialect: Dialect) -> None:
    assert [d.headline for d in told(step, dialect)] == []


def test_a_call_of_as_hands_over_as_many_as_the_program_takes() -> None:
    """What is left out is a mismatch there [AS manual, P0137]; V+ lets it be undefined."""
    text = ".PROGRAM main()\nCALL put(1)\n.END\n.PROGRAM put(.a, .b)\n.b = .a\nPRINT .b\n.END\n"
    (found,) = said(compiled(text, AS))
    assert "takes 2 arguments, 1 given" in found.headline
    assert any("P0137" in note for note in found.notes)
    assert (
        said(compiled(text.replace(".a", "a").replace(".b", "b").replace("PRINT", "TYPE"), VPLUS))
        == []
    )
