"""Limits of the robot: whoever breaks or moves one never gains by it, and reads it first."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from tests.support_programs import ROOT, cans, codes, compiled, ran
from vrts.base.source import SourceFile
from vrts.check.goals.reached import judged_at
from vrts.check.goals.too_fast import overruns
from vrts.check.judge import judge
from vrts.check.mark.grade import Grade
from vrts.check.mark.mark import grade
from vrts.check.rules.settings import INSTALLED, USUAL_LOCKS
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer
from vrts.check.verdicts.duration import duration
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.system import PARAMETERS
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import simulate

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
TASK_TEXT = (EXAMPLE / "task.toml").read_text("utf-8")
SLOWLY = SOLUTION.replace("SPEED 100 ALWAYS", "SPEED 40 ALWAYS")
SCENE = cans()


def marked(text: str, dialect: str | None = None) -> Assessment:
    setting = load_task(EXAMPLE)
    found = assess(Request(ProgramFile(text.encode(), "a.v2"), setting, Reading(dialect)))
    assert found.grade is not None
    return found


def read(more: str) -> tuple[Task | None, list[str]]:
    found, problems = read_task(SourceFile("task.toml", TASK_TEXT + more), SCENE)
    return found, [problem.rule.code for problem in problems]


TRICKS = [
    "PARAMETER SPEED.MAX = 400\n SPEED 400 ALWAYS",
    "PARAMETER VEL.LIN = 5000",
    "PARAMETER TACC = 0.01",
    "PARAMETER HAND.MAX = 200",
    "PARAMETER NEST.POS[1] = 10",
]


@pytest.mark.parametrize("trick", TRICKS)
def test_moving_a_limit_has_no_effect_but_on_the_mark(trick: str) -> None:
    honest = marked(SLOWLY)
    tried = marked(SLOWLY.replace("OPENI  ", f"{trick}\n        OPENI  ", 1))
    assert honest.grade is not None
    assert tried.grade is not None
    assert tried.grade.mark == Fraction(7)
    assert tried.grade.mark < honest.grade.mark
    assert tried.grade.limits == Fraction(3, 2)
    first = tried.grade.losses[0]
    assert (first.kind, first.check) == ("limit", "limits")
    assert first.span is not None
    assert first.span.text.strip().startswith("PARAMETER")
    assert tried.grade.obstacles[0] in first.sentence
    screen = first_screen(tried)
    assert "is not for programs of this task to set" in screen.cause
    assert tried.run is not None
    assert codes(tried.run).count("V438") == 1


def test_a_limit_moved_again_and_again_or_by_the_second_program_costs_once() -> None:
    beside = ".PROGRAM b\n PARAMETER SPEED.MAX = 300\n.END\n"
    second = SOLUTION.replace(".PROGRAM carry", f"{beside}.PROGRAM carry")
    found = marked(second.replace("OPENI  ", "PCEXECUTE b, 1\n OPENI  ", 1))
    assert found.grade is not None
    assert (found.grade.mark, found.grade.limits) == (7, Fraction(3, 2))
    often = SOLUTION.replace("APPRO start", "PARAMETER SPEED.MAX = 300\n APPRO start")
    again = marked(often)
    assert again.grade is not None
    assert (again.grade.mark, again.grade.limits) == (7, Fraction(3, 2))


def test_what_is_set_to_what_it_is_moves_nothing() -> None:
    found = marked(SOLUTION.replace("OPENI  ", "PARAMETER SPEED.MAX = 100\n OPENI  ", 1))
    assert found.grade is not None
    assert found.grade.mark == 10


def test_a_step_that_is_never_reached_moves_nothing() -> None:
    never = "IF FALSE THEN\n PARAMETER SPEED.MAX = 400\n END\n"
    text = SOLUTION.replace("OPENI  ", f"{never} OPENI  ", 1)
    found = marked(text)
    assert found.grade is not None
    assert found.grade.mark == 10


def test_the_task_says_what_may_be_set() -> None:
    more = 'parameters = ["SPEED.MAX", "hand.time"]\nswitches = ["CP"]\n'
    task, problems = read(f"\n[settings]\n{more}")
    assert problems == []
    assert task is not None
    assert "SPEED.MAX" not in task.locks.names
    assert {"VEL.LIN", "KERMIT.RETRY", "DRY.RUN", "POWER"} <= set(task.locks.names)
    assert "CP" not in task.locks.names
    usual, _ = read("")
    assert usual is not None
    assert usual.locks == USUAL_LOCKS
    assert set(USUAL_LOCKS.names) == set(INSTALLED) < set(PARAMETERS)


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ('[settings]\nparameters = ["HAND.TIMES"]\n', "V656"),
        ('[settings]\nswitches = ["PC"]\n', "V656"),
        ("[settings]\nspeeds = 1\n", "V602"),
        ("[settings]\nacceleration_percent = 0\n", "V605"),
    ],
)
def test_settings_that_are_none_are_refused_where_they_stand(more: str, code: str) -> None:
    task, problems = read(f"\n{more}")
    assert task is None
    assert problems == [code]


def test_a_switch_that_the_task_keeps_stays() -> None:
    task, _ = read("\n[settings]\nswitches = []\n")
    assert task is not None
    setting = replace(load_task(EXAMPLE), task=task)
    text = SOLUTION.replace("OPENI  ", "DISABLE CP\n OPENI  ", 1)
    found = assess(Request(ProgramFile(text.encode(), "a.v2"), setting))
    assert found.run is not None
    assert found.grade is not None
    assert found.grade.duration_s == marked(SOLUTION).grade.duration_s  # type: ignore[union-attr]
    assert found.grade.mark == 7


def test_more_than_full_acceleration_is_the_tasks_to_allow() -> None:
    program = ".PROGRAM main\n {}\n DRIVE 1, 60, 100\n BREAK\n.END\n"
    plain, tried, less = (
        marked(program.format(step), "vplus") for step in ("", "ACCEL 500, 500", "ACCEL 50, 50")
    )
    assert plain.run is not None
    assert tried.run is not None
    assert less.run is not None
    assert tried.run.ended_s == plain.run.ended_s
    assert (codes(tried.run), codes(less.run)) == (["V438"], [])
    assert tried.judgement is not None
    assert [v.answer for v in tried.judgement.verdicts if v.check == "limits"] == [Answer.VIOLATED]
    task, _ = read("\n[settings]\nacceleration_percent = 500\n")
    setting = replace(load_task(EXAMPLE), task=task)
    text = program.format("ACCEL 500, 500").encode()
    allowed = assess(Request(ProgramFile(text, "a.v2"), setting, Reading("vplus")))
    assert allowed.run is not None
    assert codes(allowed.run) == []
    assert allowed.run.ended_s is not None
    assert plain.run.ended_s is not None
    assert allowed.run.ended_s < plain.run.ended_s


LINE = (
    ".PROGRAM main\nDRIVE 2, 45, 100\nDRIVE 3, 30, 100\nDRIVE 5, 6, 100\nHERE p\n"
    "SPEED {} MMPS\nMOVES SHIFT(p BY 0,-400,0)\n.END\n"
)


def graded(run: Run, task: Task) -> Grade:
    return grade(task, run, judge(SCENE, run, task))


def test_goals_are_not_judged_before_a_run_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    """However much motions gain that are too fast for a joint."""
    task, _ = read("")
    assert task is not None
    run = execute(compiled(LINE.format(100)), SCENE)

    def gaining(_run: Run) -> tuple[tuple[float, float], ...]:
        return ((0.1, 500.0),)

    monkeypatch.setattr("vrts.check.goals.reached.overruns", gaining)
    assert judged_at(run, task) == run.started_s


def test_a_joint_that_is_too_fast_is_a_fault_and_gains_no_time() -> None:
    task, _ = read("")
    assert task is not None
    run = execute(compiled(LINE.format(500)), SCENE)
    slow = execute(compiled(LINE.format(100)), SCENE)
    assert overruns(slow) == ()
    ((end_s, gained),) = overruns(run)
    assert gained > 0.0
    assert run.ended_s is not None
    assert run.started_s < end_s <= run.ended_s
    took = duration(run)
    assert took is not None
    assert float(took) == pytest.approx(run.ended_s - run.started_s + gained, abs=1e-3)
    there = judge(SCENE, run, task, collisions=False).verdicts
    assert [v.answer for v in there if v.check == "limits"] == [Answer.VIOLATED]
    late = replace(task, t_par=1.0, t_max=run.ended_s - run.started_s + gained / 2)
    assert judged_at(run, late) < run.ended_s  # as if it had taken longer
    path = replace(task, goals=(), t_par=20.0, t_max=40.0)
    assert graded(slow, path).mark == 10
    broken = graded(run, path)
    assert broken.mark == 7
    assert broken.losses[0].kind == "limit"
    assert "exceeds its speed limit" in broken.losses[0].sentence


def test_files_of_runs_keep_what_was_locked(tmp_path: Path) -> None:
    text = SOLUTION.replace("OPENI  ", "PARAMETER SPEED.MAX = 400\n OPENI  ", 1)
    found = simulate(Request(ProgramFile(text.encode(), "a.v2"), load_task(EXAMPLE)))
    loaded = load_run(saved_bytes(found), "a.vrun", tmp_path)
    assert loaded.run is not None
    assert loaded.run.scenario.locks == USUAL_LOCKS
    assert codes(loaded.run) == ["V438"]
    assert check_again(loaded) is None
    free = replace(load_task(EXAMPLE), task=None)
    plain = simulate(Request(ProgramFile(b".PROGRAM a\nREADY\n.END\n", "a.v2"), free))
    assert load_run(saved_bytes(plain), "a.vrun", tmp_path).run is not None


def test_without_a_task_every_parameter_may_be_set() -> None:
    run = ran(".PROGRAM a\nPARAMETER SPEED.MAX = 400\nTYPE /F6.1, PARAMETER(SPEED.MAX)\n.END\n")
    assert "400.0" in run.output
    assert codes(run) == []
