"""The mark's anchor values, its explanation on real runs, tasks and joint speeds."""

import math
from dataclasses import replace
from fractions import Fraction

import pytest

from tests.support_programs import ROOT, cans, codes, compiled, ran, run_body
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.mark.grade import Grade, Status
from vrts.check.mark.mark import grade, ungraded
from vrts.check.rules.scheme import TOTAL, MarkScheme
from vrts.check.task.score import UNTOUCHED, Achieved, Touched, rounded_mark, score
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.task.task_places import scene_name
from vrts.check.verdict import Answer
from vrts.check.verdicts.limits import check_limits
from vrts.check.verdicts.vias import in_order
from vrts.engine.controller import execute
from vrts.engine.run import Run

SCENE = cans()
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
TASK_TEXT = (EXAMPLE / "task.toml").read_text("utf-8")
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
PAR, LONGEST = Fraction(10), Fraction(20)
CLEAN = Achieved(
    goals=((Fraction(1), Fraction(1)),) * 4,
    vias=0,
    vias_met=0,
    touched=UNTOUCHED,
    completed=True,
    duration_s=PAR,
)
THREE_OF_FOUR = (*((Fraction(1), Fraction(1)),) * 3, (Fraction(1), Fraction(0)))
NOTHING = ((Fraction(1), Fraction(0)),) * 4

ANCHORS = [
    (CLEAN, "10"),
    (replace(CLEAN, duration_s=PAR * 3 / 2), "9.3"),
    (replace(CLEAN, duration_s=PAR * 2), "8.5"),
    (replace(CLEAN, duration_s=PAR * 5), "8.5"),
    (replace(CLEAN, touched=Touched(1)), "7.0"),
    (replace(CLEAN, touched=Touched(2)), "6.0"),
    (replace(CLEAN, touched=Touched(5)), "3.5"),
    (replace(CLEAN, touched=Touched(50)), "3.5"),
    (replace(CLEAN, completed=False), "8.5"),
    (replace(CLEAN, vias=2, vias_met=2), "10"),
    (replace(CLEAN, vias=2, vias_met=1), "7.3"),
    (replace(CLEAN, goals=NOTHING), "0"),
    (replace(CLEAN, goals=NOTHING, touched=Touched(3)), "0"),
]


@pytest.mark.parametrize(("achieved", "mark"), ANCHORS)
def test_anchor(achieved: Achieved, mark: str) -> None:
    assert rounded_mark(score(achieved, MarkScheme(), PAR, LONGEST), TOTAL) == Fraction(mark)


def test_three_goals_of_four_with_via_points_earn_seven() -> None:
    achieved = replace(CLEAN, goals=THREE_OF_FOUR, vias=3, vias_met=3)
    assert rounded_mark(score(achieved, MarkScheme(), PAR, LONGEST), TOTAL) == 7


def task(text: str = TASK_TEXT) -> Task:
    found, problems = read_task(SourceFile("task.toml", text), SCENE)
    assert found is not None, problems
    return found


def graded(run: Run, wanted: Task) -> Grade:
    return grade(wanted, run, judge(SCENE, run, wanted))


def solution(old: str = "", new: str = "") -> Run:
    assert old in SOLUTION
    return execute(compiled(SOLUTION.replace(old, new) if old else SOLUTION), SCENE)


RUNS = [
    ("", "", 10.0, 10.0),
    ("SPEED 100 ALWAYS", "SPEED 30 ALWAYS", 8.0, 9.9),
    ("        CALL carry(can2_grip, base1_put)\n", "", 3.0, 6.0),
    ("        OPENI                           ; a run", "        ; a run", 0.0, 3.0),
    ("APPRO goal, 120\n        SPEED 20", "APPRO goal, 20\n        SPEED 20", 0.0, 10.0),
    ("        MOVES goal\n", "", 0.0, 9.0),
    ("MOVES start ", "MOVES nowhere ", 0.0, 1.0),
    ("1100.00   230.00", "1112.00   230.00", 6.0, 9.9),
]


@pytest.mark.parametrize(("old", "new", "least", "most"), RUNS)
def test_losses_add_up_to_what_is_missing(old: str, new: str, least: float, most: float) -> None:
    found = graded(solution(old, new), task())
    assert sum(loss.points for loss in found.losses) == 10 - found.mark
    assert least <= found.mark <= most
    assert all(loss.points for loss in found.losses)
    assert all(loss.sentence for loss in found.losses)
    assert found.ready is not bool(found.obstacles)


def test_the_reference_solution_is_ready() -> None:
    found = graded(solution(), task())
    assert found.ready
    assert found.losses == ()
    assert found.status is Status.GRADED


def test_what_costs_too_little_to_be_shown_is_named_where_points_for_speed_are_lost() -> None:
    found = graded(solution("1100.00   230.00", "1110.10   230.00"), task())
    (loss,) = found.losses
    wrong = "`can1` is 10.1 mm from its goal"
    assert loss.points == Fraction(3, 2)
    assert loss.sentence == f"points for speed are given only when nothing else is wrong: {wrong}"
    assert loss.hint.startswith("look at the end of the replay")


def test_an_empty_program_earns_nothing() -> None:
    found = graded(ran(".PROGRAM main\n.END\n", SCENE), task())
    assert found.mark == 0
    assert not found.ready


