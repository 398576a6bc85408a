"""Contacts and limits of motion, certified as futures go on, told of the futures they are in."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.units import deg
from vrts.check.verdicts.limits import JOINT_POSITION
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Event
from vrts.engine.motion.remarks import JOINT_SPEED
from vrts.prove.asking import Beside, Here, Later
from vrts.prove.certify.certifier import Certifier
from vrts.prove.certify.looking import Looked, New, looked_at
from vrts.prove.certify.memory import Memory
from vrts.prove.certify.touching import Beyond, Touching
from vrts.prove.explore.frontier import Future
from vrts.prove.graph.excused import not_excused
from vrts.prove.graph.graph import Graph
from vrts.prove.graph.past import Past
from vrts.prove.graph.suspects import Suspect, Suspects
from vrts.prove.proof import Wrong
from vrts.scene.model import Scene

WORTH = 200  # stretches of motion; fewer are certified here sooner than somebody else has begun


class _Asked(NamedTuple):
    """Motion that others certify, and how many states were looked at when they were asked."""

    later: Later[Looked]
    new: New
    states: float


class Touches:
    """Certifies the motion of all futures of a search."""

    def __init__(self, scene: Scene, graph: Graph, suspects: Suspects) -> None:
        """Begin with nothing certified."""
        self._certifier = Certifier(scene)
        self._graph, self._suspects = graph, suspects
        self._tick_s = scene.robot.arm.tick
        self._open: list[Touching] = []  # what something later may excuse
        self._asked: _Asked | None = None  # what is certified meanwhile
        self.wrong_since = math.inf  # states, when motion was asked for that is wrong
        self._still: tuple[object, object, float] = (None, None, 0.0)  # arm, hand, since when [s]

    @property
    def motion_s(self) -> float:
        """How much motion was certified [s]."""
        return self._certifier.motion_s

    @property
    def waiting_s(self) -> float:
        """How much motion waits for it [s]."""
        return self._certifier.waiting_s

    def follow(self, future: Future, events: Sequence[Event]) -> Memory:
        """Note how a future has moved; return what is remembered of it."""
        machine, memory = future.machine, future.memory
        if not events and self._rests(machine, memory):
            until_s = max(machine.now, (machine.next_tick - 1) * machine.tick)
            return Memory(until_s, *memory[1:])
        memory = self._certifier.follow(memory, machine, events, future.leg)
        self._keep(future, memory)
        return memory

    def finish(self, future: Future) -> None:
        """Note what still moves in a future that ends."""
        self._keep(future, self._certifier.finish(future.memory, future.machine, future.leg))

    def certify(self, beside: Beside = Here, states: float = math.inf) -> None:
        """Certify what is new, or let it be certified while the search goes on.

        What was found is told at the next call, if not now; nothing that is told depends on it.

        Args:
            beside: Makes the question that others may answer.
            states: How many states were looked at.
        """
        self.take_in()
        new = self._certifier.take()
        if len(new.entries) < WORTH:
            self._told(new, looked_at(new), states)
            return
        self._asked = _Asked(beside(looked_at, new), new, states)
        if not self._asked.later.begin():
            self.take_in()

    def take_in(self) -> None:
        """Tell what was certified meanwhile."""
        asked, self._asked = self._asked, None
        if asked is not None:
            try:
                looked = asked.later.answer()
            finally:
                asked.later.end()
            self._told(asked.new, looked, asked.states)

    def close(self) -> None:
        """Leave nobody behind who certifies."""
        if self._asked is not None:
            self._asked.later.end()

    def _told(self, new: New, looked: Looked, states: float) -> None:
        """Tell what was found in new motion when so many states were looked at."""
        touching, beyond = self._certifier.certified(new, looked)
        for touch in touching:
            if touch.unless is None:
                leg = self._graph.legs[touch.future]
                self._suspects.add(self._contact(touch, leg.past))
            else:
                self._open.append(touch)
        for one in beyond:
            self._suspects.add(self._limit(one))
        if beyond or any(touch.unless is None for touch in touching):
            self.wrong_since = min(self.wrong_since, states)

    def settle(self) -> None:
        """Certify what is left, and tell what nothing excuses: no more futures are looked at."""
        self.certify()
        for touch in self._open:
            found = not_excused(self._graph, touch, self._tick_s)
            if found is not None:
                self._suspects.add(self._contact(touch, found.past))

    def _rests(self, machine: Machine, memory: Memory) -> bool:
        """Return whether nothing has moved since it was looked at last, nor will before a tick."""
        if memory.letting_go or memory.coming or memory.outcomes:
            return False
        given, hand = machine.system.planner.given, machine.system.hand
        if machine.system.parts is None:
            return memory.seen_s > 0.0 and memory.seen_s >= _still_from(machine)
        arm, fingers, still_s = self._still  # which quiet machines share
        if arm is not given or fingers is not hand:
            still_s = _still_from(machine)
            self._still = given, hand, still_s
        return memory.seen_s > 0.0 and memory.seen_s >= still_s

    def _keep(self, future: Future, memory: Memory) -> None:
        if memory.outcomes:
            self._graph.legs[future.leg].outcomes += memory.outcomes

    def _contact(self, touch: Touching, past: Past | None) -> Suspect:
        bodies = (touch.first, touch.second, *touch.parts)
        words = f"{touch.first} touches {touch.second}"
        cost = self._graph.legs[touch.future].cost
        return Suspect(
            *(Wrong.CONTACT, bodies, words, touch.time_s, None, past, cost),
            where=self._where(touch.future),
            certain=touch.certain,
        )

    def _limit(self, one: Beyond) -> Suspect:
        leg = self._graph.legs[one.future]
        rule = JOINT_SPEED if one.speed else JOINT_POSITION
        unit = "deg/s" if one.speed else "degrees"
        words = f"joint {one.joint + 1} comes to {deg(one.value):.1f} {unit}"
        what = (rule.code, str(one.joint + 1))
        return Suspect(
            *(Wrong.LIMIT, what, words, one.time_s, None, leg.past, leg.cost),
            where=self._where(one.future),
        )

    def _where(self, leg: int) -> object:
        """Return where the robot program is when a leg begins."""
        start = self._graph.legs[leg].start
        return None if start is None else self._graph.visits[start].place


def _still_from(machine: Machine) -> float:
    """Return from when on nothing moves any more, as far as it is known [s]; inf: nobody knows."""
    planner, hand = machine.system.planner, machine.system.hand
    if planner.pending is not None or hand.closing is not None:
        return math.inf
    still_s = max(planner.braking_until, planner.scale.time(planner.given.end_s))
    if hand.strokes:
        still_s = max(still_s, hand.strokes[-1].end_s)
    for track in hand.placements.values():
        still_s = max(still_s, track[-1].start_s)
    return still_s
