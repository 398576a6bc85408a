"""Via points with a direction and a speed: at one instant all must be true, told to the limit."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from tests.support_programs import cans, ran, run_body
from vrts.base.pose import Vector, distance, dot
from vrts.base.source import SourceFile
from vrts.base.units import DEG
from vrts.check.judge import judge
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task, ViaPoint
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts import via_search
from vrts.check.verdicts.via_verdict import verdicts
from vrts.check.verdicts.vias import Lack, passed
from vrts.engine.run import Run
from vrts.pipeline.files import CHECKOUT

HEAD = '[task]\nscene = "cans-on-bases"\n[[goal]]\nobject = "can1"\non = "base2"\n'
TAIL = "[time]\nreference_s = 12\n"
SOLUTION = (CHECKOUT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8")
MIDDLE = (0.9, 0.0, 0.1)  # of the line from `a` to `b`
DOWN = (0.0, 0.0, -1.0)


@pytest.fixture(scope="module")
def line() -> Run:
    """A straight line of 400 mm through the middle, with the hand level."""
    return run_body(" MOVE a\n BREAK\n SPEED 30\n MOVES b")


def task(text: str) -> Task:
    found, problems = read_task(SourceFile("task.toml", HEAD + text + TAIL), cans())
    assert found is not None, problems
    return found


def asked(run: Run, via: ViaPoint) -> Verdict:
    wanted = replace(task(""), vias=(via,))
    (found,) = verdicts(run, passed(run, wanted))
    return found


def seen(run: Run, radius: float) -> tuple[list[float], list[Vector], list[float]]:
    """Return times, directions and speeds of the tool within a radius of the middle, sampled."""
    times = [t for t in np.linspace(0.0, run.horizon_s, 20_001).tolist() if t > 0.0]
    poses = [run.at(t).X_WF @ run.scene.X_FT for t in times]
    near = [k for k, X in enumerate(poses) if distance(X.translation, MIDDLE) <= radius]
    step = times[1] - times[0]
    speeds = [distance(poses[k + 1].translation, poses[k - 1].translation) / 2 / step for k in near]
    return [times[k] for k in near], [poses[k].approach for k in near], speeds


@pytest.mark.parametrize(("beside", "answer"), [(0.02, Answer.HOLDS), (-0.02, Answer.VIOLATED)])
def test_the_cone_of_a_via_point_against_dense_samples(
    line: Run, beside: float, answer: Answer
) -> None:
    wanted = (math.sin(0.4), 0.0, -math.cos(0.4))
    _, directions, _ = seen(line, 0.05)
    least = min(math.acos(dot(direction, wanted)) for direction in directions)
    via = ViaPoint("gate", MIDDLE, 0.05, None, wanted, least + beside * DEG)
    found = asked(line, via)
    assert found.answer is answer
    assert [d.rule.code for d in found.findings] == (["V440"] if answer is Answer.VIOLATED else [])


@pytest.mark.parametrize(("factor", "answer"), [(1.002, Answer.HOLDS), (0.998, Answer.VIOLATED)])
def test_the_largest_speed_at_a_via_point_against_dense_samples(
    line: Run, factor: float, answer: Answer
) -> None:
    times, _, speeds = seen(line, 0.195)  # the tool slows down towards the end of the line
    via = ViaPoint("gate", MIDDLE, 0.195, None, fastest=min(speeds) * factor)
    found = asked(line, via)
    assert found.answer is answer
    if answer is Answer.VIOLATED:
        (finding,) = found.findings
        assert finding.rule.code == "V441"
        assert finding.primary is not None
        assert finding.primary.span.text == "MOVES b"
        assert finding.moment is not None
        slowest = times[speeds.index(min(speeds))]
        assert min(abs(finding.moment.time_s - t) for t in (times[0], times[-1], slowest)) < 0.01
        assert found.evidence["speed_mm_s"] == pytest.approx(1000.0 * min(speeds), abs=0.6)


@pytest.mark.parametrize(("factor", "answer"), [(0.998, Answer.HOLDS), (1.002, Answer.VIOLATED)])
def test_the_least_speed_at_a_via_point_against_dense_samples(
    line: Run, factor: float, answer: Answer
) -> None:
    _, _, speeds = seen(line, 0.05)
    via = ViaPoint("gate", MIDDLE, 0.05, None, slowest=max(speeds) * factor)
    assert asked(line, via).answer is answer


def test_all_must_be_true_at_one_instant() -> None:
    """The tool points down far from the point, and is level at it: neither makes the other good."""
    run = run_body(" MOVE a\n BREAK\n MOVES b")
    level = run.at(run.horizon_s).X_WF.approach
    away = (-level[0], -level[1], -level[2])
    wanted = replace(task(""), vias=(ViaPoint("gate", MIDDLE, 0.02, None, away, 0.3),))
    (lack,) = passed(run, wanted).lacks
    assert lack is Lack.DIRECTION
    still = ViaPoint("gate", MIDDLE, 0.02, None, level, 0.1, fastest=0.001)  # it stands at the ends
    assert passed(run, replace(wanted, vias=(still,))).lacks == (Lack.TOO_FAST,)


@pytest.mark.parametrize(
    ("text", "kind", "code"),
    [
        ("approach = [0, 0, 5]\n", "in the direction asked for", "V440"),
        ("speed_mm_s = [0, 10]\n", "slowly enough", "V441"),
        ("speed_mm_s = [9000, 9900]\n", "fast enough", "V441"),
        ("radius_mm = 1\n", "near enough", "V662"),
    ],
)
def test_what_is_missing_is_told_and_costs_the_via_points(text: str, kind: str, code: str) -> None:
    scene = cans()
    run = ran(SOLUTION, scene)
    wanted = task(f'[[via]]\nname = "camera"\nat_mm = [850, 0, 0]\n{text}').vias[0]
    if code != "V662":
        wanted = wanted._replace(point=(run.at(3.5).X_WF @ run.scene.X_FT).translation)
    asked_for = replace(task(""), vias=(wanted,))
    judgement = judge(scene, run, asked_for)
    (found,) = [v for v in judgement.verdicts if v.check == "via camera"]
    assert [d.rule.code for d in found.findings] == [code]
    result = grade(asked_for, run, judgement)
    assert (result.vias, result.mark) == (0, 6)
    losses = {loss.kind: loss for loss in result.losses}
    assert losses["via"].points == Fraction(5, 2)
    assert losses["via"].sentence.endswith(kind)
    assert losses["via"].moment is not None


def test_what_cannot_be_told_costs_nothing_and_gives_the_lowest_mark(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Bounds that are never halved prove nothing."""
    scene = cans()
    run = ran(SOLUTION, scene)
    wanted = task('[[via]]\nname = "camera"\nat_mm = [900, 30, 130]\nradius_mm = 20\n')
    sure = grade(wanted, run, judge(scene, run, wanted))
    assert (sure.mark, sure.lowest) == (6, None)
    monkeypatch.setattr(via_search, "MOST", 0)
    judgement = judge(scene, run, wanted)
    (found,) = [v for v in judgement.verdicts if v.check == "via camera"]
    assert found.answer is Answer.UNDETERMINED
    assert [d.rule.code for d in found.findings] == ["V442"]
    result = grade(wanted, run, judgement)
    assert (result.mark, result.lowest, result.ready) == (10, 6, False)


