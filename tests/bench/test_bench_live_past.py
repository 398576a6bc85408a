"""What it costs a session that 20 people look at its past: the pace of its frames.

Twenty minutes of a program that never rests, half of them in the file of what is older than ten
minutes; then ten seconds by the real clock, while nothing that was worked out is remembered: the
server asks for each minute once, here everybody asks anew, as fast as there are answers.
"""

import random
import statistics
import time
from contextlib import closing
from pathlib import Path

from tests.bench.test_bench_live_session import LOOP
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import BEAT, BLOCK, AskBlock, Left, Looked
from vrts.live.session.growing.tidying import Tidying
from vrts.live.session.looking.looker import MOST_WAITING, Looker

MINUTES = 20
SECONDS = 10.0  # measured
PEOPLE = 20
ENDLESS = (
    """\
.PROGRAM endless()
  10 CALL cycle
    GOTO 10
.END
"""
    + LOOP
)


def measured(driven: Driven, people: int) -> tuple[list[float], list[Looked], float]:
    """Beat by the real clock; return how late each beat ended [s], the answers, and their time."""
    answers: list[Looked] = []

    def take(told: Looked | Left) -> None:
        assert isinstance(told, Looked), told
        answers.append(told)

    asked, chance = 0, random.Random(3)
    late: list[float] = []
    tidying = Tidying()
    base = driven.clock_s - time.monotonic()
    begun = time.process_time()
    with closing(Looker(driven.session, take)) as looker:
        due = time.monotonic()
        end = due + SECONDS
        while due < end:
            while asked - len(answers) < min(people, MOST_WAITING):
                asked += 1
                looker.ask(AskBlock(asked, chance.randrange(MINUTES)))
            time.sleep(max(due - time.monotonic(), 0.0))
            driven.clock_s = base + time.monotonic()
            driven.session.beat()
            looker.beat()
            tidying.beat(driven.session.growing.time_s)
            late.append(time.monotonic() - due)
            driven.forget()
            due += BEAT
    return late, answers, time.process_time() - begun


def test_the_pace_of_frames_while_twenty_people_look_at_the_past(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.act(do.Upload("endless.v2", ENDLESS))
    driven.typed("EXECUTE endless", seconds=1.0)
    for _ in range(MINUTES):
        driven.run(BLOCK, beat_s=0.1)
        driven.forget()
    assert driven.session.growing.known_from_s > 5 * BLOCK
    for people in (0, PEOPLE):
        late, answers, used = measured(driven, people)
        assert all(answer.why == "" for answer in answers)
        cut = statistics.quantiles(late, n=100)
        size = statistics.mean(len(answer.data) for answer in answers) / 1000 if answers else 0.0
        print(
            f"\n{people:2d} people: beats late by p50 {1e3 * cut[49]:.1f}, p95 {1e3 * cut[94]:.1f},"
            f" p99 {1e3 * cut[98]:.1f}, most {1e3 * max(late):.1f} ms;"
            f" processor of the session {100 * used / SECONDS:.0f} %;"
            f" {len(answers) / SECONDS:.1f} minutes of the past a second, {size:.0f} kB each"
        )
        assert cut[94] < 0.020, "a frame of those 95 of 100 is left out"
