"""Locations, numbers and strings in the places of one another: one message, and what to write."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\nover 450 -120 -100 90 90 0\n.END\n"


def told(body: str, more: str = "") -> tuple[str, str, str]:
    """Return the headline and the help of the one message, and the program after its edits."""
    text = f".PROGRAM main\n{body}\n.END\n{more}{DATA}"
    (found,) = said(compiled(text))
    mended = with_edits(text, edits_of([found]))
    return found.headline, "; ".join(found.help), mended.split("\n.END")[0].partition("\n")[2]


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ("APPRO pick, over", "`APPRO pick, 50`"),
        ("DEPARTS pick", "`DEPARTS 50`"),
        ("MOVE pick\nIF pick > 300 THEN\nREADY\nEND", "`DZ(pick) > 300`"),
        ("IF pick == over THEN\nREADY\nEND", "`DISTANCE(pick, over) < 1`"),
        ("d = pick-over\nTYPE d", "`DISTANCE(pick, over)`"),
        ("z = pick+50\nTYPE z", "`SET z = SHIFT(pick BY 0, 0, 50)`"),
        ("TYPE SQRT(pick)", "`DZ(pick)`"),
        ("DRAW pick", "`MOVES pick`"),
        ("WAIT pick", "`BREAK`"),
        ('PROMPT "h", pick', "a name of its own"),
        ("MOVE pick\nFOR pick = 1 TO 3\nREADY\nEND", "`FOR i = 1 TO 3`"),
        ("h = 120\nMOVES h", "`DRAW 0, 0, h`"),
        ("h = 120\nSET p = h\nMOVE p", "`p = h`, without SET"),
        ("h = 5\nMOVE pick:h", "`SHIFT(pick BY 0, 0, h)`"),
    ],
)
def test_what_to_write_depends_on_the_place(body: str, help_: str) -> None:
    assert help_ in told(body)[1]


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("TYPE pick", "TYPE DX(pick), DY(pick), DZ(pick)"),
        ("d = 50\nAPPRO d, pick", "d = 50\nAPPRO pick, d"),
        ("n = 5\nAPPRO n, pick", "n = 5\nAPPRO pick, n"),
        ("SET n = 5\nTYPE n", "n = 5\nTYPE n"),
        ("n = 1\nSET n = n+1\nTYPE n", "n = 1\nn = n+1\nTYPE n"),
        ('SET $s = "a"\nTYPE $s', '$s = "a"\nTYPE $s'),
        ("HERE = start\nMOVE start", "HERE start\nMOVE start"),
        ("TOOL = pick", "TOOL pick"),
        ("MOVES pick + over", "MOVES pick:over"),
        ('MOVE "pick"', "MOVE pick"),
        ('DELAY "2"', "DELAY 2"),
        ('SPEED "50" ALWAYS', "SPEED 50 ALWAYS"),
        ('PROMPT "", $a\nDELAY $a', 'PROMPT "", $a\nDELAY VAL($a)'),
        ('PROMPT "", $a\nt = $a+10\nTYPE t', 'PROMPT "", $a\nt = VAL($a)+10\nTYPE t'),
        ('n = "5"\nDELAY n', "n = 5\nDELAY n"),
        ('name = "Ada"\nTYPE name', '$name = "Ada"\nTYPE $name'),
        ('t[1] = "a"\nTYPE t[1]', '$t[1] = "a"\nTYPE $t[1]'),
        ('b = "x"+5\nTYPE b', '$b = "x"+$ENCODE(5)\nTYPE $b'),
        ('PROMPT "", n\nIF n == "2" THEN\nEND', 'PROMPT "", n\nIF n == 2 THEN\nEND'),
        ('PROMPT "", $n\nIF $n > 2 THEN\nEND', 'PROMPT "", $n\nIF VAL($n) > 2 THEN\nEND'),
        ('PROMPT "", a\nIF a == "y" THEN\nEND', 'PROMPT "", $a\nIF $a == "y" THEN\nEND'),
        ("n = VAL(5)\nTYPE n", "n = 5\nTYPE n"),
        ("PAUSE 2", "DELAY 2"),
        ("z = pick.z\nTYPE z, pick.x", "z = DZ(pick)\nTYPE z, DX(pick)"),
    ],
)
def test_the_one_edit_writes_what_was_meant(body: str, after: str) -> None:
    assert told(body)[2] == after


@pytest.mark.parametrize(
    ("call", "help_"),
    [
        ("say(5)", '`CALL say("5")`'),
        ("say(pick)", "`$what` of `say($what)` is a string"),
        ("fetch(pick, over)", "is a distance in mm: write a number there"),
        ('fetch(pick, "60")', "`CALL fetch(pick, 60)`"),
        ('fetch("pick", 60)', "`CALL fetch(pick, 60)`"),
        ("fetch(60, pick)", "`CALL fetch(pick, 60)`"),
    ],
)
def test_arguments_are_told_with_the_call_to_write(call: str, help_: str) -> None:
    say = ".PROGRAM say($what)\nTYPE $what\n.END\n"
    fetch = ".PROGRAM fetch(where, high)\nAPPRO where, high\n.END\n"
    assert help_ in told(f"CALL {call}", say + fetch)[1]


def test_a_guess_about_a_name_is_no_sure_fix() -> None:
    """`vrts fix` leaves it alone; a value may be in the controller's memory."""
    (found,) = said(compiled(f".PROGRAM main\nTYPE pick.z\n.END\n{DATA}"))
    assert found.fix is not None
    assert not found.fix.sure
    (sure,) = said(compiled(f".PROGRAM main\nAPPRO 5, pick\n.END\n{DATA}"))
    assert sure.fix is not None
    assert sure.fix.sure
