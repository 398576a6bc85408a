"""A law of the search: all that chance may bring about from outside is among what it looked at.

Stops and what follows them, answers, random numbers, missed grips, analog inputs, turns, speeds.
What chance brought about is executed again as a scenario, which has to end in the same way.
"""

from random import Random

import pytest

from tests.property.test_explored import searched
from tests.support_programs import cans, compiled
from tests.whole_programs.outside import asking
from vrts.base.stack import deep_stack
from vrts.engine.controller import execute
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import Ending
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.commands import Execute
from vrts.ir.ranges import ANALOG_INPUTS, INPUTS
from vrts.prove.certify.memory import Memory
from vrts.prove.environment.environment import Afterwards, Again, Answers, Environment
from vrts.prove.explore.frontier import Future
from vrts.prove.explore.outside import Way
from vrts.prove.explore.search import Search
from vrts.prove.explore.sharing import may_differ
from vrts.prove.proof import Decided, What
from vrts.prove.telling.scenarios import scenario_of
from vrts.scene.model import Parts, Scenario, Scene

MOST = 12_000  # states
WALKS, TICKS = 8, 4_000
SCENE = cans()
USUAL = (0, 1)
ROUNDED = (29, 77)  # rounding left a joint a highest power, or did not
LARGE = (2, 5, 8, 39, 41)  # more futures than are looked at, or nearly
NUMBERS = [k for k in range(45) if k not in (*USUAL, *ROUNDED, *LARGE)]
MANY = [pytest.param(k, marks=pytest.mark.thorough) for k in (*ROUNDED, *NUMBERS)]
FREE = frozenset((*INPUTS, *(-channel for channel in ANALOG_INPUTS)))


def environment(number: int) -> Environment:
    """Return what may come from outside into the program of a number."""
    draw = Random(f"environment {number}")
    stops = draw.random() < 0.6
    return Environment(
        answers=Answers(("0", "2", "3")),
        random=(0.1, 0.9),
        speeds=draw.choice(((100.0,), (100.0, 37.0))),
        stops=frozenset(Afterwards) if stops else frozenset(),
        misses=draw.random() < 0.6,
        again=Again(draw.choice((0, 0, 1)), draw.choice(tuple(Parts))),
    )


class Walk:
    """A future of which chance decides everything, and which no search leads."""

    def __init__(self, search: Search, scene: Scene, draw: Random) -> None:
        """Begin at one of the speeds."""
        outside = search.environment
        self.search, self.draw = search, draw
        self.story: list[Decided] = []
        speed = draw.choice(outside.speeds)
        if len(outside.speeds) > 1:
            self.story.append(Decided(0.0, What.SPEED, 0, speed, None))
        turns = may_differ(search.module, "main")
        self.machine = begin(
            search.module,
            scene,
            Scenario(monitor_speed=speed),
            FREE,
            answers=True,
            random=True,
            grips=outside.misses,
            turns=turns,
        )
        command(self.machine, Execute("main"))
        states = search.outside.behaviours.begin()
        self.future = Future(0, self.machine, None, 0, {}, states, None, Memory())
        self.stop_s = draw.choice((0.0, draw.uniform(0.0, 2.0), draw.uniform(0.0, 9.0)))
        self.stays = draw.choice((0.6, 0.97))  # how often an input is as it was

    def is_known(self, question: Question | None = None) -> bool:
        """Return whether the search has looked at the state that it is in."""
        stopped, again = self.future.stopped, self.future.again
        return self.search.knows(self.machine, Memory(), question, stopped=stopped, again=again)

    def go(self) -> bool:
        """Go on to its end; return whether it came there."""
        machine, operator = self.machine, self.search.operator
        for _ in range(TICKS):
            asked = False
            while (question := tick(machine)) is not None:
                asked = True
                assert self.is_known(question)
                self._decide(question)
            happened(machine)
            following = operator.next_stop(self.future)
            if following is not None:
                machine.next_tick = min(machine.next_tick, following)
            if not machine.robot.running:
                if not self._afterwards():
                    return True
            elif not asked:
                assert self.is_known()
            self._stop()
        return False

    def _decide(self, question: Question) -> None:
        ways = self.search.outside.ways(self.future, question)
        way: Way = self.draw.choice(ways)
        if question.kind in (Kind.INPUT, Kind.ANALOG) and self.draw.random() < self.stays:
            way = ways[0]
        decide(self.machine, question, way.value)
        if way.decided is None:
            return
        self.story.append(way.decided)
        sign = {Kind.INPUT: 1, Kind.ANALOG: -1}.get(question.kind)
        if sign is not None:
            assert isinstance(way.value, float | bool)
            known = {**self.future.inputs, sign * question.number: way.value}
            self.future.inputs = known

    def _stop(self) -> None:
        if self.machine.now < self.stop_s:
            return
        deed = self.search.operator.stops(self.future)
        if deed is not None:
            self.machine.issue(deed.commands)
            self.story.append(deed.decided)
            self.future.stopped = True

    def _afterwards(self) -> bool:
        """Let the operator go on, or not; return whether something follows."""
        if self.machine.next_command_s is not None:
            return True
        deeds = list(self.search.operator.afterwards(self.future))
        if not deeds or self.draw.random() < 0.2:
            return False
        deed = self.draw.choice(deeds)
        self.machine.issue(deed.commands)
        self.machine.next_tick = self.machine.last_tick + 1
        self.future.again += deed.decided.what is What.AGAIN
        self.story.append(deed.decided)
        return True


def compare(walk: Walk, ended: Machine) -> None:
    """Compare how a walk ends with the run of its scenario, on the ordinary engine."""
    search = walk.search
    story = sorted(walk.story, key=lambda one: one.time_s)
    scenario = scenario_of(search.environment, story, ended.tick)
    run = execute(search.module, SCENE, scenario)
    known = run.machine
    assert known.robot.ending is ended.robot.ending
    assert known.system.terminal.characters == ended.system.terminal.characters
    assert known.finished == ended.finished
    at_s = max(known.ended_s or 0.0, ended.ended_s or 0.0)
    planners = known.system.planner, ended.system.planner
    assert planners[0].configuration_at(at_s) == planners[1].configuration_at(at_s)
    assert known.system.hand.held == ended.system.hand.held


def walked(number: int, walks: int) -> tuple[int, set[What]]:
    """Return how many walks through a program ended, and what was decided on them.

    No walk: there are more futures than are looked at.
    """
    search = searched(compiled(asking(number)), SCENE, environment(number), MOST)
    if not search.is_over or search.grows.looked_at:
        return 0, set()
    ended, decided = 0, set[What]()
    for seed in range(walks):
        walk = Walk(search, SCENE, Random(f"{number}.{seed}"))
        if walk.go():
            ended += 1
            compare(walk, walk.machine)
        decided |= {one.what for one in walk.story}
        if walk.machine.robot.ending is Ending.ERROR:
            assert len(search.suspects)
    return ended, decided


@pytest.mark.thorough
@pytest.mark.parametrize("number", [*USUAL, *MANY])
@deep_stack()
def test_whatever_chance_brings_about_is_among_the_futures(number: int) -> None:
    ended, _ = walked(number, WALKS)
    assert ended > 0
