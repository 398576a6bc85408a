"""Chains of programs with one mistake that somebody else made: they lead to the mistake."""

import pytest

from tests.mutants.given import mutants
from vrts.check.rules.hints import Hints
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import load_task
from vrts.why.chain import MOST, line

LOOP = "line 19 `UNTIL i >= things`: the loop ends here with `i` at 1 and `things` at -4"
WALK = "line 14 `WHILE n <= cans DO`: the program goes past it because of this with `n` at 1 and"
SPUN = "line 14 `WHILE n <= cans DO`: `n` is 1 here each time, whatever the loop does to it"
SHUT = "line 4 `CLOSEI`: the hand is told to close here, and no step opens it after that"
KEEN = "line 19 `BREAK`: this step would stop the arm there, and is not executed then"
TURN = "angles -90 90 0, where this step leads: the tool is to turn by 180 degrees on it"

LED = {  # of a mutant: what its first chain says on the way, and the line at which it ends
    "04-lists-constant-0": (LOOP, 4),
    "01-while-constant-0": (WALK, 13),  # both numbers are told: 7 is the link before
    "01-while-operator-4": (SPUN, 25),
    "03-sense-2": (SHUT, 4),
    "03-corners-constant-1": (KEEN, 16),
    "03-sign-0": (TURN, 35),
    "04-height-0": ("`finish` is X 1049.1 Y 583 Z -199.9", 69),
    "04-lists-compound-0": ("line 12 `SET goal[4] = rim:stand_mid`", 72),
    "01-misspelt-0": ("no step and no line of data gives `can2_grip` a value", 26),
    "01-sense-0": ("where it could grip `can1`", 16),
    "01-sense-1": ("the hand is told to close here, while it holds `can1`", 21),
    "01-superfluous-step-4": ("10.3 s pass here without a motion", 4),
    "01-height-2": ("10 mm too low on it", 25),
    "01-copied-row-0": ("the hand takes hold of `can1` again here", 26),
    "02-superfluous-step-1": ("where this step leads", 9),
    "02-compound-2": ("line 3 `SET put = stand_mid`", 23),
    "02-tenfold-0": ("`rim` is X 0 Y 10.3 Z 18", 24),
    "01-exchanged-rows-0": ("`start` is `can1_grip`, passed here", 28),
}


@pytest.mark.parametrize("name", LED)
def test_a_chain_leads_to_the_mistake(name: str) -> None:
    (mutant,) = (one for one in mutants() if one.id == name)
    setting = load_task(mutant.task)
    file = ProgramFile(mutant.text.encode(), "prog.v2")
    a = assess(Request(file, setting, checks=Checks(causes=True)))
    first = a.chains[0]
    assert len(first.links) <= MOST
    says, ends = LED[name]
    told = [line(link, Hints.EDIT) for link in first.links]
    assert any(says in each for each in told), told
    assert first.blamed is not None
    assert first.blamed.span is not None
    assert first.blamed.span.line == ends, told
