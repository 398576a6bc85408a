"""How many examples a law is tried with: few in a run that is waited for, all in `--all`."""

import os

ALL_NAME = "VRTS_ALL_EXAMPLES"
ALL = ALL_NAME in os.environ
FEWER = 4


def examples(number: int) -> int:
    """Return how many of so many examples are tried."""
    return number if ALL else max(5, number // FEWER)
