"""Laws of the search: what merging, order and chance may not change."""

from dataclasses import replace

import pytest

from tests.property.test_futures import Told, outside
from tests.support_programs import compiled
from tests.whole_programs.drawing import drawn
from tests.whole_programs.settings import setting
from vrts.base.stack import deep_stack
from vrts.engine.memory.records import Ending
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.module import Module
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Answers, Environment
from vrts.prove.explore.contacts import Nobody
from vrts.prove.explore.outside import Free
from vrts.prove.explore.search import Search
from vrts.scene.model import Scene

FEW = 1_000  # states
USUAL, MANY = range(30), [pytest.param(k, marks=pytest.mark.thorough) for k in range(30, 120)]


def searched(
    module: Module, scene: Scene, environment: Environment, states: int, *, merging: bool = True
) -> Search:
    """Return what is found of all futures of a program."""
    search = Search(module, scene, environment, Free(), Nobody(), merging=merging)
    search.run(module.main or "", None, Asking(states=states))
    return search


def causes(search: Search) -> set[object]:
    """Return what goes wrong, apart from how it came to it."""
    return {suspect.why for suspect in search.suspects.in_order()}


@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_merging_changes_no_answer(number: int) -> None:
    given = drawn(number)
    module, scene = compiled(given.text, given.dialect), setting(given.scene).scene
    scenario, _ = outside(given.scenario)
    scenario = replace(scenario, inputs=(), answers=(), faults=())
    speeds = (scenario.monitor_speed,)
    environment = Environment(scenario=scenario, answers=Answers(("1", "2")), speeds=speeds)
    apart = searched(module, scene, environment, FEW, merging=False)
    if not apart.is_over:
        return  # it has too many futures to look at each
    merged = searched(module, scene, environment, FEW)
    assert merged.is_over
    assert merged.counts.states <= apart.counts.states
    assert causes(merged) == causes(apart)
    assert set(merged.endings) == set(apart.endings)
    assert merged.executed.numbers == apart.executed.numbers


@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_what_a_scenario_shows_is_among_the_futures(number: int) -> None:
    given = drawn(number)
    module, scene = compiled(given.text, given.dialect), setting(given.scene).scene
    scenario, free = outside(given.scenario)
    answers = tuple(dict.fromkeys(scenario.answers))
    quiet = replace(scenario, inputs=tuple(i for i in scenario.inputs if i[1] not in free))
    environment = Environment(
        scenario=replace(quiet, answers=()),
        answers=Answers(answers) if answers else None,
        speeds=(scenario.monitor_speed,),
    )
    search = searched(module, scene, environment, FEW)
    if not search.is_over or Question(Kind.RANDOM) in search.asked:
        return  # it has too many futures, or draws other numbers
    told = Told(module, scene, scenario, free)
    last = told.machine
    for machine in told.ticks():
        last = machine
        if machine.robot.running:
            assert search.knows(machine, None), (number, machine.now)
    if last.robot.ending is Ending.ERROR:
        assert causes(search)
