"""Figures of the certified collision check: soundness over 2,000 motions, and time.

Run with `pytest tests/bench/test_bench_collision.py -s`.
"""

import statistics
import time
from pathlib import Path

import numpy as np

from tests.collision_runs import Story
from tests.near_misses import near_miss, sampled
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.check.collision import check_collisions
from vrts.scene.model import Scene
from vrts.scene.scene_file import read_scene

ROOT = Path(__file__).parents[2]
MOTIONS = 2000


def test_nothing_is_missed_in_2000_near_misses() -> None:
    contacts = missed_20_ms = missed_1_ms = undetermined = 0
    missed: list[int] = []
    spent: list[float] = []
    for seed in range(MOTIONS):
        case = near_miss(seed)
        before = time.perf_counter()
        report = check_collisions(case.scene, case.record, clearance=False)
        spent.append(time.perf_counter() - before)
        times = sampled(case)
        undetermined += bool(report.undetermined)
        if not len(times):
            continue
        contacts += 1
        at = np.round(times / 1e-4).astype(np.int64)
        missed_20_ms += not (at % 200 == 0).any()
        missed_1_ms += not (at % 10 == 0).any()
        if case.kind not in {event.second for event in report.contacts}:
            missed.append(seed)
    print(
        f"\n{MOTIONS} motions of 0.5 to 1.5 s, {contacts} with contact (0.1 ms sampling): "
        f"certified check missed {len(missed)}; sampling at 20 ms missed "
        f"{100 * missed_20_ms / contacts:.1f} %, at 1 ms {100 * missed_1_ms / contacts:.2f} %; "
        f"{undetermined} undetermined; check {1e3 * statistics.median(spent):.1f} ms (median)"
    )
    assert missed == []
    assert contacts > MOTIONS / 2


def test_a_program_of_60_seconds_in_the_cans_scene() -> None:
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, _ = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None
    story = picks(scene)
    record = story.record()
    for clearance in (False, True):
        spent: list[float] = []
        report = check_collisions(scene, record, clearance=clearance)
        for _ in range(15):
            before = time.perf_counter()
            report = check_collisions(scene, record, clearance=clearance)
            spent.append(time.perf_counter() - before)
        what = "with certified clearance" if clearance else "contacts only"
        print(
            f"\n{story.t:.1f} s, {len(record.timeline.segments)} segments, {what}: "
            f"{1e3 * statistics.median(spent):.1f} ms (median of {len(spent)}), "
            f"{dict(report.statistics)}, {len(report.contacts)} contacts"
        )
        assert not report.contacts


def picks(scene: Scene) -> Story:
    """Both cans to the bases and back to where they stood, for 60 seconds."""
    story = Story(scene, scene.robot.arm.ready)
    places = scene.locations
    story.move(places["safe"])
    turn = 0
    while story.t < 60.0:
        can, base = ("can1", "base2") if turn % 4 in (0, 1) else ("can2", "base1")
        here, there = places[f"{can}_grip"], places[f"{base}_put"]
        support = base
        if turn % 2:
            here, there, support = there, here, "table"
        story.move(raised(here, 0.2), 0.4)
        story.line(here)
        story.grasp(can)
        story.line(raised(here, 0.3))
        story.line(raised(there, 0.3 + here.translation[2] - there.translation[2]), 0.4)
        story.line(there)
        story.release(can, support)
        story.line(raised(there, 0.2))
        story.move(places["safe"], 0.4)
        turn += 1
    return story


def raised(X_WP: Pose, height: float) -> Pose:
    """Return a pose further up."""
    x, y, z = X_WP.translation
    return Pose(X_WP.rotation, (x, y, z + height))
