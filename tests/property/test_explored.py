"""Laws of the search: what merging, order and chance may not change."""

from dataclasses import replace
from random import Random

import pytest

from tests.property.test_futures import Told, outside
from tests.support_programs import compiled
from tests.whole_programs.drawing import drawn
from tests.whole_programs.outside import INPUTS, looking
from tests.whole_programs.settings import setting
from vrts.base.stack import deep_stack
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import Ending
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.module import Module
from vrts.prove.asking import Asking
from vrts.prove.certify.memory import Memory
from vrts.prove.environment.environment import Answers, Environment
from vrts.prove.explore.search import Search
from vrts.prove.proof import Wrong
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario, Scene

FEW = 1_000  # states
MOST = 20_000  # of programs that are made to be looked at
SCENARIOS = 8  # of each of these
ALONE = robot_alone()
USUAL, MANY = range(30), [pytest.param(k, marks=pytest.mark.thorough) for k in range(30, 330)]


def searched(
    module: Module, scene: Scene, environment: Environment, states: int, *, merging: bool = True
) -> Search:
    """Return what is found of all futures of a program."""
    search = Search(module, scene, environment, collisions=False, merging=merging)
    search.begin(module.main or "")
    search.go_on(Asking(states=states))
    return search


def causes(search: Search) -> set[object]:
    """Return what goes wrong, apart from how it came to it and from what never ends."""
    found = search.suspects.in_order()
    return {one.why for one in found if one.wrong not in (Wrong.ENDLESS, Wrong.DEADLOCK)}


def compare(apart: Search, merged: Search) -> None:
    assert merged.is_over
    assert merged.counts.states <= apart.counts.states
    assert causes(merged) == causes(apart)
    assert set(merged.endings) == set(apart.endings)
    assert merged.executed.numbers == apart.executed.numbers


@pytest.mark.parametrize("number", [*USUAL, *MANY[:60]])
@deep_stack()
def test_merging_changes_no_answer_of_drawn_programs(number: int) -> None:
    given = drawn(number)
    module, scene = compiled(given.text, given.dialect), setting(given.scene).scene
    scenario, _ = outside(given.scenario)
    scenario = replace(scenario, inputs=(), answers=(), faults=())
    speeds = (scenario.monitor_speed,)
    environment = Environment(scenario=scenario, answers=Answers(("1", "2")), speeds=speeds)
    apart = searched(module, scene, environment, FEW, merging=False)
    if apart.is_over:
        compare(apart, searched(module, scene, environment, FEW))


@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_merging_changes_no_answer(number: int) -> None:
    module = compiled(looking(number))
    apart = searched(module, ALONE, Environment(), MOST // 10, merging=False)
    if apart.is_over:
        compare(apart, searched(module, ALONE, Environment(), MOST))


def stays(search: Search, told: Told) -> list[Machine]:
    """Return the states that a scenario shows; each has to be among those of a search."""
    shown: list[Machine] = []

    def asked(machine: Machine, question: Question) -> None:
        assert search.knows(machine, Memory(), question)
        shown.append(machine)

    for machine in told.ticks(asked):
        before = len(shown)
        if machine.robot.running and not shown[before:]:
            looked = machine.system.signals.on.looked  # type: ignore[attr-defined]
            assert looked or search.knows(machine, Memory())
        shown.append(machine)
    return shown


@pytest.mark.parametrize("number", [*USUAL, *MANY[:60]])
@deep_stack()
def test_what_a_scenario_shows_of_drawn_programs_is_among_the_futures(number: int) -> None:
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
    if not search.is_over or Question(Kind.RANDOM) in search.asked or Kind.ANSWER in asks(search):
        return  # it has too many futures, or draws other numbers
    shown = stays(search, Told(module, scene, scenario, free))
    if shown[-1].robot.ending is Ending.ERROR:
        assert causes(search)


def asks(search: Search) -> set[Kind]:
    return {question.kind for question in search.asked}


def chance(draw: Random) -> Scenario:
    """Return a scenario with inputs that change by chance."""
    inputs: list[tuple[float, int, bool]] = []
    for number in INPUTS:
        time_s, on = draw.choice((0.0, draw.uniform(0.0, 4.0))), draw.random() < 0.7
        for _ in range(draw.choice((1, 1, 2, 5))):
            inputs.append((time_s, number, on))
            on = not on
            time_s += draw.choice((0.03, 0.3, 3.0)) * draw.random() + 0.028
    return Scenario(inputs=tuple(sorted(inputs)))


@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_what_a_scenario_shows_is_among_the_futures(number: int) -> None:
    module = compiled(looking(number))
    search = searched(module, ALONE, Environment(), MOST)
    assert search.is_over
    for seed in range(SCENARIOS):
        scenario = chance(Random(f"{number}.{seed}"))
        shown = stays(search, Told(module, ALONE, scenario, frozenset(INPUTS)))
        if shown[-1].robot.ending is Ending.ERROR:
            assert causes(search)
