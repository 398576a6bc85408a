"""Structures that lack an end or have another's, and several steps on one line."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits

COUNTING = "n = 0\nDO\n  n = n+1"
FOR = "FOR i = 1 TO 3\n  TYPE i"
CASE = "CASE k OF\n VALUE 1:\n  IF SIG(1) THEN\n   OPENI\n  ELSE\n   CLOSEI"
JUMP = "10 READY\nIF SIG(1) GOTO 10"


def told(body: str) -> tuple[str, str]:
    """Return the headline of the one message, and the program after its edits."""
    text = f".PROGRAM main\n{body}\n.END\n"
    (found,) = said(compiled(text))
    return found.headline, with_edits(text, edits_of([found]))[len(".PROGRAM main\n") : -6]


@pytest.mark.parametrize(
    ("body", "after"),
    [
        ("FOR i = 1 TO 4 SIGNAL i END", "FOR i = 1 TO 4\n    SIGNAL i\nEND"),
        ("FOR i = 1 TO 4 DO SIGNAL i END", "FOR i = 1 TO 4\n    SIGNAL i\nEND"),
        ("FOR i = 1 TO 4 SIGNAL i", "FOR i = 1 TO 4\n    SIGNAL i\nEND"),
        ("WHILE SIG(1) DO SIGNAL 2\nEND", "WHILE SIG(1) DO\n    SIGNAL 2\nEND"),
        ("DO SIGNAL 2 UNTIL SIG(1)", "DO\n    SIGNAL 2\nUNTIL SIG(1)"),
        ("IF SIG(1) SIGNAL 2", "IF SIG(1) THEN\n    SIGNAL 2\nEND"),
        ("IF SIG(1) THEN OPENI ELSE CLOSEI", "IF SIG(1) THEN\n    OPENI\nELSE\n    CLOSEI\nEND"),
        ("IF SIG(1) THEN n = 1\nTYPE n", "IF SIG(1) THEN\n    n = 1\nEND\nTYPE n"),
        ("OPENI : READY", "OPENI\nREADY"),
        ("DELAY 2 READY", "DELAY 2\nREADY"),
        ("n = 1, m = 2\nTYPE n, m", "n = 1\nm = 2\nTYPE n, m"),
    ],
)
def test_each_step_gets_a_line_of_its_own(body: str, after: str) -> None:
    headline, mended = told(body)
    assert any(words in headline for words in ("its line", "line of its own", "one step"))
    assert mended == after


@pytest.mark.parametrize(
    ("body", "headline", "after"),
    [
        ("FOR i = 1 TO 3\n  TYPE i\nUNTIL i == 3", "a FOR ends with END", f"{FOR}\nEND"),
        (f"{COUNTING}\nWHILE n < 5", "a DO ends with UNTIL", f"{COUNTING}\nUNTIL n >= 5"),
        (f"{COUNTING}\nEND WHILE n < 5", "a DO ends with UNTIL", f"{COUNTING}\nUNTIL n >= 5"),
        ("READY\nEND\nREADY", "END ends nothing", "READY\nREADY"),
        (f"{JUMP}\nEND\nREADY", "END ends nothing", f"{JUMP}\nREADY"),
        (
            "DO\n  IF SIG(1) THEN\n    READY\nUNTIL SIG(2)\n  END",
            "UNTIL ends the DO while the IF inside it is still open",
            "DO\n  IF SIG(1) THEN\n    READY\n  END\nUNTIL SIG(2)",
        ),
        (
            "DO\n  IF SIG(1) THEN\n    READY\nUNTIL SIG(2)",
            "this IF has no END",
            "DO\n  IF SIG(1) THEN\n    READY\n  END\nUNTIL SIG(2)",
        ),
        ("DO\n  READY\nEND\nUNTIL SIG(2)", "END ends nothing", "DO\n  READY\nUNTIL SIG(2)"),
    ],
)  # fmt: skip
def test_the_end_of_another_structure_is_told_once(body: str, headline: str, after: str) -> None:
    found, mended = told(body)
    assert found.startswith(headline)
    assert mended == after


def test_an_else_behind_a_jump_names_the_jump() -> None:
    (found,) = said(compiled(".PROGRAM m\n10 READY\nIF SIG(1) GOTO 10\nELSE\nREADY\nEND\n.END\n"))
    assert "line 3" in found.help[0]


@pytest.mark.parametrize("step", ["TYPE HERE", "SPEED 50 ALWAYS", 'TYPE "OPENI READY"', "n = hand"])
def test_one_step_is_left_whole(step: str) -> None:
    headlines = [d.headline for d in said(compiled(f".PROGRAM m\n{step}\n.END\n"))]
    assert not any("line of its own" in line for line in headlines)


@pytest.mark.parametrize(
    ("body", "headline", "after"),
    [
        (
            f"{CASE}\n VALUE 2:\n  READY\n ANY\n  READY\nEND",
            "this IF has no END",
            f"{CASE}\n  END\n VALUE 2:\n  READY\n ANY\n  READY\nEND",
        ),
        (
            "CASE k OF\n VALUE 1:\n  FOR i = 1 TO 3\n   TYPE i\n  READY\n ANY\n  READY\nEND",
            "this FOR has no END",
            "CASE k OF\n VALUE 1:\n  FOR i = 1 TO 3\n   TYPE i\n  END\n  READY\n ANY\n  READY\nEND",
        ),
        (
            "DO\n  IF SIG(1) THEN\n    OPENI\n    CLOSEI\n  READY\n  BREAK\nUNTIL SIG(2)",
            "this IF has no END",
            "DO\n  IF SIG(1) THEN\n    OPENI\n    CLOSEI\n  END\n  READY\n  BREAK\nUNTIL SIG(2)",
        ),
        (
            "IF SIG(1) THEN\n  OPENI\nEND\nELSE\n  CLOSEI\nEND\nREADY",
            "ELSE without IF: the END above it closes the IF too early",
            "IF SIG(1) THEN\n  OPENI\nELSE\n  CLOSEI\nEND\nREADY",
        ),
        (
            "WHILE SIG(3) DO\n  IF SIG(1) THEN\n    OPENI\n  END\n  ELSE\n    CLOSEI\n  END\nEND",
            "ELSE without IF: the END above it closes the IF too early",
            "WHILE SIG(3) DO\n  IF SIG(1) THEN\n    OPENI\n  ELSE\n    CLOSEI\n  END\nEND",
        ),
    ],
)  # fmt: skip
def test_the_word_of_another_structure_tells_where_the_end_belongs(
    body: str, headline: str, after: str
) -> None:
    found, mended = told(f"k = 1\n{body}" if "CASE" in body else body)
    assert found == headline
    assert mended.removeprefix("k = 1\n") == after


def test_each_structure_without_its_end_is_told_by_its_indentation() -> None:
    text = (
        ".PROGRAM m\nDO\n  IF SIG(1) THEN\n    OPENI\n  READY\nUNTIL SIG(2)\n"
        "FOR i = 1 TO 3\n  IF SIG(3) THEN\n    CLOSEI\n  TYPE i\nEND\n.END\n"
    )
    found = said(compiled(text))
    assert [d.headline for d in found] == ["this IF has no END"] * 2
    after = with_edits(text, edits_of(found))
    assert "    OPENI\n  END\n  READY" in after
    assert "    CLOSEI\n  END\n  TYPE i\nEND" in after


@pytest.mark.parametrize("closer", ["UNTIL SIG(2)", "ANY\nREADY\nEND"])
def test_no_edit_is_sure_where_nothing_is_indented(closer: str) -> None:
    opener = "DO" if closer.startswith("UNTIL") else "k = 1\nCASE k OF\nVALUE 1:"
    text = f".PROGRAM m\n{opener}\nIF SIG(1) THEN\nOPENI\nREADY\n{closer}\n.END\n"
    (found,) = said(compiled(text))
    assert found.headline == "this IF has no END"
    assert found.fix is not None
    assert not found.fix.sure
