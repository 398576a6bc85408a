"""How soon a session says what the way to the pointer touches, and what frames lose by it; printed.

Run by hand: `python -m pytest tests/bench/test_bench_way.py -s`. A real process of a session is
asked one question after the other, as a browser does while somebody drags the pointer over the
table; half of the questions are for lines. Beside it stands how late frames came without questions.
"""

import math
import random
import statistics
import time
from itertools import pairwise
from pathlib import Path

import pytest

from tests.unit.live.session.test_process import Piped
from vrts.live.actions import Go
from vrts.live.session.channel.messages import Act, AskReach, Reached, Ready

QUESTIONS = 200
ANSWER_MS = (60.0, 250.0)  # median and p95
LATE_MS = 5.0  # by which the p95 of the gaps between frames may grow
DOWN = (0.0, math.pi / 2, 0.0)


def gaps(piped: Piped, since: int) -> list[float]:
    """Return how long it took from frame to frame [ms]."""
    times = [time_s for time_s, _ in piped.frames[since:]]
    return [1000.0 * (b - a) for a, b in pairwise(times)]


def p95(values: list[float]) -> float:
    return statistics.quantiles(values, n=20)[-1]


@pytest.mark.parametrize("scene", ["cans-on-bases", "final-project"])
def test_ways_are_told_soon_and_frames_lose_nothing(scene: str, tmp_path: Path) -> None:
    piped = Piped(tmp_path, scene)
    try:
        piped.until(Ready)
        piped.send(Act(1, 0.0, "ada", Go((0.8, 0.1, 0.0), DOWN)))
        piped.listen(4.0)
        quiet = gaps(piped, len(piped.frames) - 150)
        since, took_ms, dice = len(piped.frames), list[float](), random.Random(1)
        for ref in range(QUESTIONS):
            at = (dice.uniform(0.6, 1.1), dice.uniform(-0.5, 0.5), dice.uniform(-0.3, 0.2))
            oat = (dice.uniform(-3.0, 3.0), dice.uniform(1.0, 1.57), 0.0)
            begun = time.monotonic()
            piped.send(AskReach(ref, at, oat, straight=ref % 2 == 1))
            piped.until(Reached, lambda n, ref=ref: isinstance(n, Reached) and n.ref == ref)
            took_ms.append(1000.0 * (time.monotonic() - begun))
        busy = gaps(piped, since)
    finally:
        piped.end()
    told = [news for news in piped.news if isinstance(news, Reached)]
    ways = {way: sum(r.way == way for r in told) for way in ("free", "touches", "unknown", "")}
    print(f"\n{scene}: {ways}")
    print(f"  answers: median {statistics.median(took_ms):.1f} ms, p95 {p95(took_ms):.1f} ms")
    print(f"  between frames, p95: {p95(quiet):.1f} ms, while it is asked {p95(busy):.1f} ms")
    assert ways["unknown"] == 0
    assert statistics.median(took_ms) < ANSWER_MS[0]
    assert p95(took_ms) < ANSWER_MS[1]
    assert p95(busy) < p95(quiet) + LATE_MS
