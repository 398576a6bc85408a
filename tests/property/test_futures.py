"""Futures of programs drawn by chance: told what a scenario says, they do what the engine does."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from random import Random

import pytest

from tests.support_programs import compiled
from tests.whole_programs.drawing import Drawn, drawn
from tests.whole_programs.settings import setting
from vrts.base.stack import deep_stack
from vrts.engine.controller import execute
from vrts.engine.futures.future import begin, command, decide, tick
from vrts.engine.futures.keys import Keys
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.state import state
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.prove.explore.sharing import may_differ
from vrts.scene.model import FaultKind, Scenario, Scene

INPUTS = frozenset({1001, 1002, 1003})
LONGEST_S, MOST = 60.0, 3000  # simulated time, and statements, of a future
FUTURES, TICKS = 3, 300  # that are looked at of a program
MEETINGS, AFTER = 30, 40  # of futures at different times, and ticks for which they go on
ANSWERS = ("1", "2.5", "bad", "")
USUAL, MANY = range(40), [pytest.param(k, marks=pytest.mark.thorough) for k in range(40, 80)]


def outside(scenario: Scenario) -> tuple[Scenario, frozenset[int]]:
    """Return a scenario in which no input is stuck, and inputs that nobody but it sets."""
    faults = tuple(f for f in scenario.faults if f.kind is not FaultKind.INPUT_STUCK)
    kept = replace(scenario, faults=faults)
    return kept, INPUTS - {sensor.signal for sensor in scenario.sensors}


def is_on(scenario: Scenario, number: int, now: float) -> bool:
    """Return whether a scenario has an input on at a time."""
    states = [on for time_s, n, on in scenario.inputs if n == number and time_s <= now]
    return bool(states) and states[-1]


def _quiet(machine: Machine, question: Question) -> None:
    """Hear nothing."""


class Told:
    """A future that is told what a scenario says."""

    def __init__(self, module: Module, scene: Scene, scenario: Scenario, free: frozenset[int]):
        left = tuple(entry for entry in scenario.inputs if entry[1] not in free)
        mine = replace(scenario, inputs=left, answers=(), process_first=())
        self.scenario = scenario
        self.answers = list(scenario.answers)
        turns = may_differ(module, module.main or "")
        self.machine = begin(module, scene, mine, free, answers=True, turns=turns)
        command(self.machine, Execute(module.main or ""))
        self.open = False  # it asks what the scenario does not tell

    def ticks(self, asked: Callable[[Machine, Question], None] = _quiet) -> Iterator[Machine]:
        """Go on tick by tick, as far as it is known what to say; `asked` hears every question."""
        while self.machine.now < LONGEST_S and self.machine.finished < MOST:
            while (question := tick(self.machine)) is not None:
                asked(self.machine, question)
                if question.kind is Kind.ANSWER and not self.answers:
                    self.open = True
                    return
                decide(self.machine, question, self._said(question))
            yield self.machine
            if self.machine.robot.ending is not Ending.RUNNING:
                return

    def _said(self, question: Question) -> bool | str:
        if question.kind is Kind.ANSWER:
            return self.answers.pop(0)
        if question.kind is Kind.TURN:
            now, tick_s = self.machine.now + INSTANT, self.machine.tick
            return any(now - tick_s < time_s <= now for time_s in self.scenario.process_first)
        return is_on(self.scenario, question.number, self.machine.now)


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_a_future_that_is_told_a_scenario_does_what_the_engine_does(number: int) -> None:
    given: Drawn = drawn(number)
    module = compiled(given.text, given.dialect)
    scene = setting(given.scene).scene
    scenario, free = outside(given.scenario)
    draw = Random(number)
    turns = sorted(draw.uniform(0.0, 6.0) for _ in range(draw.choice((0, 1, 10, 100))))
    scenario = replace(scenario, process_first=tuple(turns))
    run = execute(module, scene, scenario)
    told = Told(module, scene, scenario, free)
    keys, last = Keys(module), told.machine
    for machine in told.ticks():
        assert keys.of(machine) == keys.of(machine.copy())
        last = machine
    known = run.machine
    if last.robot.running and not told.open:
        assert run.ending is Ending.LIMIT or run.statements >= last.finished
        return
    if told.open:  # a scenario without an answer lets it wait, and others stop it
        assert run.machine.system.answers_read == len(scenario.answers)
        return
    if run.ending is Ending.LIMIT:  # what never ends is judged by whoever goes through futures
        assert last.robot.ending in (Ending.RUNNING, Ending.LIMIT)
        return
    assert last.robot.ending is run.ending
    assert last.ended_s == known.ended_s
    assert last.finished == known.finished
    assert last.system.terminal.characters == known.system.terminal.characters
    assert last.system.random_state == known.system.random_state
    assert frozenset(last.system.signals.on) - free == frozenset(known.system.signals.on) - free
    ended_s = known.ended_s or 0.0
    planner = known.system.planner
    assert last.system.planner.configuration_at(ended_s) == planner.configuration_at(ended_s)
    assert state(last, ended_s).values == state(known, ended_s).values


def answered(machine: Machine, draw: Random) -> list[object]:
    """Let a future go on for a tick, told what is drawn; return what it asked on the way."""
    asked: list[object] = []
    while (question := tick(machine)) is not None:
        asked.append(question)
        if question.kind is Kind.ANSWER:
            decide(machine, question, draw.choice(ANSWERS))
        elif question.kind is Kind.RANDOM:
            decide(machine, question, draw.choice((0.0, 0.5)))
        else:
            decide(machine, question, draw.random() < 0.4)
    return asked


@pytest.mark.parametrize("number", [*USUAL[::2], *MANY[:20]])
@deep_stack()
def test_futures_with_the_same_key_go_on_alike(number: int) -> None:
    given: Drawn = drawn(number)
    module = compiled(given.text, given.dialect)
    scene = setting(given.scene).scene
    scenario, free = outside(given.scenario)
    scenario = replace(scenario, inputs=(), answers=(), faults=())
    keys = Keys(module)
    known: dict[object, Machine] = {}
    met: list[tuple[Machine, Machine]] = []
    for seed in range(FUTURES):
        draw = Random(f"{number}.{seed}")
        machine = begin(module, scene, scenario, free, answers=True, random=True)
        command(machine, Execute(module.main or ""))
        for _ in range(TICKS):
            answered(machine, draw)
            if not machine.robot.running or machine.finished > MOST:
                break
            other = known.setdefault(keys.of(machine), machine.copy())
            if other.last_tick != machine.last_tick and len(met) < MEETINGS:
                met.append((machine.copy(), other.copy()))
    for k, (one, other) in enumerate(met):
        draws = Random(k), Random(k)
        for _ in range(AFTER):
            assert answered(one, draws[0]) == answered(other, draws[1])
            assert one.robot.ending is other.robot.ending
            if not one.robot.running:
                break
            assert keys.of(one) == keys.of(other)
