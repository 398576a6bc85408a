"""Motions laid end to end have nothing to do with each other: what touches in one hides nothing."""

import numpy as np

from vrts.check.collision.pairs.findings import Touch
from vrts.check.collision.pairs.table import Pairs
from vrts.check.collision.search.known_events import KnownEvents, Times

NO = np.zeros(1, dtype=np.bool_)
FIRST, SECOND = np.zeros(1, dtype=np.int64), np.ones(1, dtype=np.int64)
PAIRS = Pairs(FIRST, SECOND, np.zeros(1), np.full(1, 9.0), np.full(1, 2e-4), NO, NO, FIRST)
TOUCHES = [Touch(0, t, t, t, -1e-3) for t in (1.0, 1.4)]
BETWEEN = Times(FIRST, np.array([1.1]), np.array([1.11]))


def matters(begins: list[float]) -> float:
    """Return how near the pair must come between two touches to matter."""
    known = KnownEvents(PAIRS, np.zeros(1), nearest=False, begins=np.array(begins))
    known.touched(TOUCHES)
    return float(known.matters(BETWEEN, np.zeros(1))[0])


def test_between_two_touches_of_one_motion_nothing_is_looked_for() -> None:
    assert matters([]) == -np.inf
    assert matters([0.5, 3.0]) == -np.inf


def test_between_touches_of_two_motions_everything_is_looked_for() -> None:
    assert matters([1.2]) == np.inf
    assert matters([1.05]) == np.inf
