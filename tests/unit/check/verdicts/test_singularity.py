"""Distances from singularities on straight lines: measured, bounded, against dense samples."""

import math
from fractions import Fraction
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import pytest

from tests.support_programs import cans, run_body
from tests.unit.robots.test_every_robot import PICK_AND_PLACE, run_in, scene_of
from vrts.base.source import SourceFile
from vrts.check.curves.timeline_arrays import curves
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer
from vrts.check.verdicts.demand_check import check_demands
from vrts.check.verdicts.limits import check_limits
from vrts.check.verdicts.singularity import nearness, on_lines
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.branch import shoulder_reach
from vrts.robots.kinematics.chain import chain, columns, extent
from vrts.robots.model import SerialArm

Array: TypeAlias = npt.NDArray[np.float64]

BODY = " MOVE a\n BREAK\n MOVES b\n BREAK\n MOVE a"
NAMES = {
    Keeps.WRIST: ("wrist_deg", math.degrees(1.0)),
    Keeps.ELBOW: ("elbow_deg", math.degrees(1.0)),
    Keeps.SHOULDER: ("shoulder_mm", 1000.0),
    Keeps.SINGULAR: ("singular_value", 1.0),
}


@pytest.fixture(scope="module")
def line() -> Run:
    return run_body(BODY)


def on_the_line(run: Run) -> list[tuple[float, ...]]:
    """Return configurations along the straight lines of a run, sampled."""
    times: list[float] = []
    for motion in run.motions:
        if motion.interpolation is Interpolation.LINEAR:
            times += np.linspace(motion.start_s, motion.end_s, 4001).tolist()
    return [run.at(t).configuration for t in times]


def smallest(run: Run, keeps: Keeps) -> float:
    """Return the smallest distance along the straight lines of a run, by other means."""
    arm = run.scene.robot.arm
    if isinstance(arm, SerialArm):
        matrices = [columns(chain(arm, q), extent(arm)) for q in on_the_line(run)]  # type: ignore[arg-type]
        return float(np.linalg.svd(np.array(matrices), compute_uv=False)[:, -1].min())
    if keeps is Keeps.SHOULDER:
        return min(abs(shoulder_reach(arm, q)) for q in on_the_line(run))  # type: ignore[arg-type]
    joint, zero = (4, 0.0) if keeps is Keeps.WRIST else (2, math.atan2(arm.d4, arm.a3))
    angles = np.array([q[joint] for q in on_the_line(run)]) - zero
    return float(np.abs(angles - np.pi * np.round(angles / np.pi)).min())


@pytest.mark.parametrize("keeps", [Keeps.WRIST, Keeps.ELBOW, Keeps.SHOULDER])
def test_a_limit_turns_where_dense_samples_say(line: Run, keeps: Keeps) -> None:
    nearest = smallest(line, keeps)
    for change, answer in ((-1e-3, Answer.HOLDS), (1e-3, Answer.VIOLATED)):
        demand = Demand(keeps, keeps.value, Fraction(1), None, nearest + change)
        (found,) = check_demands(line, (demand,))
        assert found.answer is answer
        if answer is Answer.VIOLATED:
            (finding,) = found.findings
            assert finding.rule.code == "V435"
            assert finding.primary is not None
            assert finding.primary.span.text == "MOVES b"


@pytest.mark.parametrize("keeps", [Keeps.WRIST, Keeps.ELBOW, Keeps.SHOULDER])
def test_distances_are_measured_in_every_run(line: Run, keeps: Keeps) -> None:
    name, unit = NAMES[keeps]
    evidence = check_limits(line).evidence
    assert evidence[name] == pytest.approx(unit * smallest(line, keeps), abs=0.06)
    moment = evidence[f"{name.rpartition('_')[0]}_at_s"]
    assert isinstance(moment, float)
    (lines,) = [m for m in line.motions if m.interpolation is Interpolation.LINEAR]
    assert lines.start_s <= moment <= lines.end_s


@pytest.fixture(scope="module")
def other_arm() -> Run:
    return run_in(scene_of("ur5"), PICK_AND_PLACE)


def test_other_arms_have_a_smallest_singular_value(other_arm: Run) -> None:
    nearest = smallest(other_arm, Keeps.SINGULAR)
    assert check_limits(other_arm).evidence["singular_value"] == pytest.approx(nearest, abs=1e-3)
    for factor, answer in ((0.99, Answer.HOLDS), (1.01, Answer.VIOLATED)):
        demand = Demand(Keeps.SINGULAR, "singular value", Fraction(1), None, nearest * factor)
        (found,) = check_demands(other_arm, (demand,))
        assert found.answer is answer
        assert found.evidence["smallest"] == pytest.approx(nearest, abs=1e-3)


@pytest.mark.parametrize("which", ["line", "other_arm"])
def test_bounds_hold_at_random_instants(which: str, request: pytest.FixtureRequest) -> None:
    """No sample inside an interval may be nearer to a singularity than its bound allows."""
    run: Run = request.getfixturevalue(which)
    motion = curves(run.timeline.segments)
    start, end = on_lines(run, motion)
    random = np.random.default_rng(7)
    a = start + random.random(len(start)) * 0.5 * (end - start)
    b = a + random.random(len(start)) * (end - a)
    for keeps in (
        [Keeps.WRIST, Keeps.ELBOW, Keeps.SHOULDER] if which == "line" else [Keeps.SINGULAR]
    ):
        quantity = nearness(keeps, run.scene.robot.arm, motion)
        _, upper = quantity(a, 0.5 * (a + b), b)
        for share in (0.0, 0.3, 0.7, 1.0):
            t = a + share * (b - a)
            value, _ = quantity(t, t, t)
            assert (value <= upper + 1e-12).all()


def test_ready_and_joint_motions_do_not_count() -> None:
    """Every run begins in READY, where all three distances are zero."""
    run = run_body(" READY\n MOVE a\n MOVE b\n READY")
    assert "wrist_deg" not in check_limits(run).evidence
    demand = Demand(Keeps.WRIST, "wrist singularity", Fraction(1), None, 0.5)
    (found,) = check_demands(run, (demand,))
    assert (found.answer, found.summary) == (Answer.HOLDS, "there is no straight line")


@pytest.mark.parametrize(
    ("key", "keeps", "limit"),
    [
        ("wrist_deg = 10", Keeps.WRIST, math.radians(10)),
        ("elbow_deg = 20", Keeps.ELBOW, math.radians(20)),
        ("shoulder_mm = 150", Keeps.SHOULDER, 0.15),
    ],
)
def test_limits_are_read(key: str, keeps: Keeps, limit: float) -> None:
    text = (
        '[task]\nscene = "cans-on-bases"\n[[goal]]\nobject = "can1"\non = "base2"\n'
        f"[[limit]]\n{key}\n[time]\nreference_s = 12\n"
    )
    task, problems = read_task(SourceFile("task.toml", text), cans())
    assert task is not None, problems
    (demand,) = task.demands
    assert (demand.keeps, demand.name) == (keeps, keeps.value)
    assert demand.limit == pytest.approx(limit)
