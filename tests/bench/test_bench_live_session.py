"""75 minutes of a session at 50 beats a second, on a clock that only the benchmark drives.

The budget of a beat is 2 ms of the processor (median): ten sessions share a core with room to
spare. Memory is that of the process: what is older than ten minutes is in a file, so it is flat
from then on. `VRTS_MINUTES=50` makes it shorter.
"""

import os
import resource
import statistics
import time
from collections import deque
from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import BEAT
from vrts.live.session.growing.past import FILE
from vrts.live.session.growing.tidying import Tidying

DOWN = (0.0, 1.5707963267948966, 0.0)
MINUTES = int(os.environ.get("VRTS_MINUTES", "75"))
SETTLED = 20  # [min] after which memory is compared
GROWTH = 0.05  # [MB] a minute at most from then on
LOOP = """\
.PROGRAM cycle()
    MOVE a
    FOR i = 1 TO 5
      MOVES SHIFT(a BY 0,60,0)
      TYPE "line ", i
      MOVES a
      SIGNAL 3
      OPENI
      SIGNAL -3
      CLOSEI
    END
    MOVE b
.END
.LOCATIONS
a 750 -150 0 0 90 0
b 750 150 0 0 90 0
.END
"""
ENDLESS = ".PROGRAM loop()\n 10 x = x + 1\n GOTO 10\n.END\n"


def by_hand(driven: Driven, minute: int) -> None:
    """Do what somebody with pointer and pendant does, about every two seconds."""
    for k in range(10):
        side = 0.1 if (minute + k) % 2 else -0.1
        driven.act(do.Go((0.75, side, 0.0), DOWN))
        beats(driven, 3.0)
        driven.act(do.Step("world", 2, 1 if k % 2 else -1, 0.05))
        beats(driven, 1.5)
        driven.act(do.Jog("joint", 5, 1 if k % 2 else -1, 1.0))
        for _ in range(5):
            beats(driven, 0.1)
            driven.act(do.Keep())
        driven.act(do.LetGo())
        driven.act(do.Typed("WHERE"))
        beats(driven, 1.0)
        begun = time.thread_time()
        driven.act(do.Typed("WHERE"))  # at rest it is carried out at once
        where.append(time.thread_time() - begun)


taken: deque[float] = deque(maxlen=3000)
where: deque[float] = deque(maxlen=50)
tidying: list[Tidying] = []


def beats(driven: Driven, seconds: float) -> None:
    """Let time pass, and note what every beat takes."""
    for _ in range(round(seconds / BEAT)):
        driven.clock_s += BEAT
        begun = time.thread_time()
        driven.session.beat()
        tidying[-1].beat(driven.session.growing.time_s)
        taken.append(time.thread_time() - begun)


@pytest.mark.parametrize("kind", ["by hand", "a program in a loop", "x = x + 1 for ever"])
def test_more_than_an_hour(tmp_path: Path, kind: str) -> None:
    driven = Driven(tmp_path)
    taken.clear()
    where.clear()
    sizes: list[float] = []
    tidying.append(Tidying())
    if kind != "by hand":
        name, text = ("cycle", LOOP) if "loop" in kind else ("loop", ENDLESS)
        driven.act(do.Upload(f"{name}.v2", text))
        driven.run(0.1)
        driven.typed("DO x = 0", f"EXECUTE {name},-1")
    print(f"\n{kind}")
    for minute in range(MINUTES):
        if kind == "by hand":
            by_hand(driven, minute)
        else:
            beats(driven, 60.0)
        driven.forget()
        sizes.append(resident() / 1e6)
        if minute % 5 == 4:
            recent = sorted(taken)
            machine = driven.session.growing.machine
            file = tmp_path / FILE
            kept = file.stat().st_size / 1e6 if file.exists() else 0.0
            print(
                f"  {minute + 1:2d} min: beat of {statistics.median(recent) * 1e3:.3f} ms median,"
                f" {recent[-30] * 1e3:.3f} ms p99, {recent[-1] * 1e3:.1f} ms most;"
                f" {sizes[-1]:.1f} MB, {len(machine.system.events):,} events,"
                f" {len(machine.system.planner.given.pieces):,} pieces, {kept:.2f} MB of history"
            )
            if where:
                print(f"          WHERE takes {statistics.median(where) * 1e3:.1f} ms")
    assert statistics.median(taken) < 2e-3
    horizon_s = driven.session.growing.time_s
    run = driven.session.run
    assert len(run.at(horizon_s - 599.0).configuration) == 6
    if MINUTES >= SETTLED + 30:
        half = (MINUTES - SETTLED) // 2  # the most of each: columns of numbers grow by leaps
        growth = (max(sizes[-half:]) - max(sizes[SETTLED:-half])) / half
        print(f"  memory: {growth:+.3f} MB a minute after the first {SETTLED}")
        assert growth < GROWTH
    begun = time.thread_time()
    driven.act(do.Rewind(0.5 * horizon_s))
    print(f"  back to {0.5 * horizon_s:.0f} s: {(time.thread_time() - begun) * 1e3:.0f} ms")
    assert driven.session.growing.time_s < 0.51 * horizon_s


def resident() -> int:
    """Return the memory in use now [bytes]."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize()
