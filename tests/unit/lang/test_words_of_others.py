"""Words of other robots and languages: what VAL-II has for each, as students type them."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

DATA = ".LOCATIONS\npart 450 -120 -250 90 90 0\n.END\n"


def told(step: str) -> tuple[str, str]:
    """Return the help of the only message, and the steps after its edits."""
    text = f'.PROGRAM main\nn = 1\nMOVE part\n{step}\nTYPE "n", n\n.END\n{DATA}'
    (found,) = said(compiled(text))
    mended = with_edits(text, edits_of([found])).partition("MOVE part\n")[2]
    return "; ".join(found.help), mended.partition("\nTYPE")[0]


@pytest.mark.parametrize(
    ("step", "meant"),
    [
        ('TPReadNum n, "How many?"', 'PROMPT "How many?", n'),
        ('TPWrite "Count: " \\Num:=n', 'TYPE "Count: ", n'),
        ("SetDO do4, high", "SIGNAL 4"),
        ("ClkReset clock1", "TIMER 1 = 0"),
        ("CONST num height := 50", "height = 50"),
        ("MOVE part z10", "MOVE part"),
        ("MOVE part CNT100", "MOVE part"),
        ("SLIN part", "MOVES part"),
        ("DECL REAL x = 3.5", "x = 3.5"),
        ("set_digital_out(n, True)", "SIGNAL n"),
        ("message[Part done]", 'TYPE "Part done"'),
        ("wait.event , 4", "DELAY 4"),
        ("UWRIST", "NOFLIP"),
        ("CPON", "ENABLE CP"),
        ("SWAIT 1001, 1002", "WAIT SIG(1001, 1002)"),
        ('print("n: " + str(n))', 'TYPE "n: ", n'),
        ('printf("n = %d\\n", n)', 'TYPE "n = ", n'),
        ('System.out.println("n = " + n)', 'TYPE "n = ", n'),
        ("gripper.close()", "CLOSEI"),
        ('"""Stack four plates"""', ";Stack four plates"),
        ("tic", "TIMER 1 = 0"),
        ("inc(n, 2)", "n = n+2"),
        ("n //= 2", "n = INT(n/2)"),
        ("sys.exit(0)", "HALT"),
        ("SET frame = part TRANS(1,2,3,90,-90,0)", "SET frame = part:TRANS(1,2,3,90,-90,0)"),
        ("SET #t = 0, -90, 90, 0, 30, 0", "SET #t = #PPOINT(0, -90, 90, 0, 30, 0)"),
        ("$r = ASC(64+n)", "$r = $CHR(64+n)"),
        ("PARAMETER HAND.TIME = 500", "PARAMETER HAND.TIME = 0.5"),
    ],
)
def test_what_is_certain_has_an_edit(step: str, meant: str) -> None:
    """The edit makes the step that was meant."""
    _, mended = told(step)
    assert mended == meant


@pytest.mark.parametrize(
    ("step", "help_"),
    [
        ("heights.append(n)", "`heights[i] = n`"),
        ("DLYSIG 5, 2", "`WAIT TIMER(1) >= 2` and `SIGNAL 5`"),
        ("PULSE 3, 0.5", "`SIGNAL 3`, `DELAY 0.5`, `BREAK`, `SIGNAL -3`"),
        ("MoveL part, v200, fine, tool0", "`SPEED 200 MMPS`"),
        ("sync()", "leave it out"),
        ("stopj(2)", "BRAKE"),
        ("speedl([0,0,0.1,0,0,0], 0.5, 2)", "DRAW"),
        ("WAIT.EVENT 2, 4", "`DELAY 4`"),
    ],
)
def test_what_is_not_certain_is_said_in_words(step: str, help_: str) -> None:
    """The help names what VAL-II has, and nothing is changed."""
    said_so, mended = told(step)
    assert help_ in said_so
    if "leave it out" not in help_:
        assert mended == step


def test_labels_by_a_number_become_one_jump_each() -> None:
    """`ON n GOTO 10, 20` of BASIC."""
    text = f'.PROGRAM main\nn = 1\nON n GOTO 10, 20\n10 MOVE part\n20 TYPE "n", n\n.END\n{DATA}'
    (found,) = said(compiled(text))
    mended = with_edits(text, edits_of([found]))
    assert "IF n == 1 GOTO 10\nIF n == 2 GOTO 20\n10 MOVE" in mended


def test_an_interrupt_of_krl_becomes_reacti() -> None:
    """The input is counted from 1001, and the program is named."""
    text = (
        ".PROGRAM main\nINTERRUPT DECL 3 WHEN $IN[2]==TRUE DO guard()\nMOVE part\n.END\n"
        f".PROGRAM guard\nHALT\n.END\n{DATA}"
    )
    (found,) = said(compiled(text))
    assert "REACTI 1002, guard\n" in with_edits(text, edits_of([found]))


def test_a_drill_goes_forward_and_back() -> None:
    """`DEPARTS -30` is no slip where the next step comes back."""
    text = f".PROGRAM main\nMOVE part\nDEPARTS -30\nDEPARTS 30\n.END\n{DATA}"
    assert said(compiled(text)) == []


@pytest.mark.parametrize(
    "word",
    [
        word.text
        for word in INSTRUCTIONS.values()
        if not set(word.dialects) & set("12") and not "READY".startswith(word.text)
    ],
)
def test_every_instruction_of_relatives_has_help(word: str) -> None:
    """V+ and AS have them, VAL-II has not: the message says what it has."""
    text = f".PROGRAM main\n{word}\nMOVE part\n.END\n{DATA}"
    found = [d for d in said(compiled(text)) if d.primary and d.primary.span.line == 2]
    assert found
    assert found[0].help
