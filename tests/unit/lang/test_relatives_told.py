"""What messages say in V+ and AS is what V+ and AS have."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.lang.dialect import AS, VAL2, VPLUS, Dialect


def told(body: str, dialect: Dialect) -> list[Diagnostic]:
    """Return what is said of a program, and another that it may call."""
    text = (
        f".PROGRAM main()\n{body}\n.END\n.PROGRAM watch()\n WHILE busy DO\n  SIGNAL 1\n END\n.END\n"
    )
    return said(compiled(text, dialect))


@pytest.mark.parametrize(
    ("step", "dialect", "instead"),
    [
        ("SPEED 200 MMS ALWAYS", AS, "SPEED 200 MM/S ALWAYS"),
        ("SPEED 200 MMS", VPLUS, "SPEED 200 MMPS"),
        ("FOR i = 1 TO 3\nCONTINUE\nEND", VPLUS, "FOR i = 1 TO 3\nNEXT\nEND"),
        ("MOVE READY", VAL2, "READY"),
        ("ATTACH 0", VPLUS, "ATTACH (0)"),
        ("WRITE lun, n", VPLUS, "WRITE (lun) n"),
        ("MOVE a\nAUTO n", VPLUS, "AUTO n\nbusy = 1\nMOVE a"),
        ("MOVE part\nDECOMPOSE part = x[0]", VPLUS, "MOVE part\nDECOMPOSE x[0] = part"),
        ("LMOVE a", VPLUS, "MOVES a"),
        ("MOVES a", AS, "LMOVE a"),
        ("SWAIT SIG(1001)", AS, "SWAIT 1001"),
        ("TWAIT 500 MS", AS, "TWAIT 0.5"),
        ("ONI 1003, watch", AS, "ONI 1003 CALL watch"),
        ('$s = "b"\nSCASE $s OF\nVALUE "a":\nEND', AS, 'SCASE $s OF\nSVALUE "a":\nEND'),
        ("$.x = $s", AS, ".$x = $s"),
        ("p = a+TRANS(1, 2, 3)", AS, "POINT p = a+TRANS(1, 2, 3)"),
        ("LMOVE 100, part", AS, "LMOVE part, 100"),
        ("IF n != 3 THEN\nEND", AS, "IF n <> 3 THEN\nEND"),
        ("IF n != 3 THEN\nEND", VPLUS, "IF n <> 3 THEN\nEND"),
        ("WHILE n < 3\nEND", AS, "WHILE n < 3 DO\nEND"),
        ("SPEED 100 MMPS ALWAYS", AS, "SPEED 100 MM/S ALWAYS"),
        ("POINT p = a:TRANS(1, 2, 3)", AS, "POINT p = a+TRANS(1, 2, 3)"),
        ("FOR .i = 9 TO 1 BY -2\nEND", AS, "FOR .i = 9 TO 1 STEP -2\nEND"),
        ("ENABLE CP", AS, "CP ON"),
        ("ACCURACY = 5", AS, "ACCURACY 5"),
        ('$s = "a" & "b"', VPLUS, '$s = "a"+"b"'),
        ('$s = $s & "b"', VPLUS, '$s = $s+"b"'),
        ("n = MAX(1, 2)", AS, "n = MAXVAL(1, 2)"),
        ("n = MAXVAL(1, 2)", VPLUS, "n = MAX(1, 2)"),
        ('n = POS($s, ",")', AS, 'n = INSTR($s, ",")'),
        ("n = SQR(m+1)", AS, "n = (m+1)^2"),
        ('$s = MID("abc", 1, 2)', AS, '$s = $MID("abc", 1, 2)'),
        ('$s = LEFT("abc", 2)', VAL2, '$s = $MID("abc", 1, 2)'),
        ("n = part.z()", VAL2, "n = DZ(part)"),
        ("LMOVE slot(3)", AS, "LMOVE slot[3]"),
        ("SLEEP 2", AS, "TWAIT 2"),
        ("MOVE SHIFT(part,0,0,50)", VAL2, "MOVE SHIFT(part BY 0,0,50)"),
    ],
)
def test_edits_are_of_the_dialect(step: str, dialect: Dialect, instead: str) -> None:
    found = told(f"busy = 1\n{step}", dialect)[0]
    assert found.primary is not None
    text = found.primary.span.source.text
    assert f"\n{instead}\n" in with_edits(text, edits_of([found]))


@pytest.mark.parametrize(
    ("body", "dialect"),
    [
        ("AUTO REAL n\nLOCAL LOC p\nATTACH (0)\nWRITE (n) n", VPLUS),
        ("SWAIT 1001, -1002\nPULSE 4, 0.5\nSIGNAL 2001", AS),
        ('SCASE $s OF\nSVALUE "a":\nEND\nCASE n OF\nVALUE 1:\nEND', AS),
        (".$x = $s\nPOINT .p = a+b\n.n = 1\n.n = .n+1", AS),
    ],
)
def test_right_steps_are_no_slips(body: str, dialect: Dialect) -> None:
    quiet = ("is not simulated", "never given a value in this file")
    found = [d.headline for d in told(f"busy = 1\n{body}" if dialect is AS else body, dialect)]
    assert [text for text in found if not text.endswith(quiet) and "never ends" not in text] == []


@pytest.mark.parametrize("dialect", [VPLUS, AS])
def test_an_input_is_not_set(dialect: Dialect) -> None:
    step = "SIGNAL 1004" if dialect is VPLUS else "PULSE 1004, 0.5"
    found = [d.headline for d in told(f"busy = 1\n{step}\nSIGNAL 1200", dialect)]
    assert [text for text in found if "is an input" in text] == [
        "signal 1004 is an input; a program cannot set it"
    ]


def test_a_task_beside_may_end_a_loop() -> None:
    """Also where the step that begins it is wrong."""
    for step in ("EXECUTE 1 watch()", "EXECUTE 1, watch()"):
        found = told(f"busy = 1\n{step}\nbusy = 0", VPLUS)
        assert [d.headline for d in found if "never ends" in d.headline] == []
    assert "never ends" in told("busy = 1\nCALL watch()", VPLUS)[0].headline


def test_home_of_as_is_a_place_of_its_own() -> None:
    """A straight line may leave it, as it may not leave READY."""
    assert "V228" not in {d.rule.code for d in told("busy = 1\nHOME\nLMOVE a", AS)}
    assert "V228" in {d.rule.code for d in told("busy = 1\nREADY\nMOVES a", VAL2)}


@pytest.mark.parametrize(
    ("step", "dialect", "says"),
    [
        ("FLY a", VAL2, "VAL-II says *Unknown instruction*"),
        ("FLY a", AS, "AS says P0109 Invalid statement"),
        ("n = 1 +", AS, "AS says P0114 Illegal expression"),
    ],
)
def test_a_controller_is_quoted_in_its_own_words(step: str, dialect: Dialect, says: str) -> None:
    (found, *_) = told(f"busy = 1\n{step}", dialect)
    assert says in found.notes


@pytest.mark.parametrize(
    ("step", "help_"),
    [
        ("WAIT 0.5", "to wait 0.5 s write `TWAIT 0.5`"),
        (
            "MoveL part, v50, fine",
            "write `LMOVE part`, and the speed in the line before: `SPEED 50 MM/S`",
        ),
    ],
)
def test_code_in_a_help_is_code_of_as(step: str, help_: str) -> None:
    found = told(f"busy = 1\n{step}", AS)[0]
    assert found.help == (help_,)


@pytest.mark.parametrize("dialect", [AS, VPLUS])
@pytest.mark.parametrize(
    "step", ["FLY a", "n += 1", "x = 5 ? 1 : 2", "n = RND(3)", "IF n = 1 THEN"]
)
def test_nothing_is_said_of_val2_to_who_writes_another(step: str, dialect: Dialect) -> None:
    for found in told(f"n = 1\nbusy = 1\n{step}", dialect):
        assert "VAL-II" not in "\n".join((found.headline, *found.notes, *found.help))


@pytest.mark.parametrize(
    ("body", "dialect", "unset"),
    [
        ("AUTO n\nTYPE n\nn = 3", VPLUS, ["n"]),
        ("AUTO n\nn = n+1\nn = 3", VPLUS, ["n"]),
        ("FOR .i = 1 TO .m\n.m = .i\nEND", AS, [".m"]),
        ('PROMPT "n?", .n\nPRINT .n', AS, []),
        ("AUTO n\nIF SIG(1001) THEN\nTYPE n\nEND\nn = 3", VPLUS, []),
        ("AUTO n\n10 IF m > 2 GOTO 20\nn = 3\n20 TYPE n", VPLUS, []),
        ("TYPE n\nn = 3", VPLUS, []),  # the memory of the controller may hold it
        ("LOCAL n\nTYPE n\nn = 3", VPLUS, []),  # and what is kept from call to call
        ("AUTO n\nCALL watch(n)\nTYPE n\nn = 3", VPLUS, []),
    ],
)
def test_a_variable_of_each_call_is_told_where_it_is_surely_empty(
    body: str, dialect: Dialect, unset: list[str]
) -> None:
    text = f".PROGRAM main()\n{body}\n.END\n.PROGRAM watch(k)\nk = 3\n.END\n"
    found = said(compiled(text, dialect))
    assert [d.data["name"] for d in found if "has no value yet" in d.headline] == unset
