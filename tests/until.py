"""Until when tests may begin: `python -m tests --minutes=N` skips the thorough ones that are later.

A slow machine must not keep everybody waiting, and what it left out it says. Which tests those are
is another with each commit.
"""

import os
import random
import subprocess
import time
from collections.abc import Iterable, Sequence
from typing import TypeVar

import pytest

from tests.places import ROOT

T = TypeVar("T")

NAME = "VRTS_TESTS_UNTIL"  # environment: an instant of the monotonic clock [s]
REASON = "no time is left"


def limit() -> float | None:
    """Return when tests may begin at the latest, by the monotonic clock [s]; None: always."""
    return float(os.environ[NAME]) if NAME in os.environ else None


def skip_if_over() -> None:
    """Skip the test that is about to begin where it is too late."""
    latest = limit()
    if latest is not None and time.monotonic() > latest:
        pytest.skip(REASON)


def shuffled(these: Iterable[T]) -> list[T]:
    """Return things in an order that is another with each commit."""
    words = ["git", "rev-parse", "HEAD"]
    commit = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    found = list(these)
    random.Random(commit).shuffle(found)
    return found


def left_out(skipped: Sequence[pytest.TestReport]) -> int:
    """Return how many of the tests that were skipped came too late."""
    return sum(isinstance(one.longrepr, tuple) and REASON in one.longrepr[2] for one in skipped)
