"""Does the certified check miss contacts? Over 2,000 random motions, or as many as `MOTIONS` says.

Run with `MOTIONS=10000 pytest tests/bench/test_bench_soundness.py -s`.
"""

import os

from tests.soundness import many, missed, told


def test_nothing_is_missed_in_random_motions() -> None:
    found = many(int(os.environ.get("MOTIONS", "2000")))
    print("\n" + told(found))
    assert missed(found) == []
    assert sum(outcome.touching > 0 for outcome in found) > len(found) / 2
