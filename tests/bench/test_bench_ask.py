"""How many questions of beginners find their page, and what an answer costs of the processor.

Run by hand: `python -m pytest tests/bench/test_bench_ask.py -s -p no:xdist`.
"""

import resource
import subprocess
import sys

import pytest

from tests.questions import HARDER, LEAST, answered, questions, report, sets

ASKED = ("MOVES", "wait 2 seconds", "V301", "how do I put marks into Moodle")
TIMES = 5
MOST_SECONDS = 0.3


@pytest.mark.parametrize("name", sets())
def test_questions(name: str) -> None:
    asked = questions(name)
    found = answered(asked)
    print(f"\n{report(name, found)}")
    assert sum(each.fits for each in found) >= LEAST * len(asked) // 50


@pytest.mark.parametrize("name", sets(HARDER))
def test_harder_questions(name: str) -> None:
    """Printed only: the search was not fitted to them."""
    print(f"\n{report(name, answered(questions(name, HARDER)))}")


@pytest.mark.parametrize("asked", ASKED)
def test_seconds_of_the_processor(asked: str) -> None:
    """With the start of Python, the least of some calls."""
    used: list[float] = []
    for _ in range(TIMES):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [sys.executable, "-m", "vrts.cli.main", "manual", asked]
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    print(f"\nvrts manual {asked}: {min(used):.2f} s of the processor")
    assert min(used) < MOST_SECONDS
