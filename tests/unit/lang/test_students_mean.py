"""What students mean by steps that say something else: where it is told, and what helps."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits

DATA = ".LOCATIONS\npick 450 -120 -250 90 90 0\nover 450 120 -100 90 90 0\n.END\n"
MORE = """.PROGRAM put(place, height)
APPRO place, height
MOVES place
.END
.PROGRAM measure(result)
result = DZ(HERE)
.END
"""


def told(body: str) -> tuple[int, str, str, str]:
    """Return line, headline and help of the first message, and the program after its edits."""
    text = f".PROGRAM main\n{body}\n.END\n{MORE}{DATA}"
    found = said(compiled(text))[0]
    assert found.primary is not None
    mended = with_edits(text, edits_of([found])).partition("\n.END")[0].partition("\n")[2]
    return found.primary.span.line - 1, found.headline, "; ".join(found.help), mended


@pytest.mark.parametrize(
    ("body", "line", "headline", "help_"),
    [
        ("CALL put(60, pick)", 1, "`put`", "put(pick, 60)"),
        ("CALL put(60, where[1])", 1, "`put`", "`place` of `put(place, height)`"),
        ('PROMPT "Where? ", goal\nMOVE goal', 1, "`goal`", "TRANS(x, y, height, 90, 90, 0)"),
        ("t = 5\nTYPE t[1], t[2]", 1, "`t`", "`t[1]`"),
        ("CASE TIMER(1) OF\nVALUE > 50:\nREADY\nEND", 2, "no comparison", "`IF x > 50 THEN`"),
        ("10 GOTO 10\nREADY", 1, "for ever", "`WAIT SIG(1001)`"),
        ("DRIVE 5, 250, 40", 1, "250 degrees", "smaller"),
        ("FOR i = 0 TO 2\nz[i+1] = i\nEND\nTYPE z[0]", 4, "`z[0]`", "`z[1]` to `z[3]`"),
        ("DRAW 0,0,12,5", 1, "decimal", "point"),
        ("MOVES SHIFT(pick BY 0,0,12,5)", 1, "5 given", "`SHIFT(pick BY 0,0,12.5)`"),
        ("IF HERE == pick THEN\nREADY\nEND", 1, "`==`", "`DISTANCE(HERE, pick) < 1`"),
        ("WHILE pick <> HERE DO\nEND", 1, "`<>`", "`DISTANCE(pick, HERE) > 1`"),
        ("z[1] = 1\nTYPE LEN(z)", 2, "LEN", "nothing counts the elements"),
        ("CALL put, measure", 1, "one program", "`CALL put`, `CALL measure`"),
        ("n = 1\nIF n == None THEN\nREADY\nEND", 2, "`none`", "`NOT DEFINED(n)`"),
        ("DRIVE J1, 45, 50", 1, "`j1`", "write `1`"),
        ('PROMPT "?", $a\nIF $a == y THEN\nEND', 2, "`==`", '`$a == "y"`'),
        ("x = TRUE\nIF x == 1 THEN\nREADY\nEND", 2, "never true", "`== ON`"),
        ("DRAW 0, 0, 0.1", 1, "metres", "100"),
        ("x = zeros(1, 3)\nx[1] = 2\nTYPE x[1]", 1, "`zeros`", "no size"),
        ("x = time.time()\nTYPE x", 1, "`time.time`", "`TIMER(1)`"),
        ("SET p = pick, 2\nMOVE p", 1, "one value", "SHIFT(pick BY dx, dy, dz)"),
        ("CALL put(pikc, 60)\nMOVE pick", 1, "`pikc`", "did you mean `pick`"),
        ('TYPE "Area",, 5', 1, "`,` stands twice", "remove one"),
        ("APPRO pick, 1O0", 1, "the letter O", "the digit 0"),
        ("50 = h\nTYPE h", 1, "left of `=`", "`h = 50`"),
        ("n = 0\nn + 1 = n\nTYPE n", 2, "left of `=`", "`n = n + 1`"),
        ("n = 0\nn + 1\nTYPE n", 2, "no step", "`n = n + 1`"),
        ("n, k = 5\nTYPE n, k", 1, "one variable", "`n = 5`, `k = 5`"),
        ("part count = 0\nTYPE part count", 1, "one word", "`part_count`"),
        ("n! = 5\nTYPE n", 1, "letters, digits", "`n`"),
        ("count 0\nTYPE count", 1, "`=` is missing", "`count = 0`"),
        ("i = 1\nMOVE z{i}", 2, "brackets", "`MOVE z[i]`"),
        ("i = 1\nMOVE z[i)", 2, "closed by", "`MOVE z[i]`"),
        ("n = 1\nm = [n+1]*2\nTYPE m", 2, "parentheses", "`m = (n+1)*2`"),
        ("SIGNAL[5]", 1, "no brackets", "`SIGNAL 5`"),
        ("DE PART 50", 1, "DEPART is one word", "`DEPART 50`"),
        ("n = 1\nIF n > = 1 THEN\nREADY\nEND", 2, "one sign", "`>=`"),
        ("DELAY FOR 5", 1, "takes no FOR", "`DELAY 5`"),
        ("n = 0\nN10 READY\nn = n+1\nIF n < 3 GOTO 10", 2, "numbers alone", "`10 READY`"),
        ('TYPE All parts done"', 1, "before it", '`TYPE "All parts done"`'),
        ("SET p = TRANS(1,2,3;4,5,6)\nMOVE p", 1, "`;` begins", "`,` instead of `;`"),
        ('n = 5\nTYPE "n = ", "n"', 2, "not its value", "write `n`"),
        ("SIGNAL 5 -6", 1, "takes a list", "`SIGNAL 5, -6`"),
        ("x = 2\ny = 3 x\nTYPE y", 2, "`*` is missing", "`y = 3*x`"),
        ("DRIVE 1, 10, 50\nLEFTY\nMOVES pick", 2, "LEFTY does not turn", "MOVE for MOVES"),
        ("LEFTY ALWAYS\nMOVE pick\nx = 3\nx = x +", 4, "missing after `+`", "remove `+`"),
        ("x = 2\nCASE x OF\nVALUE x > 1:\nREADY\nEND", 3, "a condition", "`IF x > 1 THEN`"),
        ("IGNORE 5", 1, "cannot be watched", "1001"),
        ("$a = hello\nTYPE $a", 1, "`$a`", '`$a = "hello"`'),
        ("FOR i = 1 TO 3\nTYPE j\nEND", 2, "`j`", "`i`, which this FOR counts"),
        ('PROMPT "?", a\nIF $a == "y" THEN\nREADY\nEND', 2, "`$a`", "in line 2 too"),
        ("t = put(3, 4)\nTYPE t", 1, "`put`", "`CALL put(3, 4, t)`"),
        ("MOVE pick\nSPEED 20\nCLOSEI", 2, "no effect", "before the motion"),
        ("WAIT SIG(2001)\nSIGNAL 2002", 1, "internal signal 2001", "`2002`"),
        ("FOR i = 1 TO 3\nz[i] = i\nEND\nFOR i = 0 TO 2\nTYPE z[i]\nEND", 4, "z[0]", "i = 1 TO 3"),
    ],
)
def test_the_first_message_names_the_cause(body: str, line: int, headline: str, help_: str) -> None:
    at, said_, helps, _ = told(body)
    assert (at, headline in said_, help_ in helps) == (line, True, True), (said_, helps)


@pytest.mark.parametrize(
    ("body", "mended"),
    [
        ("CALL measure((h))\nTYPE h", "CALL measure(h)\nTYPE h"),
        ("IF INRANGE(pick) THEN\nMOVE pick\nEND", "IF INRANGE(pick) == 0 THEN\nMOVE pick\nEND"),
        ("TYPE /F7,2, TIMER(1)", "TYPE /F7.2, TIMER(1)"),
        ("LEFTY\nMOVE pick\nRIGHTY\nMOVES over", "LEFTY\nMOVE pick\nRIGHTY\nMOVE over"),
        ("IF TIMER(1) > 2,5 THEN\nEND", "IF TIMER(1) > 2.5 THEN\nEND"),
        (
            "SET p = TRANS(450,5, -120,5, 0, 90, 90, 0)\nMOVE p",
            "SET p = TRANS(450.5, -120.5, 0, 90, 90, 0)\nMOVE p",
        ),
        ("GRASP 12,5", "GRASP 12.5"),
        ("CALL put(pick, 12,5)", "CALL put(pick, 12.5)"),
        ("x = 1.200,5\nTYPE x", "x = 1200.5\nTYPE x"),
        ("CASE TIMER(1) OF\nVALUE 4-6:\nEND", "CASE TIMER(1) OF\nVALUE 4, 5, 6:\nEND"),
        ("CASE TIMER(1) OF\nVALUE 1 OR 2:\nEND", "CASE TIMER(1) OF\nVALUE 1, 2:\nEND"),
        ("count = 1\ncount =+ 1\nTYPE count", "count = 1\ncount = count+1\nTYPE count"),
        ("x = ATAN2(1, 2)*180/PI\nTYPE x", "x = ATAN2(1, 2)\nTYPE x"),
        ("MOVES SHIFT(pick BY 0, 0, ...\n50)", "MOVES SHIFT(pick BY 0, 0, 50)"),
        ("MOVES SHIFT(pick BY 0,\n0,\n50)", "MOVES SHIFT(pick BY 0, 0, 50)"),
        ("DO MOVE pick", "MOVE pick"),
        ("DO MOVE pick\nUNTIL SIG(1001)", "DO\n    MOVE pick\nUNTIL SIG(1001)"),
        ("WAIT TIME 2", "DELAY 2"),
        ('CALL "put"(pick, 5)', "CALL put(pick, 5)"),
        ("DO 3 TIMES\nREADY\nEND", "FOR i = 1 TO 3\nREADY\nEND"),
        ("MOVE pick TO over", "MOVE pick\nMOVE over"),
        ("OUTPUT 2 = 1", "SIGNAL 2"),
        ("IF TIMER(1) > 3 AND < 5 THEN\nEND", "IF (TIMER(1) > 3) AND (TIMER(1) < 5) THEN\nEND"),
        ("x = MAX(1,2\nTYPE x", "x = MAX(1,2)\nTYPE x"),
        ("IF (SIG(1001) THEN\nREADY\nEND", "IF (SIG(1001)) THEN\nREADY\nEND"),
        ("z[1] = 2\nh = z(1)\nTYPE h", "z[1] = 2\nh = z[1]\nTYPE h"),
        ("x = -|3|\nTYPE x", "x = -ABS(3)\nTYPE x"),
        ("n = 2\nTYPE n:6:2", "n = 2\nTYPE /F6.2, n"),
        ("SET p = pick + [0, 0, 50]\nMOVE p", "SET p = SHIFT(pick BY 0, 0, 50)\nMOVE p"),
        ("a = 3\nr = a*PI/180\nTYPE COS(r)", "a = 3\nr = a\nTYPE COS(r)"),
    ],
)
def test_the_edit_makes_what_was_meant(body: str, mended: str) -> None:
    assert told(body)[3] == mended


@pytest.mark.parametrize(
    "body",
    [
        "FOR i = 1 TO 3\nz[i] = i\nEND\nIF SIG(1001) GOTO 5\nTYPE z[9]\n5 READY",
        "FOR i = 1 TO 3\nz[i] = i\nEND\nIF SIG(1001) THEN\nRETURN\nEND\nTYPE z[3]",
        "10 READY\nIF SIG(1001) GOTO 10",
        "LEFTY\nMOVE pick\nRIGHTY\nAPPRO over, 50\nMOVES over",
        "n = 0\nDO\nn = 0\nIF SIG(1001) THEN\nn = 4\nEND\nn = n+1\nUNTIL n == 5",
    ],
)
def test_what_is_right_is_left_alone(body: str) -> None:
    text = f".PROGRAM main\n{body}\n.END\n{DATA}"
    assert said(compiled(text)) == []


def test_a_list_of_whole_numbers_has_no_certain_decimal_comma() -> None:
    """`400,100,50,90,90,0,0`: any of the commas may be surplus."""
    body = "SET q = TRANS(400,100,50,90,90,0,0)\nMOVE q"
    assert told(body)[3] == body


def test_a_value_lost_is_told_once() -> None:
    """A variable that gets no value for its parentheses is not told to have none, too."""
    text = f".PROGRAM main\nCALL measure((h))\nTYPE h\n.END\n{MORE}{DATA}"
    assert [d.rule.code for d in said(compiled(text))] == ["V269"]


@pytest.mark.parametrize(
    "body",
    [
        'PROMPT "?", $a\nIF $a == "y" OR "Y" THEN\nREADY\nEND',
        "MOVE READY",
        "x = zeros(1, 3)\nx[1] = 2\nTYPE x[1]",
        "z[1] = 1\nTYPE LEN(z)",
        'INPUT "How many"; n\nTYPE n',
        "MOVES SHIFT(pick BY 0,\n0,\n50)",
        "n = 2\nTYPE n:6:2",
        "SET p = {450,-120,-250,90,90,0}\nMOVE p",
    ],
)
def test_one_mistake_is_told_once(body: str) -> None:
    text = f".PROGRAM main\n{body}\n.END\n{MORE}{DATA}"
    assert len(said(compiled(text))) == 1


def test_a_part_may_be_pressed_by_a_few_millimetres() -> None:
    """A sign that is wrong shows in tens of millimetres."""
    for body, codes in (("APPROS pick, -2", []), ("APPROS pick, -20", ["V220"])):
        text = f".PROGRAM main\nMOVE over\n{body}\nMOVES pick\n.END\n{MORE}{DATA}"
        assert [d.rule.code for d in said(compiled(text))] == codes
