"""Beginners find the right page among the first three."""

from pathlib import Path

import pytest

from tests.questions import (
    FIRST,
    FOLDER,
    HARDER,
    LEAST,
    Question,
    answered,
    manual,
    questions,
    report,
    sets,
)
from vrts.ask.asked import asked_for


@pytest.mark.parametrize("name", sets())
def test_most_questions_find_their_page(name: str) -> None:
    asked = questions(name)
    assert len(asked) >= 50
    found = answered(asked)
    assert sum(each.fits for each in found) >= LEAST * len(asked) // 50, report(name, found)


@pytest.mark.parametrize("folder", [FOLDER, HARDER])
def test_every_page_that_is_called_right_exists(folder: Path) -> None:
    known = {page.name for page in manual().pages} | {page.of for page in manual().pages}
    asked = [question for name in sets(folder) for question in questions(name, folder)]
    assert len(asked) >= 50
    assert {page for question in asked for page in question.pages} - known == set()


def test_what_people_ask_leads_to_the_page_that_they_want() -> None:
    """The files of `vrts/ask/questions` name pages that there are, and what stands there counts."""
    known = {page.name for page in manual().pages}
    assert set(asked_for()) <= known
    sample = [
        Question(rows[len(name) % len(rows)], (name, name.partition("#")[0]))
        for name, rows in asked_for().items()
        if name.startswith("do/")
    ]
    found = answered(sample)
    assert len(sample) >= 90
    assert sum(each.fits for each in found) >= 0.97 * len(sample), report("asked", found)


def test_a_wrong_page_does_not_fit(tmp_path: Path) -> None:
    row = '[[question]]\nask = "wait 2 seconds"\npages = ["do/marks-into-moodle"]\n'
    (tmp_path / "wrong.toml").write_text(row, "utf-8")
    found = answered(questions("wrong", tmp_path))
    assert [each.fits for each in found] == [False]
    assert "do/wait-a-time" in report("wrong", found)


def test_a_section_is_its_page_and_a_longer_name_is_not() -> None:
    (one,) = answered([Question("language/motion#move", ("language/motion",))])
    assert one.found[0] == "language/motion#move"
    assert one.fits
    assert len(one.found) <= FIRST
    (other,) = answered([Question("language/motion#move", ("language/mot", "do/wait"))])
    assert not other.fits
