"""What is too fast is found by its peak, also where a quick look comes first."""

import random

import pytest

from vrts.engine.motion.overspeed import LOOKS, SPEED_TOLERANCE, fastest, none_too_fast
from vrts.engine.motion.polynomials import rate

LIMITS = (2.0, 1.0, 3.0, 4.0, 5.0, 2.5)
Rows = tuple[tuple[float, ...], ...]


def _peak(row: tuple[float, ...], length: float) -> float:
    looks = 64 * LOOKS
    return max(abs(rate(row, length * k / looks)) for k in range(looks + 1))


@pytest.mark.parametrize("seed", range(40))
def test_the_quick_look_says_what_the_peaks_say(seed: int) -> None:
    """Of polynomials of every degree that lines and corners have, near the limit and far."""
    chance = random.Random(seed)
    length = chance.uniform(0.01, 0.5)
    pieces: list[tuple[float, float, Rows]] = []
    for _ in range(3):
        rows: list[tuple[float, ...]] = []
        for limit in LIMITS:
            free = tuple(chance.uniform(-1.0, 1.0) for _ in range(chance.choice((1, 2, 3, 4, 5))))
            peak = _peak(free, length) if len(free) > 1 else 0.0
            wanted = limit * chance.choice((0.3, 0.999, 1.0))
            rows.append(tuple(c * wanted / peak for c in free) if peak else free)
        pieces.append((0.0, length, tuple(rows)))
    for operator in (1.0, 0.5, 1.0001, 1.1):
        exact = fastest(pieces, LIMITS).share * operator <= 1.0 + SPEED_TOLERANCE / 2.0
        assert none_too_fast(pieces, LIMITS, operator) == exact


def test_a_peak_between_the_ends_of_a_piece_is_too_fast() -> None:
    bump = (0.0, 0.0, 3.0 * LIMITS[0], -2.0 * LIMITS[0])  # at rest at both ends, 1.5 between
    still = ((0.0,),) * 5
    assert not none_too_fast([(0.0, 1.0, (bump, *still))], LIMITS, 1.0)
    assert none_too_fast([(0.0, 1.0, (bump, *still))], LIMITS, 0.6)