def test_what_does_not_compile_earns_nothing() -> None:
    found = ungraded(task(), Status.DOES_NOT_COMPILE, ())
    assert (found.mark, found.ready) == (0, False)
    assert sum(loss.points for loss in found.losses) == 10


def test_a_run_time_error_keeps_what_was_achieved() -> None:
    found = graded(
        solution("CALL carry(can2_grip, base1_put)", "MOVE TRANS(3000,0,0,90,90,0)"), task()
    )
    assert found.status is Status.STOPPED
    assert found.mark > 3
    assert any(loss.kind == "program" for loss in found.losses)


ORDERS: list[tuple[list[list[tuple[float, float]]], list[bool]]] = [
    ([[(0, 1)], [(2, 3)], [(4, 5)]], [True, True, True]),
    ([[(4, 5)], [(2, 3)], [(6, 7)]], [False, True, True]),
    ([[(0, 1)], [], [(4, 5)]], [True, False, True]),
    ([[(9, 10)], [(2, 3)], [(4, 5)]], [False, True, True]),
    ([[(0, 1), (8, 9)], [(2, 3)]], [True, True]),
    ([[(0, 5)], [(1, 2)]], [True, True]),
    ([], []),
]


@pytest.mark.parametrize(("visits", "met"), ORDERS)
def test_the_most_via_points_in_order(
    visits: list[list[tuple[float, float]]], met: list[bool]
) -> None:
    assert in_order(visits) == met


VIA = '\n[[via]]\nname = "gate"\nat_mm = [{}]\nradius_mm = 30\n'


@pytest.mark.parametrize(
    ("place", "answer"), [("900, 30, 100", "holds"), ("0, 0, 1500", "violated")]
)
def test_via_points_are_passed_or_missed(place: str, answer: str) -> None:
    wanted = task(TASK_TEXT + VIA.format(place))
    verdicts = judge(SCENE, solution(), wanted, collisions=False).verdicts
    (found,) = [verdict for verdict in verdicts if verdict.check == "via gate"]
    assert found.answer.value == answer
    assert [d.rule.code for d in found.findings] == ([] if answer == "holds" else ["V662"])


FAULTS = [
    ('object = "can1"', 'object = "base1"', "V651", '"base1"'),
    ('on = "base2"', 'on = "can1"', "V652", '"can1"'),
    ('object = "can2"', 'object = "can1"', "V653", '"can1"'),
    ("reference_s = 10.6", "t_par_s = 20\nt_max_s = 10", "V654", "10"),
    ("reference_s", "referenc_s", "V602", "referenc_s"),
    ("position_mm = 10", "position_mm = -1", "V605", "-1"),
    ('object = "can1"', 'object = "can7"', "V606", '"can7"'),
]


@pytest.mark.parametrize(("old", "new", "code", "place"), FAULTS)
def test_faults_of_a_task_point_into_its_file(old: str, new: str, code: str, place: str) -> None:
    text = TASK_TEXT.replace(old, new, 1)
    found, problems = read_task(SourceFile("task.toml", text), SCENE)
    assert found is None
    first = next(problem for problem in problems if problem.rule.code == code)
    assert first.primary is not None
    span = first.primary.span
    assert text[span.start : span.end] == place


def test_the_scene_of_a_task_is_known_first() -> None:
    assert scene_name(SourceFile("task.toml", TASK_TEXT)) == ("cans-on-bases", ())


def test_joint_motions_keep_within_limits() -> None:
    found = check_limits(run_body("MOVE a\nMOVE b\nREADY"))
    assert found.answer is Answer.HOLDS
    assert 0.9 < found.evidence["largest_speed_share"] <= 1.0 + 1e-6  # type: ignore[operator]


def test_a_line_close_to_a_singular_wrist_is_too_fast() -> None:
    text = (
        ".PROGRAM main\nDRIVE 2, 45, 100\nDRIVE 3, 30, 100\nDRIVE 5, 6, 100\nHERE p\n"
        "SPEED {} MMPS\nMOVES SHIFT(p BY 0,-400,0)\n.END\n"
    )
    run = ran(text.format(500))
    assert codes(run) == ["V302"]  # told on the way, too
    found = check_limits(run)
    assert found.answer is Answer.VIOLATED
    (finding,) = found.findings
    assert finding.rule.code == "V302"
    joint = finding.data["joint"]
    limit = finding.data["limit_deg_s"]
    assert isinstance(joint, int)
    assert limit == pytest.approx(math.degrees(run.scene.robot.arm.speed[joint - 1]))
    assert finding.moment is not None
    speed = run.at(finding.moment.time_s).velocity[joint - 1]
    assert math.degrees(abs(speed)) == pytest.approx(finding.data["speed_deg_s"], rel=0.05)
    assert check_limits(ran(text.format(100))).answer is Answer.HOLDS


def test_how_far_an_object_is_from_its_goal_is_evidence_also_where_it_is_reached() -> None:
    verdicts = judge(SCENE, solution(), task(), collisions=False).verdicts
    evidence = [v.evidence for v in verdicts if v.check.startswith("target ")]
    assert [found["share"] for found in evidence] == [1.0, 1.0]
    assert all(0.0 <= found["position_mm"] < 1.0 for found in evidence)  # type: ignore[operator]
