"""The canonical layout of single lines and of whole files."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.dialect import AS, VAL2, VAL2_PLUS, VPLUS, Dialect
from vrts.lang.writing.layout import layout


def step(text: str, dialect: Dialect = VAL2) -> str:
    source = SourceFile("a.v2", f".PROGRAM main\n{text}\n.END\n")
    return layout(source, dialect).split("\n")[1]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("move P", "        MOVE p"),
        ("appro   Part[ 2*I ],50", "        APPRO part[2*i], 50"),
        ("RI", "        RIGHTY"),  # abbreviations are written in full
        ("X=A+B * -c", "        x = a+b*-c"),
        ("x = a- -b", "        x = a- -b"),
        ("if(a=<3)and not B then", "        IF (a <= 3) AND NOT b THEN"),
        ("x=sin(Y)+Dx", "        x = SIN(y)+dx"),  # dx is a variable, DX( would be a function
        ("set p=shift(q by 1,,2):trans(1,2)", "        SET p = SHIFT(q BY 1,,2):TRANS(1,2)"),
        ("base ,,300", "        BASE ,,300"),
        ("draw 10, , 5", "        DRAW 10,,5"),
        ('type "a;B",/i4 , N', '        TYPE "a;B", /I4, n'),
        ("10 Move p;go", "10      MOVE p  ;go"),
        ("600;text", "600  ;text"),
        ("value 1 , 2 :", "        VALUE 1, 2:"),
        ("enable cp", "        ENABLE CP"),
        ("x=switch( cp )", "        x = SWITCH(CP)"),
        ("call Sub( a[ ] , (b))", "        CALL sub(a[],(b))"),
        ("x=^hff+'a", "        x = ^hff+'a"),  # numbers stay as written
        ("$S=$encode(/f8.2,X)", "        $s = $ENCODE(/F8.2,x)"),
        ("set P=true", "        SET p = TRUE"),
    ],
)
def test_step(before: str, after: str) -> None:
    assert step(before) == after


@pytest.mark.parametrize(
    ("before", "after", "dialect"),
    [
        ("write(lun)$a,/s", "        WRITE (lun) $a, /S", VPLUS),
        ("speed 20 mm/s always", "        SPEED 20 MM/S ALWAYS", AS),
        ('  print 2: "x"', '  print 2: "x"', AS),  # what makes no token is not lost
        ("ioput 3=4", "        IOPUT 3 = 4", VAL2_PLUS),
        ("window %Belt = A,b", "        WINDOW %Belt = A,b", VAL2),  # opaque: as it stands
    ],
)
def test_step_of_a_relative(before: str, after: str, dialect: Dialect) -> None:
    assert step(before, dialect) == after


@pytest.mark.parametrize("line", ["  MOVEE p", "  x = (1", '  TYPE "a', " \tMOVE   a  b "])
def test_lines_that_do_not_parse_stay_as_they_are(line: str) -> None:
    assert step(line) == line


BEFORE = """\
.program Main ( N , $s )
; a comment in the first column
   ;one that goes with the code
for i=1 to N
case I of
value 1:
open
any
if i>2 then
10 closei     ; keep my place
else
do
until TRUE
end
end

end
.end
.locations
Pick 1 2 3   90 90 0 ; taught
#safe 0 0 0 0 0 0
.end
"""
AFTER = """\
.PROGRAM main(n, $s)
; a comment in the first column
        ;one that goes with the code
        FOR i = 1 TO n
            CASE i OF
              VALUE 1:
                OPEN
              ANY
                IF i > 2 THEN
10                  CLOSEI  ; keep my place
                ELSE
                    DO
                    UNTIL TRUE
                END
            END

        END
.END
.LOCATIONS
pick            1 2 3 90 90 0  ; taught
#safe           0 0 0 0 0 0
.END
"""


def test_file() -> None:
    assert layout(SourceFile("a.v2", BEFORE), VAL2) == AFTER
    assert layout(SourceFile("a.v2", AFTER), VAL2) == AFTER


def test_indentation_ends_at_twenty_levels() -> None:
    deep = "\n".join(["DO"] * 30 + ["READY"] + ["UNTIL TRUE"] * 30)
    rows = layout(SourceFile("a.v2", f".PROGRAM main\n{deep}\n.END\n"), VAL2).split("\n")
    assert max(len(row) - len(row.lstrip()) for row in rows) == 8 + 20 * 4
