"""What each level of `[hints]` may tell of a chain: its place is told by what happened alone."""

import re

import pytest

from tests.mutants.given import mutants
from vrts.check.rules.hints import Hints
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import load_task
from vrts.why.chain import Chain, words

JUDGES = re.compile(r"\b(?:too|instead|should|must|missing|forgot\w*|wrong|better|needs?)\b")
EACH = 12  # of the mutants, one in so many


def chains(every: int) -> list[Chain]:
    """Return the chains of programs with one mistake each, of every kind that there is."""
    found: list[Chain] = []
    for mutant in list(mutants())[::every]:
        file = ProgramFile(mutant.text.encode(), "prog.v2")
        request = Request(file, load_task(mutant.task), checks=Checks(causes=True))
        found += assess(request).chains
    return found


@pytest.mark.thorough
def test_a_place_is_told_by_what_happened_and_by_no_word_of_what_would_be_right() -> None:
    links = [link for chain in chains(EACH) for link in chain.links]
    assert len(links) >= 100
    assert sum(bool(link.toward) for link in links) >= 10
    for link in links:
        said = words(link, Hints.PLACE)
        assert said == link.says
        assert JUDGES.search(re.sub(r"`[^`]*`", "", said)) is None, said
        if link.toward:
            assert words(link, Hints.DIRECTION) == f"{said}: {link.toward}"
            assert not re.search(r"\d", re.sub(r"`[^`]*`", "", link.toward)), link.toward
        elif link.amount:
            assert words(link, Hints.DIRECTION) == said
