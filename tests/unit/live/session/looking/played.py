"""Blocks of the past evaluated as the browser does it."""

import base64
import gzip
import json
import zlib
from array import array
from bisect import bisect_right
from itertools import accumulate
from typing import Any

from vrts.live.session.channel.messages import Looked


def opened(looked: Looked) -> dict[str, Any]:
    """Return what an answer holds."""
    assert looked.why == ""
    return json.loads(gzip.decompress(base64.b64decode(looked.data)))


def coordinates(block: dict[str, Any], time_s: float) -> list[float]:
    """Return six joints [rad] and the hand opening [m] at a time [s]."""
    knots, counts, numbers = (
        array(kind, zlib.decompress(base64.b64decode(block["segments"][name])))
        for name, kind in (("knots", "d"), ("counts", "B"), ("coefficients", "f"))
    )
    k = min(max(bisect_right(knots, time_s) - 1, 0), len(knots) - 2)
    first = [0, *accumulate(int(n) for n in counts)]
    length = knots[k + 1] - knots[k]
    share = (min(max(time_s, knots[k]), knots[k + 1]) - knots[k]) / length if length else 0.0
    return [
        sum(c * share**n for n, c in enumerate(numbers[first[row] : first[row + 1]]))
        for row in range(7 * k, 7 * k + 7)
    ]


def in_force(rows: list[Any], time_s: float) -> Any:
    """Return the last row that is not after a time [s]; the first one when there is none."""
    starts = [float(row["start"] if "start" in row else row[0]) for row in rows]
    return rows[max(bisect_right(starts, time_s) - 1, 0)]
