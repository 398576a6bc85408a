"""Viewers for the benchmark of the live server: a process of its own, on the last core.

Reads a `Plan` as JSON from standard input, prints "measuring" when all viewers have settled, and a
`Seen` as JSON when it is over.
"""

import json
import os
import select
import sys
import time
from array import array
from typing import NamedTuple

from tests.bench.live_socket import LiveSocket, clock_offset, session_time

SETTLING = 4.0  # [s]


class Plan(NamedTuple):
    """Who connects, and for how long."""

    port: int
    seconds: float
    viewers: list[tuple[str, str, float]]  # cookie, room, clock at session time 0 [s]


class Seen(NamedTuple):
    """What all viewers together have seen; delays in ms, from the session time of a frame."""

    fps: float
    slowest_fps: float
    arrived: tuple[float, float, float]  # at the viewer's socket: p50, p95, p99
    read: tuple[float, float, float]  # by this process
    used_s: float  # processor time of this process


def percentiles(delays: "array[float]") -> tuple[float, float, float]:
    """Return p50, p95 and p99 [ms]."""
    ordered = sorted(delays)
    p50, p95, p99 = (1e3 * ordered[int(share * len(ordered))] for share in (0.5, 0.95, 0.99))
    return p50, p95, p99


class _Seeing:
    """All viewers, read one after another as something comes."""

    def __init__(self) -> None:
        self._poll = select.epoll()
        self._viewers: dict[int, tuple[LiveSocket, float]] = {}
        self.measures = False
        self.counts: dict[int, int] = {}
        self.arrived, self.read = array("d"), array("d")

    def join(self, viewer: LiveSocket, epoch_s: float) -> None:
        self._poll.register(viewer, select.EPOLLIN)
        self._viewers[viewer.fileno()] = (viewer, epoch_s)
        self.counts[viewer.fileno()] = 0

    def look(self, patience_s: float) -> None:
        """Take what there is, or what comes within a time [s]."""
        for number, _ in self._poll.poll(patience_s):
            viewer, epoch_s = self._viewers[number]
            for came in viewer.take():
                if came.opcode == 2 and self.measures:
                    sent_s = epoch_s + session_time(came.payload)
                    self.arrived.append(came.stamp_s - sent_s)
                    self.read.append(time.monotonic() - sent_s)
                    self.counts[number] += 1


def watch(plan: Plan) -> Seen:
    """Connect, let it settle, measure."""
    offset = clock_offset()
    seeing = _Seeing()
    for cookie, room, epoch_s in plan.viewers:
        seeing.join(LiveSocket(plan.port, cookie, offset, room=room), epoch_s)
        seeing.look(0.0)
    begin_s = time.monotonic() + SETTLING
    while time.monotonic() < begin_s:
        seeing.look(0.1)
    print("measuring", flush=True)
    used_s = time.process_time()
    seeing.measures = True
    end_s = time.monotonic() + plan.seconds
    while time.monotonic() < end_s:
        seeing.look(0.1)
    rates = [count / plan.seconds for count in seeing.counts.values()]
    return Seen(
        sum(rates) / len(rates),
        min(rates),
        percentiles(seeing.arrived),
        percentiles(seeing.read),
        time.process_time() - used_s,
    )


if __name__ == "__main__":
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    given = Plan(*json.load(sys.stdin))
    print(json.dumps(watch(given)._asdict()), flush=True)
