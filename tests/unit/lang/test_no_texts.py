"""Numbers in sums with text: what helps depends on whether the name has a value."""

import pytest

from tests.mistakes import compiled, said


@pytest.mark.parametrize(
    ("before", "step", "meant"),
    [
        ("i = 1", 'TYPE "n = " + i', 'TYPE "n = ", i'),
        ("i = 1", 'TYPE i + "mm" + i', 'TYPE i, "mm", i'),
        ("FRO i = 1 TO 3\nEND", 'TYPE "n = " + i', 'TYPE "n = ", i'),  # the line that gives it
        ('$i = "a"', 'TYPE "n = " + i', 'TYPE "n = " + $i'),
    ],
)
def test_a_sum_of_text_and_a_number_is_mended(before: str, step: str, meant: str) -> None:
    program = f".PROGRAM main\n{before}\n{step}\n.END\n"
    found = [d for d in said(compiled(program)) if d.rule.code == "V202"]
    (one,) = found
    assert one.fix is not None
    span = one.fix.span
    mended = program[: span.start] + one.fix.replacement + program[span.end :]
    assert mended == program.replace(step, meant)


def test_a_word_that_nothing_gives_a_value_was_meant_as_text() -> None:
    (found,) = said(compiled('.PROGRAM main\nTYPE "part " + red\n.END\n'))
    assert found.fix is None
    assert "double quotes" in found.help[0]
