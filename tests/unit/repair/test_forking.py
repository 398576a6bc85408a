"""A candidate that goes on from the run of the program that it changes comes to the same end."""

from fractions import Fraction

import pytest

from tests.golden.examples import EXAMPLES
from vrts.base.remembered import Memory
from vrts.check.task.task import Task
from vrts.lang.compiler import STRICT
from vrts.pipeline.setting import scenario_of
from vrts.pipeline.settings import load_task
from vrts.repair.trying.trial import Place, Stage, Tried, compiled, shared, tried
from vrts.why.slicing.executed import Steps

EXAMPLE = EXAMPLES[1]
RIGHT = (EXAMPLE / "solution.v2").read_text()
SETTING = load_task(EXAMPLE / "task.toml")
assert isinstance(SETTING.task, Task)
PLACE = Place(SETTING.scene, SETTING.task, scenario_of(SETTING), STRICT, "program.v2")
CHANGES = {  # what is changed, and whether anything was executed before it
    "a number of the last step but one": ("DEPARTS 150", "DEPARTS 100", True),
    "a step more": ("        MOVES put\n", "        BREAK\n        MOVES put\n", True),
    "a row that is read late": ("0.00   140.00", "5.00   140.00", False),
    "the first step": ("put = stand_mid:rim", "put = rim:stand_mid", False),
    "another name at the end": (
        "        MOVE safe\n        TYPE",
        "        MOVE put\n        TYPE",
        True,
    ),
}


def told(found: Tried) -> tuple[Stage, float, Fraction | None, object]:
    assert found.run is not None
    ways = [segment.coefficients for segment in found.run.timeline.segments]
    return found.stage, found.come, found.mark, (ways, len(found.run.events))


def test_it_goes_on_before_the_step_that_differs() -> None:
    before, after, _ = next(iter(CHANGES.values()))
    known = shared(PLACE, RIGHT, Memory())
    found = compiled(PLACE, RIGHT.replace(before, after, 1))
    assert known is not None
    assert found is not None
    begins = known.before(found[0])
    assert begins is not None
    executed = {step.line for step in Steps(begins).of_robot}
    changed = 1 + RIGHT[: RIGHT.index(before)].count("\n")
    assert executed
    assert max(executed) < changed


@pytest.mark.parametrize(
    "name",
    [next(iter(CHANGES)), *(pytest.param(n, marks=pytest.mark.thorough) for n in [*CHANGES][1:])],
)
def test_it_is_the_run_that_it_would_be_from_its_beginning(name: str) -> None:
    before, after, late = CHANGES[name]
    text = RIGHT.replace(before, after, 1)
    assert text != RIGHT
    memory = Memory()
    known = shared(PLACE, RIGHT, memory)
    assert known is not None
    found = compiled(PLACE, text)
    assert found is not None
    assert (known.before(found[0]) is not None) == late
    assert told(tried(PLACE, text, memory, base=known)) == told(tried(PLACE, text, memory))
