"""What a task asks for is judged where futures end."""

from functools import cache

from tests.places import ROOT
from tests.unit.prove.explore.proofs import only
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import compile_bytes
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.prove.environment.environment import Afterwards, Environment
from vrts.prove.proof import Proof, What, Wrong
from vrts.prove.prove import prove

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SECOND = "        CALL carry(can2_grip, base1_put)\n"


@cache
def setting() -> Setting:
    return load_task(EXAMPLE)


def module_of(second: str) -> Module:
    """Return the example's program with something else where it carries the second can."""
    text = (EXAMPLE / "solution.v2").read_text()
    compilation = compile_bytes(text.replace(SECOND, second).encode(), "a.v2").compilation
    assert compilation is not None
    assert compilation.module is not None
    return compilation.module


def proven(second: str, environment: Environment | None = None) -> Proof:
    chosen = environment or Environment()
    task = setting().task
    return prove(module_of(second), setting().scene, chosen, entry="main", task=task)


def test_goals_that_are_reached_in_every_future_hold() -> None:
    assert proven("        WAIT SIG(1001)\n" + SECOND).answer is Answer.HOLDS


def test_a_goal_that_an_input_lets_be_missed_is_found() -> None:
    second = "        IF SIG(-1001) THEN\n" + SECOND + "        END\n"
    found = only(proven(second))
    assert (found.wrong, found.headline[:11]) == (Wrong.GOAL, "target can2")
    assert [one.what for one in found.decisions] == [What.INPUT]
    run = execute(module_of(second), setting().scene, found.scenario)
    assert run.at(run.horizon_s).poses["can2"] == setting().scene.body("can2").X_WO


def test_a_program_that_is_stopped_or_finds_no_part_is_asked_for_no_goal() -> None:
    environment = Environment(misses=True)
    assert proven(SECOND, environment).answer is Answer.HOLDS
    nothing = Environment(stops=frozenset({Afterwards.NOTHING}))
    assert proven("", nothing).answer is Answer.VIOLATED, "it is missed without a stop"
    assert proven(SECOND, nothing).answer is Answer.HOLDS
