"""Whole programs drawn by chance are executed, saved, loaded, cut, continued and forked.

Whatever goes wrong in them is a diagnostic, and every file that is written is read back: of runs,
of cut runs, of runs that grew under commands, and of forks. `tests/bench/test_bench_programs.py`
does the same with thousands.
"""

import pytest

from tests.whole_programs.figures import summed
from tests.whole_programs.trial import LIGHTLY, Looked, trial

FEW = 36  # programs that are always tried
MOST = 200  # programs in which every kind of instruction is carried out
CLOSELY = 12  # of so many programs one is looked at closely
MANY = range(FEW, FEW + 360, 60)  # each begins a group of as many


def looked(number: int) -> Looked:
    return Looked() if number % CLOSELY == 0 else LIGHTLY


@pytest.mark.thorough
def test_programs_of_every_kind_of_instruction() -> None:
    outcomes = [trial(number, looked(number)) for number in range(FEW)]
    while summed(outcomes).missing and len(outcomes) < MOST:
        outcomes.append(trial(len(outcomes), LIGHTLY))
    found = summed(outcomes)
    assert found.faults == ()
    assert found.missing == []


@pytest.mark.thorough
@pytest.mark.parametrize("first", MANY)
def test_more_programs(first: int) -> None:
    found = summed(trial(number, looked(number)) for number in range(first, first + MANY.step))
    assert found.faults == ()
