"""Mistakes of beginners: the files are sound, what was meant compiles, the score never falls."""

from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from tests.mistakes import compiled, false_warnings, judge, mends, names_one, said, score
from tests.support_mistakes import BadCaseError, mistakes, right
from vrts.base.diagnostic import Severity

MISTAKES = mistakes()
RIGHT = right()
HELD = {  # how many mistakes of all; they may rise
    "place": 1411,
    "cause": 1408,
    "help": 1401,
    "count": 1409,
    "all": 1397,
    "edit": 679,
    "severity": 1388,
}
FALSE_WARNINGS = 1  # right programs of which the compiler complains; they may fall


def test_cases_are_many_and_named_once() -> None:
    """Names are unique, so that a failure says which case it is."""
    assert len(MISTAKES) >= 320
    assert len(RIGHT) >= 200
    for names in ([m.name for m in MISTAKES], [r.name for r in RIGHT]):
        assert [name for name, count in Counter(names).items() if count > 1] == []


def test_programs_are_of_the_size_that_students_write() -> None:
    """Five to forty lines."""
    sizes = {m.name: len(m.wrong.splitlines()) for m in MISTAKES}
    assert {name: size for name, size in sizes.items() if not 5 <= size <= 40} == {}


def test_pairs_exist() -> None:
    """The other case of a pair is there, and a quarter of all are easily confused with another."""
    names = {m.name for m in MISTAKES}
    paired = [m.pair for m in MISTAKES if m.pair is not None]
    assert set(paired) <= names
    first = [m for m in MISTAKES if m.family < "23"]  # the later ones were written without pairs
    assert len(paired) >= len(first) / 4


@pytest.mark.parametrize(
    "text",
    [
        "## a\nerror 1\nabout: x\nhelp: y\n```\n  .PROGRAM a\n  .END\n```\n",
        "## a\nfault 1\nabout: x\nhelp: y\n```\n- .PROGRAM a\n  .END\n```\n",
        "## a\nerror 1\nabout: x\n```\n- .PROGRAM a\n  .END\n```\n",
        "## a\nerror 1\nabout: x\nhelp: y\n```\n-.PROGRAM a\n  .END\n```\n",
        "## a\nerror 1\nabout: x\nhelp: y\n",
    ],
    ids=["no mistake", "no severity", "no help", "no blank behind the mark", "no program"],
)
def test_a_case_written_otherwise_is_refused(text: str, tmp_path: Path) -> None:
    """A slip in a file cannot make a case vanish."""
    (tmp_path / "01-a.md").write_text(text, "utf-8")
    with pytest.raises(BadCaseError):
        mistakes(tmp_path)


@pytest.mark.parametrize(
    ("text", "word", "says"),
    [
        ("END ends nothing", "end", True),
        ("send the part", "end", False),
        ("the end of it", "end", False),
        ("write `end`", "end", True),
        ("put it between double quotes", "quote", True),
        ("put `,` between them", ",", True),
        ("well, no", ",", False),
        ("leave the percent sign out", "remove", True),
    ],
)
def test_words_are_found_as_the_readme_says(text: str, word: str, says: bool) -> None:
    """Short words of the language only in capitals or backticks, signs only in backticks."""
    assert names_one(text, [word]) is says


def test_an_edit_that_mends_otherwise_than_meant_does_not_count() -> None:
    """A program that compiles after the edits, but does something else, is not mended."""
    case = next(m for m in MISTAKES if m.name == "moev")
    assert mends(case)
    assert not mends(replace(case, meant=case.meant.replace("MOVE", "MOVES")))
    assert not mends(replace(case, meant=case.meant.replace("  MOVE part\n", "")))


@pytest.mark.thorough
def test_what_was_meant_compiles_in_silence() -> None:
    """Each program that was meant has no error, and no warning but of what is not simulated."""
    told = {
        m.name: [
            d.headline
            for d in said(compiled(m.meant, m.dialect))
            if m.dialect is None or not d.headline.endswith("is not simulated")
        ]
        for m in MISTAKES
    }
    assert {name: found for name, found in told.items() if found} == {}


def test_right_programs_compile() -> None:
    """No error in any of them, and no more warnings than there were."""
    errors = [
        (r.name, d.headline)
        for r in RIGHT
        for d in said(compiled(r.text))
        if d.severity is Severity.ERROR
    ]
    assert errors == []
    assert len(false_warnings(RIGHT)) <= FALSE_WARNINGS


@pytest.mark.thorough
def test_the_score_does_not_fall() -> None:
    """Messages may become better, not worse; `python -m tests.mistakes` shows which failed."""
    held = score([judge(m) for m in MISTAKES]).held
    assert {name: count for name, count in held.items() if count < HELD[name]} == {}
