"""Questions of beginners, and whether the manual's search finds a page that answers them.

`tests/data/questions` has the files: `tuning.toml` by the author of the search, `blind.toml` by
somebody who had not seen the manual, with what that author expected in the author's own words.
Those of its folder `harder` are asked, and how many find their page is printed; fewer may.
"""

import tomllib
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.places import TESTS
from vrts.ask.manual import Manual
from vrts.cli.main import SAID

FOLDER = TESTS / "data" / "questions"
HARDER = FOLDER / "harder"
FIRST = 3  # so many pages somebody looks at
LEAST = 45  # of 50 questions


class Question(NamedTuple):
    """What a beginner asks, and what answers it."""

    ask: str
    pages: tuple[str, ...]


class Answered(NamedTuple):
    """A question, what was found first, and whether that is right."""

    question: Question
    found: tuple[str, ...]

    @property
    def fits(self) -> bool:
        """Whether a page that answers is among the first."""
        return any(_is(name, page) for name in self.found for page in self.question.pages)


def _is(name: str, page: str) -> bool:
    """Whether a page that was found is one that answers, or a section of it."""
    return name == page or name.startswith(f"{page}#")


def sets(folder: Path = FOLDER) -> list[str]:
    """Return the names of the sets of questions that there are."""
    return sorted(path.stem for path in folder.glob("*.toml"))


def questions(name: str, folder: Path = FOLDER) -> list[Question]:
    """Return the questions of a set."""
    read = tomllib.loads((folder / f"{name}.toml").read_text("utf-8"))
    return [Question(row["ask"], tuple(row["pages"])) for row in read["question"]]


@cache
def manual() -> Manual:
    """Return the manual as `vrts manual` has it."""
    return Manual({name: says for named in SAID.values() for name, says in named.items()})


def answered(asked: Sequence[Question]) -> list[Answered]:
    """Ask each question as `vrts manual` does: the page that is shown, then those listed."""
    found: list[Answered] = []
    for question in asked:
        answer = manual().answer(question.ask)
        shown = () if answer.page is None else (answer.page, *answer.others)
        found.append(Answered(question, tuple(page.name for page in shown[:FIRST])))
    return found


def report(name: str, found: Sequence[Answered]) -> str:
    """Return how many questions find their page, and those that do not."""
    right = sum(each.fits for each in found)
    rows = [f"{name}: {right} of {len(found)} find a right page among the first {FIRST}"]
    rows += [
        f"  {each.question.ask}\n      found {', '.join(each.found) or 'nothing'};"
        f" right: {', '.join(each.question.pages)}"
        for each in found
        if not each.fits
    ]
    return "\n".join(rows)
