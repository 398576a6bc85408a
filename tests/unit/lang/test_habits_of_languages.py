"""Habits of Python, C, BASIC and MATLAB that are no single word: the one edit writes VAL-II."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits


def told(body: str) -> tuple[str, str]:
    """Return the headline of the one message, and the program after its edits."""
    text = f".PROGRAM main\nn = 4\n{body}\n.END\n"
    (found,) = said(compiled(text))
    mended = with_edits(text, edits_of([found]))
    return found.headline, mended[len(".PROGRAM main\nn = 4\n") : -6]


@pytest.mark.parametrize(
    ("body", "headline", "after"),
    [
        ('TYPE f"part {n} of {n:.2f}"', "f-strings", 'TYPE "part ", n, " of ", n'),
        ('$s = f"part {n}"\nTYPE $s', "f-strings", '$s = "part "+$ENCODE(n)\nTYPE $s'),
        ("print('hello')", "PRINT is not", 'TYPE "hello"'),
        ("IF n is 3 THEN\nEND", "`is`", "IF n == 3 THEN\nEND"),
        ("IF n is not 3 THEN\nEND", "comparisons are signs", "IF n <> 3 THEN\nEND"),
        ("IF (n & 4) <> 0 THEN\nEND", "`&`", "IF (n BAND 4) <> 0 THEN\nEND"),
        ("IF SIG(1) & SIG(2) THEN\nEND", "`&`", "IF SIG(1) AND SIG(2) THEN\nEND"),
        (
            'PROMPT "", s\nIF 1 <= s <= 5 THEN\nREADY\nEND',
            "compares the outcome of a comparison",
            'PROMPT "", s\nIF (1 <= s) AND (s <= 5) THEN\nREADY\nEND',
        ),
        ("10 READY\nIF n > 5 GO TO 10", "GO TO is one word", "10 READY\nIF n > 5 GOTO 10"),
        (
            "x = n > 3 ? 1 : 2\nTYPE x",
            "IF chooses",
            "IF n > 3 THEN\n    x = 1\nELSE\n    x = 2\nEND\nTYPE x",
        ),
        (
            "CASE n OF\n1:\nREADY\n2, 3: OPENI\nEND",
            "begins with VALUE",
            "CASE n OF\nVALUE 1:\nREADY\nVALUE 2, 3:\n    OPENI\nEND",
        ),
        ("CALL show[n]\n.END\n.PROGRAM show(k)\nTYPE k", "", None),
    ],
)
def test_the_edit_writes_what_was_meant(body: str, headline: str, after: str | None) -> None:
    found, mended = told(body)
    assert headline in found
    assert mended == (after if after is not None else body.replace("[n]", "(n)"))


def test_a_case_of_strings_is_told_once_with_its_values() -> None:
    body = 'PROMPT "", $a\nCASE $a OF\nVALUE "y":\nREADY\nVALUE "n":\nOPENI\nEND'
    (found,) = said(compiled(f".PROGRAM m\n{body}\n.END\n"))
    assert '`IF $a == "text" THEN`' in found.help[0]


def test_a_label_outside_of_a_case_is_no_value() -> None:
    body = "CASE n OF\nVALUE 1:\nREADY\nEND\n10: OPENI\nIF n GOTO 10"
    assert told(body)[1] == body.replace("10:", "10")


@pytest.mark.parametrize("condition", ["(1 <= n) AND (n <= 5)", "1 < n AND 2 < n"])
def test_other_comparisons_are_no_chains(condition: str) -> None:
    found = said(compiled(f".PROGRAM m\nn = 1\nIF {condition} THEN\nREADY\nEND\n.END\n"))
    assert not any("compares the outcome of a comparison" in d.headline for d in found)
