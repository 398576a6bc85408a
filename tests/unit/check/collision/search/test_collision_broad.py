"""Boxes of whole bodies drop no row that boxes of single pieces would keep."""

import numpy as np

from tests.support_forty import forty_objects
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.arm_state import instants_of
from vrts.check.collision.pairs.outside import outside
from vrts.check.collision.pairs.pairs import plan
from vrts.check.collision.search.broad import gaps, sides_of
from vrts.check.curves.timeline_arrays import curves
from vrts.engine.memory.records import GRAVITY, Lie
from vrts.geometry.solids import Motion
from vrts.ir.instructions import Interpolation

NEAR = 0.02  # [m]


def test_no_row_is_dropped_that_may_come_near() -> None:
    run = forty_objects()
    motion = curves(run.timeline.segments)
    solids, pairs = plan(run.scene, run, motion)[:2]
    cuts = np.unique([pairs.start_s.min(), *pairs.start_s, *pairs.end_s])
    start, end = cuts[:-1], np.minimum(cuts[1:], cuts[:-1] + 0.2)
    middle, half = 0.5 * (start + end), 0.5 * (end - start)
    spread, values = motion.spread(start, end), motion.values(middle)
    turn = np.maximum(spread.upper - values, values - spread.lower)
    state = instants_of(run.scene.robot.arm, values, middle)
    around = Motion(half, turn[:, :6], turn[:, 6])
    sides = sides_of(solids, pairs)
    blocks = gaps(solids, pairs, sides, state, around, (start, end), NEAR)
    node, row = blocks.rows(np.arange(len(blocks.node)))
    kept = set(zip(node.tolist(), row.tolist(), strict=True))
    assert len(kept) == len(node)
    needed = 0
    active = (pairs.start_s[None, :] <= start[:, None]) & (end[:, None] <= pairs.end_s[None, :])
    for k in range(0, len(start), 2):
        rows = np.nonzero(active[k])[0]
        count = len(rows)
        each = np.concatenate([sides.outer[rows], sides.inner[rows]])
        at = np.full(2 * count, k)
        places = solids.places(state, each, at, GRAVITY)
        bound = solids.travel(state, around, each, at, places.centres)[0]
        gap = outside(places, np.arange(count), np.arange(count) + count)
        least = gap - bound[sides.inner_frame[rows], np.arange(count)]
        near = rows[least < NEAR].tolist()
        assert {(k, r) for r in near} <= kept
        needed += len(near)
    assert needed > 50
    assert len(kept) < 0.1 * active.sum()  # and most are dropped


def test_the_program_among_forty_objects_is_what_the_figures_say() -> None:
    run = forty_objects()
    straight = [m.interpolation is Interpolation.LINEAR for m in run.motions]
    held = [p for own in run.placements.values() for p in own if p.lie is Lie.HELD]
    assert abs(run.horizon_s - 60.0) < 0.5
    assert len(run.scene.bodies) == 1 + 40  # with the floor
    assert sum(straight) == len(straight) / 2
    assert len(held) == 6
    report = check_collisions(run.scene, run)
    assert report.certified
    assert not report.contacts
    assert report.clearance is not None
    assert abs(report.clearance.distance_m - 5.72e-3) < 1e-4
