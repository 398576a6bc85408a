"""`python -m tests.adversary FIRST LAST`: figures of a shard of cases, five proposers on each.

With `--pads` these are grips: what is between the pads and beside them, held, set down and let go.

Tried until November 2026: 10,000 cases, of them 200 grips (40000 to 40100 and 40100 to 40200) and,
on the last code, 40000 to 40700 and 41000 to 41200. Missed 0, false 0, undetermined away from the
tolerance 0, told otherwise than with coal 0. A case that was tried is no news: take other numbers.
"""

import argparse
import statistics
import time
from collections import Counter
from typing import NamedTuple, TypeAlias

from tests.adversary import grip_rules, grips
from tests.adversary.cases import Case, case
from tests.adversary.judge import Group, Judge, Nearest, faults, judge_of
from tests.adversary.liars import HONEST, LYING, Made
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.near_misses import CERTAIN
from vrts.check.rounding import exact_mm, exact_s
from vrts.check.verdict import CollisionReport, ContactEvent, NearMiss
from vrts.geometry.proposing.proposer import Proposer

Told: TypeAlias = tuple[object, ...]
COUNTED = ("missed", "false", "undetermined")


class Found(NamedTuple):
    """What was found of one case."""

    seed: int
    name: str
    faults: dict[str, list[str]]  # of each proposer whose report says something of its own
    differ: list[str]  # proposers whose report differs from that with coal, moments apart
    moments: list[str]  # those that name another moment of the same depth or distance
    undetermined: dict[str, bool]
    seconds: dict[str, float]  # of processor time
    judging: float


def asked_of(seed: int, *, whole: bool) -> dict[str, Made]:
    """Return who proposes for a case: all, or coal, ourselves and three others in turn."""
    every = HONEST | LYING
    if whole:
        return every
    others = [name for name in every if name not in ("coal", "own")]
    turn = [others[(seed + k) % len(others)] for k in (0, 1, 3)]
    return {name: every[name] for name in ("coal", "own", *turn)}


def looked_at(seed: int, *, whole: bool = True, pads: bool = False) -> Found:
    """Check a case with proposers of all kinds, and judge what is reported."""
    it: Case = grips.case(seed) if pads else case(seed)
    made = asked_of(seed, whole=whole)
    reports: dict[str, CollisionReport] = {}
    seconds: dict[str, float] = {}
    for name, make in made.items():
        with make(seed) as proposer:
            reports[name], seconds[name] = _checked(it, proposer)
    before = time.process_time()
    judge = grip_rules.judge_of(it) if pads else judge_of(it)
    truth: dict[Group, Nearest] = {group: judge.nearest(group) for group in judge.groups}
    known: dict[Told, list[str]] = {}
    told = {name: rounded(report) for name, report in reports.items()}
    wrong: dict[str, list[str]] = {}
    plain = {name: rounded(report, moments=False) for name, report in reports.items()}
    differ = [name for name in plain if plain[name] != plain["coal"]]
    for name, report in reports.items():
        if told[name] not in known:
            known[told[name]] = faults(judge, report, truth)
        if known[told[name]]:
            wrong[name] = known[told[name]]
    return Found(
        seed,
        it.name,
        wrong,
        differ,
        [name for name in told if told[name] != told["coal"] and name not in differ],
        {name: bool(_open(judge, report)) for name, report in reports.items()},
        seconds,
        time.process_time() - before,
    )


def rounded(report: CollisionReport, *, moments: bool = True) -> Told:
    """Return everything that is told, rounded as it is before anything is scored or written.

    Near misses within 0.01 mm of their threshold are left out: nobody promises to tell them.

    Args:
        report: What is told.
        moments: With the moments at which it is deepest or nearest: while the arm stands still
            many are alike.
    """

    def touch(e: ContactEvent) -> Told:
        times = (e.start_s, e.end_s, *((e.deepest_s,) if moments else ()))
        return e.first, e.second, e.parts, *map(exact_s, times), exact_mm(e.depth_m)

    def miss(e: NearMiss) -> Told:
        times = (e.start_s, e.end_s, *((e.nearest_s,) if moments else ()))
        return e.first, e.second, e.parts, *map(exact_s, times), exact_mm(e.distance_m)

    touches = report.contacts, report.grazes, report.undetermined
    told: list[Told] = [tuple(map(touch, events)) for events in touches]
    certain = (report.near_miss_m or 0.0) - CERTAIN  # what is hardly a near miss may be told or not
    told.append(tuple(miss(e) for e in report.near_misses if e.distance_m < certain))
    if report.clearance is not None:
        nearest = report.clearance
        when = (exact_s(nearest.time_s),) if moments else ()
        told.append((*when, exact_mm(nearest.distance_m), *nearest.bodies))
    return tuple(told)


def _checked(it: Case, proposer: Proposer) -> tuple[CollisionReport, float]:
    before = time.process_time()
    report = check_collisions(it.scene, it.record, proposer=proposer)
    return report, time.process_time() - before


def _open(judge: Judge, report: CollisionReport) -> bool:
    return any((e.first, e.second) in judge.groups for e in report.undetermined)


def figures(found: list[Found]) -> str:
    """Return the figures of many cases."""
    lines = [f"{len(found)} cases"]
    for name in (*HONEST, *LYING):
        classes = Counter(
            words.partition(":")[0] for one in found for words in one.faults.get(name, ())
        )
        doubtful = sum(one.undetermined.get(name, False) for one in found)
        differ = sum(name in one.differ for one in found)
        moments = sum(name in one.moments for one in found)
        times = [one.seconds[name] for one in found if name in one.seconds]
        if times:
            lies = "lies" if name in LYING else ""
            rest = sum(classes.values()) - sum(classes[k] for k in COUNTED)
            counted = ", ".join(f"{k} {classes[k]}" for k in COUNTED)
            lines.append(
                f"  {name:10s} {lies:4s} {len(times):5d} cases: {counted} ({doubtful} with those"
                f" at the tolerance), other {rest}, otherwise than coal {differ}"
                f" and in the moment alone {moments};"
                f" median {1e3 * statistics.median(times):.0f} ms,"
                f" mean {1e3 * statistics.mean(times):.0f} ms"
            )
    lines.append(f"  judging {statistics.mean(one.judging for one in found):.2f} s a case")
    return "\n".join(lines)


def main() -> None:
    """Print what is wrong as it is found, and the figures in the end."""
    parser = argparse.ArgumentParser(prog="python -m tests.adversary")
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--whole", action="store_true", help="ask all proposers about each case")
    parser.add_argument("--pads", action="store_true", help="look at grips")
    asked = parser.parse_args()
    found: list[Found] = []
    for seed in range(asked.first, asked.last):
        one = looked_at(seed, whole=asked.whole, pads=asked.pads)
        found.append(one)
        for name, words in one.faults.items():
            print(f"{seed} {one.name}, {name}: {'; '.join(words)}", flush=True)
        if one.differ:
            print(f"{seed} {one.name}: {', '.join(one.differ)} otherwise than coal", flush=True)
        if len(found) % 100 == 0:
            print(figures(found), flush=True)
    print(figures(found))


if __name__ == "__main__":
    main()
