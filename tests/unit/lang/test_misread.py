"""Steps of which the nearest right step is not what is meant: a cause, and no wrong edit."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, mendable, with_edits

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\nover 450 -120 -100 90 90 0\n.END\n"


def program(body: str) -> str:
    """Return a program with taught locations."""
    return f".PROGRAM main\n{body}\n.END\n{DATA}"


def told(body: str) -> tuple[str, str]:
    """Return the headline and the help of the one message about a program."""
    (found,) = said(compiled(program(body)))
    return found.headline, "; ".join(found.help)


def mended(body: str, *, sure: bool = True) -> str:
    """Return a program after the edits that are certain, or after all."""
    text = program(body)
    compilation = compiled(text)
    assert compilation.source is not None
    found = said(compilation)
    chosen = mendable(compilation.source, found) if sure else found
    return with_edits(text, edits_of(chosen)).split("\n.END")[0].partition("\n")[2]


@pytest.mark.parametrize(
    ("body", "help_"),
    [
        ("a = b = 0\nTYPE a, b", "`b = 0`, then `a = b`"),
        ("a = b = c = 7\nTYPE a", "`c = 7`, then `b = c`, then `a = b`"),
        ("n[1] = n[2] = 0\nTYPE n[1]", "`n[2] = 0`, then `n[1] = n[2]`"),
        ('$a = $b = "x"\nTYPE $a', '`$b = "x"`, then `$a = $b`'),
        ("SET p = q = pick\nMOVE p", "`SET q = pick`, then `SET p = q`"),
        ("HERE 3p", "`p3`"),
        ("MOVES 2nd.place", "`nd.place2`"),
        ("MOVE pick:1b", "`b1`"),
        ("SET q = 1p:pick\nMOVE q", "`p1`"),
        ("x = DX(1p)\nTYPE x", "`p1`"),
        ("DX(pick) = 100", "`SET pick = SHIFT(pick BY 100-DX(pick), 0, 0)`"),
        ("DZ(pick) = DZ(pick)+50", "`SET pick = SHIFT(pick BY 0, 0, 50)`"),
        ("DY(pick) = DY(pick) - h", "`SET pick = SHIFT(pick BY 0, -h, 0)`"),
        ("INT(3) = 4", "`a[3] = 4`"),
        ("MOVE 500, 200, 100", "`MOVE TRANS(500, 200, 100, o, a, t)`"),
        ("MOVES (500, 200, 100)", "`MOVES TRANS(500, 200, 100, o, a, t)`"),
        ("MOVES [500, 200, 100]", "`MOVES TRANS(500, 200, 100, o, a, t)`"),
        ("SET p = 5, 6, 7", "`SET p = TRANS(5, 6, 7, o, a, t)`"),
        ("p = (5, 6, 7)", "`SET p = TRANS(5, 6, 7, o, a, t)`"),
        ("y = CALL twice(5)", "`CALL twice(5, y)`"),
        ("SET p 1 = pick", "`p1`"),
        ("IF 1 = 2 = 3 THEN\nREADY\nEND", "write `==`"),
        ("z = y(1)", "`y[1]`"),
        ("y = CALL ask", "`CALL ask(y)`"),
        ("TYPE 2*CALL twice(5)", "`CALL twice(5, result)`, then `TYPE 2*result`"),
    ],
)
def test_nothing_is_mended_where_the_meaning_is_open(body: str, help_: str) -> None:
    """The message says what to write; no edit of it is certain."""
    assert help_ in told(body)[1]
    assert mended(body) == body


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("OPENI : DEPARTS 60", "OPENI\nDEPARTS 60"),
        (" SIGNAL 1 : SIGNAL 2", " SIGNAL 1\n SIGNAL 2"),
        ('READY : TYPE "a:b"', 'READY\nTYPE "a:b"'),
        ("CLOSE THE GRIPPER", "CLOSEI"),
        ("OPENI the hand", "OPENI"),
        ("SPEED = 50 ALWAYS\nMOVE pick", "SPEED 50 ALWAYS\nMOVE pick"),
        ("APPRO = pick, 50", "APPRO pick, 50"),
        ("MOVE pick\nCLOSEL\nDEPARTS 50", "MOVE pick\nCLOSEI\nDEPARTS 50"),
        ("OPEN1", "OPENI"),
        ("DRAW 0, 0, 50mm", "DRAW 0, 0, 50"),
        ("SET p = TRANS(1 mm, 2, 3, 0, 90 deg, 0)", "SET p = TRANS(1, 2, 3, 0, 90, 0)"),
        ("n = 1\nIF n = 1 AND n = 2 THEN\nEND", "n = 1\nIF n == 1 AND n = 2 THEN\nEND"),
        ("MOVE 500, 200, 100, 0, 90, 0", "MOVE TRANS(500, 200, 100, 0, 90, 0)"),
        ("x = 2y\ny = 1\nTYPE x", "x = 2*y\ny = 1\nTYPE x"),
    ],
)
def test_what_is_certain_is_mended(body: str, after: str) -> None:
    """Nothing else can be meant."""
    told(body)
    assert mended(body) == after


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("OPEN GRIPPER", "OPENI"),
        ("CLOSEI gripper", "CLOSEI"),
        ("CLOSE HAND", "CLOSEI"),
        ("TIMER = 0", "TIMER 1 = 0"),
        ("SIGNAL = 4", "SIGNAL 4"),
        ("SPEED = 50", "SPEED 50"),
        ("DELAY = 2", "DELAY 2"),
        ("t = TIMER\nTYPE t", "t = TIMER(1)\nTYPE t"),
        ("WAIT TIMER > 5", "WAIT TIMER(1) > 5"),
        ("MOVE pick: CLOSEI", "MOVE pick\nCLOSEI"),
        ("MOVE pick.", "MOVE pick"),
        ("y = DX[3]\nTYPE y", "y = DX(3)\nTYPE y"),
        ("APPRO over., 50", "APPRO over, 50"),
    ],
)
def test_a_right_step_that_is_hardly_meant_gets_one_warning(body: str, after: str) -> None:
    """The step is legal, so that its edit is offered, and not certain."""
    told(body)
    assert mended(body) == body
    assert mended(body, sure=False) == after


@pytest.mark.parametrize(
    "body",
    [
        "b = 1\na = b == 0\nTYPE a",
        "g = 40\nOPEN g",
        "gripper = 40\nOPEN gripper",
        "MOVE pick:over",
        "TYPE HAND",
        "TIMER 1 = 0\nWAIT TIMER(1) > 5",
        "x = 1E5\nTYPE x",
        "MOVE TRANS(1, 2, 3, 0, 90, 0)",
        "SPEED 50.",
        'TYPE "x = y = 2: READY"',
    ],
)
def test_right_steps_are_let_alone(body: str) -> None:
    assert said(compiled(program(body))) == []


def test_a_variable_named_as_an_instruction_keeps_its_warning() -> None:
    """What is given a value and asked for it is a variable."""
    found = said(compiled(program("timer = 0\nx = timer+1\nTYPE x")))
    assert [d.headline for d in found] == [
        "TIMER is a word of the language, here it names a variable"
    ]


@pytest.mark.parametrize(
    ("header", "name", "certain"),
    [
        (".PROGRAM grip part(a)", ".PROGRAM grip.part(a)", True),
        (".PROGRAM put the part()", ".PROGRAM put.the.part()", True),
        (".PROGRAM put the part", ".PROGRAM put.the.part", False),
    ],
)
def test_a_name_of_two_words_is_joined(header: str, name: str, certain: bool) -> None:
    """Nothing of the name is thrown away."""
    text = f"{header}\nREADY\n.END\n"
    compilation = compiled(text)
    (found,) = said(compilation)
    assert f"`{name}`" in found.help[0]
    assert found.fix is not None
    assert found.fix.sure is certain
    assert with_edits(text, edits_of([found])).startswith(name + "\n")
