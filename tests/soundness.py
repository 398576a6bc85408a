"""Does the certified check miss contacts that sampling every 0.1 ms finds? Many random motions.

`python -m tests.soundness 10000` looks at that many motions of 0.5 to 1.5 s, half of them of degree
8, past rods and plates of 2 mm and posts that reach 1 to 3 mm past a fingertip, or hardly to it. It
prints beside it what sampling at 20 ms and at 1 ms would have missed. `--by liar` lets
somebody propose who lies.
"""

import argparse
import os
import statistics
import sys
import time
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from typing import NamedTuple

import numpy as np

from tests.near_misses import KINDS, NearMiss, near_miss, sampled
from tests.proposers import PROPOSERS
from vrts.check.collision.collision import check_collisions

PAST = (1e-3, 3e-3)  # [m] of the fingertip
BARELY = (0.0, 1e-3)  # [m] every other four: hardly a contact
CHUNK = 50  # motions given to a process at a time
JOBS = 2


class Outcome(NamedTuple):
    """What became of one motion."""

    seed: int
    kind: str
    touching: int  # instants of contact, of those every 0.1 ms
    missed_20_ms: bool
    missed_1_ms: bool
    found: bool
    undetermined: bool
    check_s: float  # processor time the check took
    sampling_s: float


def case(seed: int) -> NearMiss:
    """Return one motion."""
    past = PAST if seed // 4 % 2 == 0 else BARELY
    return near_miss(seed, high=seed // 8 % 2 == 1, past=past)


def outcome(seed: int, by: str = "coal") -> Outcome:
    """Check one motion, and sample it."""
    kind, scene, record, _ = motion = case(seed)
    before = time.process_time()
    report = check_collisions(scene, record, clearance=False, proposer=PROPOSERS[by]())
    between = time.process_time()
    times = sampled(motion)
    after = time.process_time()
    at = np.rint(times / 1e-4).astype(np.int64)
    return Outcome(
        seed,
        kind,
        len(times),
        len(times) > 0 and not (at % 200 == 0).any(),
        len(times) > 0 and not (at % 10 == 0).any(),
        kind in {event.second for event in report.contacts},
        kind in {event.second for event in report.undetermined},
        between - before,
        after - between,
    )


def missed(outcomes: Iterable[Outcome]) -> list[int]:
    """Return the seeds of motions with a contact that the check neither found nor left open."""
    return [o.seed for o in outcomes if o.touching and not o.found and not o.undetermined]


def told(outcomes: list[Outcome]) -> str:
    """Return the figures."""
    lines = [f"{len(outcomes)} motions of 0.5 to 1.5 s; contacts by sampling every 0.1 ms"]
    for kind in (*KINDS, None):
        own = [o for o in outcomes if o.touching and kind in (o.kind, None)]
        if not own:
            continue
        share_20, share_1 = (
            100 * sum(many) / len(own)
            for many in ([o.missed_20_ms for o in own], [o.missed_1_ms for o in own])
        )
        undetermined = sum(o.undetermined and not o.found for o in own)
        lines.append(
            f"  {kind or 'all':5s} {len(own):5d} contacts; missed by the certified check "
            f"{len(missed(own))} ({undetermined} undetermined), by sampling at 20 ms "
            f"{share_20:.1f} %, at 1 ms {share_1:.2f} %"
        )
    check, sampling = [o.check_s for o in outcomes], [o.sampling_s for o in outcomes]
    lines.append(
        f"  check {1e3 * statistics.median(check):.1f} ms of processor time a motion, "
        f"sampling {1e3 * statistics.median(sampling):.1f} ms (medians)"
    )
    hard = sorted((o for o in outcomes if o.touching), key=lambda o: o.touching)[:20]
    lines.append("  shortest: " + ", ".join(f"{o.seed} ({0.1 * o.touching:.1f} ms)" for o in hard))
    return "\n".join(lines)


def many(count: int, *, by: str = "coal", jobs: int = JOBS) -> list[Outcome]:
    """Look at many motions, in several processes; says on stderr how far it is."""
    found: list[Outcome] = []
    with ProcessPoolExecutor(jobs) as pool:
        for one in pool.map(partial(outcome, by=by), range(count), chunksize=CHUNK):
            found.append(one)
            if len(found) % 500 == 0:
                print(f"{len(found)} motions, missed {missed(found)}", file=sys.stderr, flush=True)
    return found


def main() -> int:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="Soundness of the certified check.")
    parser.add_argument("motions", type=int, nargs="?", default=2000)
    parser.add_argument("--by", choices=tuple(PROPOSERS), default="coal")
    parser.add_argument("--jobs", type=int, default=JOBS)
    chosen = parser.parse_args()
    found = many(chosen.motions, by=chosen.by, jobs=chosen.jobs)
    print(told(found))
    seeds = missed(found)
    print(f"missed: {seeds}" if seeds else "nothing missed")
    return 1 if seeds else 0


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