@pytest.mark.parametrize(
    ("text", "at"),
    [
        ("approach = [0, 0, 0]\n", "[0, 0, 0]"),
        ("cone_deg = 5\n", "5"),
        ("speed_mm_s = [20, 10]\n", "[20, 10]"),
    ],
)
def test_errors_point_into_the_file(text: str, at: str) -> None:
    source = SourceFile("task.toml", f"{HEAD}[[via]]\nat_mm = [1, 2, 3]\n{text}{TAIL}")
    found, (problem,) = read_task(source, cans())
    assert found is None
    assert problem.rule.code == "V443"
    assert problem.primary is not None
    assert problem.primary.span.text == at


def test_a_direction_is_read_with_its_cone_and_a_speed_with_its_range() -> None:
    text = "[[via]]\nat_mm = [1, 2, 3]\napproach = [0, 0, -3]\nspeed_mm_s = [20, 100]\n"
    (via,) = task(text).vias
    assert via.approach == DOWN
    assert via.cone == pytest.approx(math.radians(10.0))
    assert (via.slowest, via.fastest) == pytest.approx((0.02, 0.1))


def test_what_is_passed_after_the_longest_time_does_not_count(line: Run) -> None:
    via = ViaPoint("end", (0.9, -0.2, 0.1), 0.01, None)
    in_time = replace(task(""), vias=(via,), t_max=line.horizon_s + 1.0)
    assert passed(line, in_time).met == (True,)
    late = replace(in_time, t_max=line.horizon_s - 1.0)
    assert passed(line, late).lacks == (Lack.PLACE,)
