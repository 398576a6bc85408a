"""Zones, upright objects and speed limits: judged and marked."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.support_programs import cans, ran, run_body
from vrts.base.pose import IDENTITY
from vrts.base.source import SourceFile
from vrts.check.curves.certified import Array, peak
from vrts.check.curves.timeline_arrays import curves
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.demand_check import check_demands
from vrts.check.verdicts.upright import tilt
from vrts.engine.run import Run
from vrts.pipeline.files import CHECKOUT

BODY = " MOVE a\n BREAK\n MOVES b"
POINT = Fraction(1)
SOLUTION = (CHECKOUT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8")
HEAD = '[task]\nscene = "cans-on-bases"\n[[goal]]\nobject = "can1"\non = "base2"\n'
TAIL = "[time]\nreference_s = 12\n"


@pytest.fixture(scope="module")
def line() -> Run:
    return run_body(BODY)


def one(run: Run, demand: Demand) -> Verdict:
    (found,) = check_demands(run, (demand,))
    return found


def task(text: str) -> Task:
    found, problems = read_task(SourceFile("task.toml", HEAD + text + TAIL), cans())
    assert found is not None, problems
    return found


def samples(run: Run) -> Array:
    return np.linspace(0.0, run.horizon_s, 4001)


def tips(run: Run) -> Array:
    found = [(run.at(t).X_WF @ run.scene.X_FT).translation for t in samples(run).tolist()]
    return np.array(found)


@pytest.mark.parametrize(("beside", "answer"), [(2e-4, Answer.HOLDS), (-2e-4, Answer.VIOLATED)])
def test_a_zone_beside_the_way_of_the_tool(line: Run, beside: float, answer: Answer) -> None:
    x = float(tips(line)[:, 0].max()) + beside
    zone = Demand(
        Keeps.TOOL_OUT, "glass", POINT, None, lower=(x, -9.0, -9.0), upper=(x + 1.0, 9.0, 9.0)
    )
    assert one(line, zone).answer is answer


def test_a_thin_zone_across_a_fast_motion_is_seen_where_it_is_met(line: Run) -> None:
    wall = Demand(
        Keeps.TOOL_OUT, "wall", POINT, None, lower=(0.8, 0.0, -1.0), upper=(1.0, 1e-4, 1.0)
    )
    found = one(line, wall)
    assert found.answer is Answer.VIOLATED
    (finding,) = found.findings
    assert finding.rule.code == "V432"
    assert finding.primary is not None
    assert finding.primary.span.text == "MOVES b"
    assert finding.moment is not None
    tip = (line.at(finding.moment.time_s).X_WF @ line.scene.X_FT).translation
    assert tip[1] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize(("factor", "answer"), [(1.001, Answer.HOLDS), (0.999, Answer.VIOLATED)])
def test_the_speed_of_the_tool_against_dense_samples(
    line: Run, factor: float, answer: Answer
) -> None:
    where, times = tips(line), samples(line)
    fastest = float((np.linalg.norm(np.diff(where, axis=0), axis=1) / np.diff(times)).max())
    assert one(line, Demand(Keeps.TOOL_SPEED, "", POINT, None, fastest * factor)).answer is answer


@pytest.mark.parametrize(("factor", "answer"), [(1.001, Answer.HOLDS), (0.999, Answer.VIOLATED)])
def test_the_speed_of_joints_against_dense_samples(
    line: Run, factor: float, answer: Answer
) -> None:
    q = np.array([line.at(t).configuration for t in samples(line).tolist()])
    rates = np.abs(np.diff(q, axis=0)) / np.diff(samples(line))[:, None]
    share = float((rates / np.array(line.scene.robot.arm.speed)).max())
    assert one(line, Demand(Keeps.JOINT_SPEED, "", POINT, None, share * factor)).answer is answer


@pytest.mark.thorough
def test_what_is_held_stays_upright_and_the_robot_out_of_zones() -> None:
    run = ran(SOLUTION, cans())
    asked = task(
        '[[upright]]\nobject = "can1"\nwithin_deg = 2\n'
        "[[zone]]\nname = 'sky'\nkeeps_out = 'robot'\nfrom_mm = [-900, -900, 3000]\n"
        "to_mm = [900, 900, 3100]\n"
        "[[zone]]\nname = 'all'\nkeeps_out = 'robot'\nfrom_mm = [-900, -900, 0]\n"
        "to_mm = [900, 900, 900]\npoints = 2\n"
    )
    verdicts = check_demands(run, asked.demands)
    assert [v.answer for v in verdicts] == [Answer.HOLDS, Answer.VIOLATED, Answer.HOLDS]
    assert verdicts[2].evidence["method"] == "certified on the polynomials"


def test_the_largest_tilt_is_that_of_dense_samples() -> None:
    run = run_body(" MOVE a\n READY")
    motion = curves(run.timeline.segments)
    poses = [run.at(t).X_WF for t in samples(run).tolist()]
    largest = max(math.acos(min(1.0, max(-1.0, pose.rotation[8]))) for pose in poses)
    angle = tilt(run.scene.robot.arm, IDENTITY, motion)
    below = peak(angle, motion.starts, motion.ends, largest - 1e-3)
    above = peak(angle, motion.starts, motion.ends, largest + 1e-3)
    assert below.above_s is not None
    assert (above.above_s, above.open_s) == (None, None)


def test_a_bound_that_never_closes_is_undetermined() -> None:
    def vague(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        return np.zeros_like(middle), np.where(end > 0.5, 2.0, 0.0)

    found = peak(vague, np.array([0.0]), np.array([0.6]), 1.0)
    assert found.above_s is None
    assert found.open_s == pytest.approx(0.5, abs=2e-5)


def test_what_is_not_kept_costs_its_points_and_the_time_bonus() -> None:
    scene = cans()
    run = ran(SOLUTION, scene)
    free = task("")
    asked = task("[[limit]]\ntool_mm_s = 10\npoints = 2.5\n")
    before = grade(free, run, judge(scene, run, free))
    after = grade(asked, run, judge(scene, run, asked))
    assert before.mark == 10
    assert after.mark == Fraction(6)
    assert after.demands == Fraction(5, 2)
    assert not after.ready
    assert sum(loss.points for loss in after.losses) == 10 - after.mark
    assert [loss.kind for loss in after.losses] == ["demand", "time"]
    assert "line " in after.losses[0].sentence


def test_what_cannot_be_told_costs_nothing_and_gives_the_lowest_mark() -> None:
    scene = cans()
    run = ran(SOLUTION, scene)
    asked = task("[[limit]]\ntool_mm_s = 9000\npoints = 2.5\n")
    found = judge(scene, run, asked)
    (kept,) = [v for v in found.verdicts if v.check == "demand tool speed"]
    doubt = replace(kept, answer=Answer.UNDETERMINED)
    open_one = replace(found, verdicts=(*(v for v in found.verdicts if v is not kept), doubt))
    sure, unsure = grade(asked, run, found), grade(asked, run, open_one)
    assert (sure.mark, sure.lowest, sure.ready) == (10, None, True)
    assert (unsure.mark, unsure.lowest, unsure.ready) == (10, Fraction(6), False)
    assert "to be reviewed: the mark is between 6.0 and 10.0" in unsure.obstacles


@pytest.mark.parametrize(
    ("text", "at"),
    [
        ("[[zone]]\nfrom_mm = [0, 0, 0]\nto_mm = [1, 0, 1]\n", "[1, 0, 1]"),
        ("[[limit]]\n", "[[limit]]"),
        ("[[limit]]\nsingular_value = 0.1\n", "[[limit]]"),
        ("[[limit]]\ntool_mm_s = 5\nwrist_deg = 5\n", "[[limit]]"),
        ('[[rule]]\nmust_use = "QQQ"\n', '"QQQ"'),
    ],
)
def test_errors_point_into_the_file(text: str, at: str) -> None:
    found, (problem,) = read_task(SourceFile("task.toml", HEAD + text + TAIL), cans())
    assert found is None
    assert problem.rule.code == "V431"
    assert problem.primary is not None
    assert problem.primary.span.text == at
