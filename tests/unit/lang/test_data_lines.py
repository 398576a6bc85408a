"""Lines of data as beginners write them: told once, on the line, mended where that is certain."""

import pytest

from tests.mistakes import compiled, said
from vrts.ir.dump import dump

PROGRAM = ".PROGRAM pick\n        MOVE part\n        TYPE n, $s\n.END\n"
LOCATION, REAL, STRING = "part 450 0 -200 90 90 0", "n 5", '$s "a b"'


def text(location: str = LOCATION, real: str = REAL, string: str = STRING) -> str:
    """Return a program and its data."""
    return (
        f"{PROGRAM}.LOCATIONS\n{location}\n.END\n.REALS\n{real}\n.END\n.STRINGS\n{string}\n.END\n"
    )


def mended(wrong: str) -> str:
    """Return a program after the edit of its one diagnostic."""
    (found,) = said(compiled(wrong))
    assert found.fix is not None
    start, end = found.fix.span.start, found.fix.span.end
    return wrong[:start] + found.fix.replacement + wrong[end:]


@pytest.mark.parametrize(
    "wrong",
    [
        *(
            text(location=line)
            for line in (
                "part (450, 0, -200, 90, 90, 0)",
                "part = TRANS(450, 0, -200, 90, 90, 0)",
                "part: 450 0 -200 90 90 0",
                "part := 450, 0, -200, 90, 90, 0",
                "SET part = 450 0 -200 90 90 0",
                "SET part = TRANS(450, 0, -200, 90, 90, 0)",
                "part X=450 Y=0 Z=-200 O=90 A=90 T=0",
                "part 450mm 0 mm -200mm 90 90 0",
                "part 45O 0 -200 90 90 0",
                "part 450 0 -200 90 90 0,",
            )
        ),
        *(text(real=line) for line in ("n: 5", "n = 5 mm", "REAL n = 5", "n (5)")),
        *(text(string=line) for line in ('s "a b"', '$s "a b', "$s 'a b'", "$s = “a b”")),
    ],
)
def test_a_line_with_something_besides_name_and_values_is_mended(wrong: str) -> None:
    """One message, and the edit gives exactly what was meant."""
    right, found = compiled(text()).module, compiled(mended(wrong)).module
    assert right is not None
    assert found is not None
    assert dump(found) == dump(right)


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (text(location="450 0 -200 90 90 0\npart 450 0 -200 90 90 0"), "name"),
        (text(location="part two 450 0 -200 90 90 0"), "part.two"),
        (text(location="part-two 450 0 -200 90 90 0"), "part_two"),
        (text(location="part 45cm 0 -20cm 90 90 0"), "mm"),
        (text(location="part 450 0 -200 90 90"), "six values"),
        (text(location=f"{LOCATION}\nm 25.4"), ".REALS"),
        (text(location=f"{LOCATION}\nMOVE part"), ".PROGRAM"),
        (text(real="n 2*3"), "number"),
        (text(real="n five"), "number"),
        (text(real="n"), "value"),
        (text(real=f"n 5\nm {LOCATION[5:]}"), ".LOCATIONS"),
        (text(real='n 5\n$t "a"'), ".STRINGS"),
        (text(string='$s "a" "b"'), "quotes"),
        (text(string='$s "a"\nn 5'), ".REALS"),
    ],
)
def test_what_cannot_be_mended_for_certain_is_told_once(wrong: str, says: str) -> None:
    """Help says what to write; nothing is told of the steps that use the name."""
    (found,) = said(compiled(wrong))
    assert says in " ".join(found.help)


def test_a_decimal_comma_is_told_from_a_comma_between_values() -> None:
    """`450,5` with one value too many is one number; commas between six values are right."""
    right = text(location="part 450.5 0 -200 90 90 0")
    assert mended(text(location="part 450,5 0 -200 90 90 0")) == right
    assert mended(text(real="n 25,4")) == text(real="n 25.4")
    assert said(compiled(text(location="part 450,0,-200,90,90,0"))) == []


def test_what_real_files_hold_is_no_mistake() -> None:
    """`=` behind a name, commas, exponents, texts without quotes."""
    fine = text(location="part = 450.0, 0., -2e2, 90, 90, .0", real="n=5", string="$s = a b")
    assert said(compiled(fine)) == []
