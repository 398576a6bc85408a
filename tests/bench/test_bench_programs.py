"""Thousands of whole programs: internal faults, unfinished judgements, kinds of instructions.

Run by hand: `python -m pytest tests/bench/test_bench_programs.py -s -p no:xdist`. The environment
variable VRTS_PROGRAMS says how many; the numbers begin behind those of the suite.
"""

import os
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

from tests.whole_programs.figures import summed
from tests.whole_programs.trial import LIGHTLY, Looked, Outcome, trial

PROGRAMS = int(os.environ.get("VRTS_PROGRAMS", "5000"))
FIRST = 1000  # number
SAMPLE = 20  # of so many programs one is executed again, cut, continued, grown and forked
PROCESSES = 2
TOLD = 500  # after so many programs figures are printed


def tried(number: int) -> Outcome:
    return trial(number, Looked() if number % SAMPLE == 0 else LIGHTLY)


def test_random_programs_without_an_internal_fault() -> None:
    with ProcessPoolExecutor(PROCESSES, get_context("spawn")) as pool:
        outcomes: list[Outcome] = []
        for outcome in pool.map(tried, range(FIRST, FIRST + PROGRAMS), chunksize=10):
            outcomes.append(outcome)
            if len(outcomes) % TOLD == 0 or outcome.faults:
                print("\n" + "\n".join(summed(outcomes).lines()), flush=True)
    found = summed(outcomes)
    print("\n" + "\n".join(found.lines()))
    assert found.faults == ()
    assert found.missing == []
