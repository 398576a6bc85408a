"""Laws of the search: what merging, order and chance may not change."""

from dataclasses import replace
from heapq import heappush
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
from vrts.prove.explore.frontier import Frontier, Future
from vrts.prove.explore.search import Search
from vrts.prove.proof import Wrong
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario, Scene

FEW = 1_000  # states
MOST = 20_000  # of programs that are made to be looked at
SCENARIOS = 8  # of each of these; tests/bench tries many more
ALONE = robot_alone()
USUAL, MANY = range(12), [pytest.param(k, marks=pytest.mark.thorough) for k in range(12, 80)]
LATER = MANY[18:]  # of what is drawn, for what looks at it in several orders
DEAR = (3, 16)  # of the programs that are drawn, those whose search takes seconds
DRAWN = [pytest.param(k, marks=pytest.mark.thorough) if k in DEAR else k for k in USUAL]


class Shuffled(Frontier):
    """Futures that wait to be looked at, in an order that is drawn."""

    def __init__(self, seed: int) -> None:
        """Hold nothing."""
        super().__init__()
        self._draw = Random(seed)

    def push(self, future: Future) -> None:
        """Let a future wait."""
        self._pushed += 1
        heappush(self._heap, ((self._draw.randrange(1_000), 0, 0), self._pushed, future))

    def is_earlier(self, future: Future) -> bool:
        """Return now and then that another future has its turn."""
        return bool(self._heap) and self._draw.random() < 0.2


def searched(
    module: Module,
    scene: Scene,
    environment: Environment,
    states: int,
    *,
    merging: bool = True,
    collisions: bool = False,
    order: Frontier | None = None,
) -> Search:
    """Return what is found of all futures of a program, in the usual or another order."""
    search = Search(module, scene, environment, collisions=collisions, merging=merging)
    if order is not None:
        search.frontier = order
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


@pytest.mark.parametrize("number", [*DRAWN, *MANY])
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


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_merging_changes_no_answer(number: int) -> None:
    module = compiled(looking(number))
    apart = searched(module, ALONE, Environment(), MOST // 10, merging=False)
    if apart.is_over:
        compare(apart, searched(module, ALONE, Environment(), MOST))


def in_any_order(
    module: Module, scene: Scene, environment: Environment, seed: int, states: int
) -> None:
    """Look at the futures of a program in three orders, and compare what is found."""
    usual = searched(module, scene, environment, states, collisions=True)
    if not usual.is_over:
        return
    spread = Frontier()
    spread.spread()
    for order in (Shuffled(seed), spread):
        other = searched(module, scene, environment, 2 * states, collisions=True, order=order)
        assert other.is_over
        assert {one.why for one in other.suspects.in_order()} == {
            one.why for one in usual.suspects.in_order()
        }
        assert set(other.endings) == set(usual.endings)
        assert other.executed.numbers == usual.executed.numbers


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_the_order_changes_no_answer(number: int) -> None:
    in_any_order(compiled(looking(number)), ALONE, Environment(), number, MOST)


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*DRAWN[:10], *LATER])
@deep_stack()
def test_the_order_changes_no_answer_of_drawn_programs(number: int) -> None:
    given = drawn(number)
    module, scene = compiled(given.text, given.dialect), setting(given.scene).scene
    scenario, _ = outside(given.scenario)
    scenario = replace(scenario, inputs=(), answers=(), faults=())
    environment = Environment(scenario=scenario, answers=Answers(("1", "2")))
    in_any_order(module, scene, environment, number, FEW)


def stays(search: Search, told: Told) -> list[Machine]:
    """Return the states that a scenario shows; each has to be among those of a search."""
    shown: list[Machine] = []
    ticks: set[int] = set()  # in which something was asked

    def asked(machine: Machine, question: Question) -> None:
        assert search.knows(machine, Memory(), question)
        shown.append(machine)
        ticks.add(machine.last_tick)

    for machine in told.ticks(asked):
        if machine.robot.running and machine.last_tick not in ticks:
            assert search.knows(machine, Memory())
        shown.append(machine)
    return shown


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*DRAWN, *MANY])
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
    turns = sorted(draw.uniform(0.0, 6.0) for _ in range(draw.choice((0, 0, 1, 5))))
    return Scenario(inputs=tuple(sorted(inputs)), process_first=tuple(turns))


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_what_a_scenario_shows_is_among_the_futures(number: int) -> None:
    among_the_futures(number, SCENARIOS)


@pytest.mark.thorough
@deep_stack()
def test_a_corner_that_only_rounding_tells_from_another_is_among_the_futures() -> None:
    among_the_futures(9, 14)  # a coefficient lies on a border between rounded numbers


def among_the_futures(number: int, scenarios: int) -> None:
    """Look whether what so many scenarios of a program show is among its futures."""
    module = compiled(looking(number))
    search = searched(module, ALONE, Environment(), MOST)
    assert search.is_over
    for seed in range(scenarios):
        scenario = chance(Random(f"{number}.{seed}"))
        shown = stays(search, Told(module, ALONE, scenario, frozenset(INPUTS)))
        if shown[-1].robot.ending is Ending.ERROR:
            assert causes(search)
