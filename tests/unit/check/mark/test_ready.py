"""What speaks against the real robot: an entry, a program that shows it, and one that does not."""

from dataclasses import replace

import pytest

from tests.support_programs import ROOT, cans
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.judgement import Judgement
from vrts.check.mark.mark import grade
from vrts.check.mark.ready import SAID, Kind, Obstacle, obstacles, of_task
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import Compilation, compile_source

SCENE = cans()
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
TASK = (EXAMPLE / "task.toml").read_text("utf-8")
SOLUTION = (EXAMPLE / "solution.v2").read_text("utf-8")
SAFE = ".LOCATIONS\nsafe 900 30 100 90 90 0\n.END\n"


def task(more: str = "") -> Task:
    found, problems = read_task(SourceFile("task.toml", TASK + more), SCENE)
    assert found is not None, problems
    return found


def ran(text: str) -> tuple[Compilation, Run]:
    compilation = compile_source(SourceFile("x.v2", text))
    assert compilation.module is not None
    return compilation, execute(compilation.module, SCENE)


def against(text: str, wanted: Task | None = None, *, collisions: bool = True) -> list[Obstacle]:
    """Return what speaks against a program."""
    compilation, run = ran(text)
    judgement = judge(SCENE, run, wanted, collisions=collisions)
    asked = None if wanted is None else of_task(wanted, run)
    found = obstacles(run, judgement, asked, compilation.diagnostics)
    if wanted is not None:
        marked = grade(wanted, run, judgement, compilation.diagnostics)
        assert [o.sentence for o in found] == list(marked.obstacles), "the mark goes by the same"
        assert marked.ready is not bool(found)
    return list(found)


def main(*steps: str) -> str:
    body = "".join(f"        {step}\n" for step in steps)
    return f".PROGRAM main()\n{body}.END\n{SAFE}"


def solved(old: str, new: str) -> str:
    assert SOLUTION.count(old) == 1
    return SOLUTION.replace(old, new)


VIA = """
[[via]]
name = "up there"
at_mm = [0, 0, 3000]
radius_mm = 10
"""
ZONE = """
[[zone]]
name = "everywhere"
keeps_out = "robot"
from_mm = [-3000, -3000, -3000]
to_mm = [3000, 3000, 3000]
"""
SINGULAR = (
    *("DRIVE 2, 45, 100", "DRIVE 3, 30, 100", "DRIVE 5, 6, 100", "HERE p"),
    *("SPEED 500 MMPS", "MOVES SHIFT(p BY 0,-400,0)"),
)
SHOWN = {
    Kind.LIMIT: (main(*SINGULAR), ""),
    Kind.CONTACT: (main("MOVE safe", "MOVES SHIFT(safe BY 0, 0, -480)"), ""),
    Kind.DROP: (solved("        MOVES goal\n", ""), ""),
    Kind.STOPPED: (main("MOVE nowhere"), ""),
    Kind.GRIP: (main("OPENI", "MOVE safe", "CLOSEI", "READY"), ""),
    Kind.TOPPLED: (solved("1100.00   230.00", "1170.00   230.00"), ""),
    Kind.DEMAND: (SOLUTION, ZONE),
    Kind.GOAL: (solved("        CALL carry(can2_grip, base1_put)\n", ""), " "),
    Kind.VIA: (SOLUTION, VIA),
    Kind.LOST_STEP: (main("MOVE safe ; MOVES safe", "READY"), ""),
    Kind.UNKNOWN_PLACE: (main("IF SIG(1001) THEN", "MOVE there", "END", "READY"), ""),
}


@pytest.mark.thorough
@pytest.mark.parametrize("kind", SHOWN, ids=lambda kind: kind.name)
def test_each_entry_is_shown_by_a_program(kind: Kind) -> None:
    text, more = SHOWN[kind]
    found = against(text, task(more) if more else None)
    assert kind in {one.kind for one in found}
    assert all(one.sentence for one in found)


def test_nothing_speaks_against_the_reference_solution() -> None:
    assert against(SOLUTION, task()) == []
    assert against(SOLUTION) == []


def judged() -> tuple[Run, Judgement]:
    _, run = ran(SOLUTION)
    return run, judge(SCENE, run, None)


def kinds(run: Run, judgement: Judgement) -> list[Kind]:
    return [one.kind for one in obstacles(run, judgement)]


def test_what_a_check_cannot_tell_is_an_entry() -> None:
    run, judgement = judged()
    first, *others = judgement.verdicts
    open_one = replace(first, answer=Answer.UNDETERMINED)
    assert kinds(run, replace(judgement, verdicts=(open_one, *others))) == [Kind.DOUBT]


def test_engines_that_disagree_are_an_entry() -> None:
    run, judgement = judged()
    assert judgement.collisions is not None
    disputed = replace(judgement.collisions, disagreements=("can1 and base1",))
    assert kinds(run, replace(judgement, collisions=disputed)) == [Kind.ENGINES]


def test_collisions_that_nobody_looked_for_are_an_entry() -> None:
    assert [one.kind for one in against(SOLUTION, collisions=False)] == [Kind.UNCHECKED]


def test_every_entry_has_a_test() -> None:
    assert set(Kind) == {*SHOWN, Kind.DOUBT, Kind.ENGINES, Kind.UNCHECKED}
    assert set(SAID.values()) <= set(SHOWN)


def test_a_hand_that_is_closed_before_anything_moves_is_none() -> None:
    assert against(main("CLOSEI", "MOVE safe", "READY")) == []
    assert [o.kind for o in against(main("MOVE safe", "CLOSEI"))] == [Kind.GRIP]
