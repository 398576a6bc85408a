"""How many examples a law is tried with: few in a run that is waited for, all in `--all`."""

import os
from collections.abc import Iterable

import pytest

ALL_NAME = "VRTS_ALL_EXAMPLES"
ALL = ALL_NAME in os.environ
FEWER = 4


def examples(number: int) -> int:
    """Return how many of so many examples are tried."""
    return number if ALL else max(5, number // FEWER)


def first(number: int, cases: Iterable[object]) -> list[object]:
    """Return values of a parameter, of which those after the first are thorough."""
    found = list(cases)
    later = (pytest.param(case, marks=pytest.mark.thorough) for case in found[number:])
    return [*found[:number], *later]
