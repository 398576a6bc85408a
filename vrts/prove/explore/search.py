"""The search: futures go on one after another, part where outside decides, and meet again."""

import math
from collections.abc import Sequence
from dataclasses import replace

from vrts.base.diagnostic import Severity
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.futures.quiet import fork, let_go
from vrts.engine.futures.since import since
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.nearly import nearly
from vrts.engine.memory.events import Event, Found
from vrts.engine.memory.records import Ending
from vrts.engine.motion.remarks import JOINT_SPEED
from vrts.engine.programs.cycles import place
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.ir.ranges import ANALOG_INPUTS, INPUTS
from vrts.prove.asking import Asking, Told
from vrts.prove.certify.memory import Memory
from vrts.prove.environment.environment import Environment
from vrts.prove.explore.counts import Counts
from vrts.prove.explore.executed import Executed, watched
from vrts.prove.explore.frontier import Frontier, Future
from vrts.prove.explore.operator import Deed, Operator
from vrts.prove.explore.outside import Outside, Way
from vrts.prove.explore.sharing import may_differ
from vrts.prove.explore.touches import Touches
from vrts.prove.explore.tree import Tree
from vrts.prove.explore.watch import Watch
from vrts.prove.graph.graph import Graph, Visit
from vrts.prove.graph.grows import Grows
from vrts.prove.graph.never import for_ever, never_ending, never_left, places
from vrts.prove.graph.past import Past
from vrts.prove.graph.suspects import End, Suspect, Suspects
from vrts.prove.proof import Decided, What, Wrong
from vrts.scene.model import Scene

TELL = 1_000  # states between looks at whether it is enough
LONGER, SOON = 2, 5_000  # something seems wrong: so many times as many states, and so many more
CERTIFY_S = 60.0  # of new motion that is certified together


class Search:
    """All futures of a program in an environment."""

    def __init__(
        self,
        module: Module,
        scene: Scene,
        environment: Environment,
        *,
        collisions: bool = True,
        merging: bool = True,
    ) -> None:
        """Take what is the same in every future.

        Args:
            module: The programs.
            scene: Where the robot stands.
            environment: What may come from outside.
            collisions: Whether motion is certified.
            merging: Whether futures in the same state go on as one; without, few programs end.
        """
        self.module, self.scene, self.environment = module, scene, environment
        self.tick_s = scene.robot.arm.tick
        self.outside = Outside(environment, module, self.tick_s)
        self.graph = Graph()
        self.suspects = Suspects()
        self.touches = Touches(scene, self.graph, self.suspects) if collisions else None
        self.keys: Keys
        self.grows: Grows
        self.executed = Executed()
        self.watch: Watch | None = None
        if environment.properties:
            self.watch = Watch(environment, self.outside.behaviours, scene, self.suspects)
        self.first: Machine  # that knows the programs
        self.frontier = Frontier()
        self.asked: dict[Question, None] = {}
        self.unanswered: dict[object, None] = {}  # places of questions that nobody answers
        self.tree = Tree()
        self.decisions = self.merged = self.ends = 0
        self.is_over = self.was_enough = False
        self.never_left: tuple[str, ...] = ()  # where programs that look outside go round
        self.endings: dict[tuple[object, ...], End] = {}
        self._known: dict[Key, int] = {}
        self._merging = merging
        self._may_stop = bool(environment.stops)

    def begin(self, entry: str) -> None:
        """Let a program be executed, at every monitor speed."""
        self.operator = Operator(self.environment, entry)
        self._begin(entry)

    def go_on(self, asking: Asking, *, patiently: bool = True) -> None:
        """Look at the futures that are left, as far as is asked.

        Args:
            asking: How far to look, and who is told.
            patiently: Whether to go on for long although something seems to go wrong already.
        """
        told, touches, suspected = len(self.graph.visits), self.touches, math.inf
        while self.frontier:
            count = len(self.graph.visits)
            if count >= asking.states:
                break
            if count >= asking.states // 2:
                self.frontier.spread()
            due = count - told >= TELL
            if touches is not None and (due or touches.waiting_s >= CERTIFY_S):
                touches.certify(asking.beside, count)
            if due:
                told = count
                asking.told(self.so_far)
                if asking.enough():
                    self.was_enough = True
                    break
            if not patiently and self.suspects:
                suspected = min(suspected, count, touches.wrong_since if touches else count)
                if count > suspected * LONGER + SOON:
                    break
            self._go_on(self.frontier.pop(), asking.states)
        self.is_over = not self.frontier
        if touches is not None:
            touches.settle()
        closed = for_ever(self.graph)
        for suspect in never_ending(self.graph, closed, self.first):
            self.suspects.add(suspect)
        self.never_left = tuple(dict.fromkeys(never_left(closed, self.first)))
        asking.told(self.so_far)

    def close(self) -> None:
        """Leave nobody behind who certifies."""
        if self.touches is not None:
            self.touches.close()

    @property
    def so_far(self) -> Told:
        """How far it has come."""
        return Told(len(self.graph.visits), len(self.frontier), len(self.suspects))

    @property
    def counts(self) -> Counts:
        """What the search went through so far."""
        return Counts(len(self.graph.visits), self.decisions, self.merged, self.ends)

    def knows(
        self,
        machine: Machine,
        memory: Memory,
        question: Question | None = None,
        *,
        stopped: bool = False,
        again: int = 0,
    ) -> bool:
        """Return whether a machine is in a state that was looked at.

        Args:
            machine: At the end of a tick in which nothing was asked, or where something is.
            memory: What the rules of contacts remember of it.
            question: What is asked there.
            stopped: Whether the operator has stopped it.
            again: How often the program was executed before.
        """
        states = self.outside.behaviours.begin()
        future = Future(0, machine, None, 0, {}, states, None, memory, again, stopped)
        return self._key(future, question) in self._known

    # --- beginnings and forks -----------------------------------------------------------------

    def _begin(self, entry: str) -> None:
        """Let the program be executed at every monitor speed."""
        environment = self.environment
        usual = environment.scenario
        said = {number for _, number, _ in usual.inputs}
        said |= {sensor.signal for sensor in usual.sensors}
        said |= {-channel for _, channel, _ in usual.analog}
        free = frozenset((*INPUTS, *(-channel for channel in ANALOG_INPUTS))) - said
        states = self.outside.behaviours.begin()
        for k, speed in enumerate(environment.speeds):
            scenario = replace(usual, monitor_speed=speed)
            machine = begin(
                self.module,
                self.scene,
                scenario,
                free,
                answers=True,
                random=True,
                grips=environment.misses,
                turns=environment.turns and may_differ(self.module, entry),
            )
            watched(machine, self.executed)
            command(machine, Execute(entry))
            self.first = machine if k == 0 else self.first
            if k == 0:
                self.grows = Grows(self.module, machine.executable, self.graph)
                once = environment.again.most == 0
                held = since(self.module, self.tick_s, entry, once=once)
                self.keys = Keys(self.module, self.grows.idle, held)
            several = len(environment.speeds) > 1
            decided = Decided(0.0, What.SPEED, 0, speed, None) if several else None
            past = None if decided is None else Past(None, decided)
            leg = self.graph.begin(None, past, int(k > 0), decided)
            branch = self.tree.add(None, decided)
            other = Future(leg, machine.copy(), past, int(k > 0), {}, states, branch, Memory())
            other.watched = () if self.watch is None else self.watch.begin()
            self.frontier.push(other)

    def _fork(self, future: Future, question: Question, ways: tuple[Way, ...]) -> None:
        """Let a future go on in every way."""
        self.decisions += 1
        behaviours = self.outside.behaviours
        state = self.graph.legs[future.leg].to
        for k, way in enumerate(ways):
            machine = future.machine if k == len(ways) - 1 else fork(future.machine)
            decide(machine, question, way.value)
            other = self._other(future, state, machine, way.cost, way.decided)
            if question.kind is Kind.INPUT:
                assert isinstance(way.value, bool)
                if way.decided is not None:
                    other.inputs = {**future.inputs, question.number: way.value}
                other.outside = behaviours.told(future.outside, question.number, value=way.value)
            elif question.kind is Kind.ANALOG and way.decided is not None:
                assert isinstance(way.value, float)
                other.inputs = {**future.inputs, -question.number: way.value}
            self.frontier.push(other)

    def _other(
        self, future: Future, state: int, machine: Machine, cost: int, decided: Decided | None
    ) -> Future:
        """Return a future that goes on from a state of another one, where something was decided."""
        past, branch = future.past, future.branch
        cost += future.cost
        if decided is not None:
            past, branch = Past(past, decided), self.tree.add(branch, decided)
        return Future(
            self.graph.begin(state, past, cost, decided),
            machine,
            past,
            cost,
            future.inputs,
            future.outside,
            branch,
            future.memory,
            future.again,
            future.stopped,
            not self.environment.stops,
            future.watched,
        )

    def _does(self, future: Future, state: int, deed: Deed) -> None:
        """Let a future go on in which the operator does something."""
        machine = future.machine.copy()
        machine.issue(deed.commands)
        if not machine.robot.running:
            machine.next_tick = machine.last_tick + 1  # no motion is skipped that was not looked at
        other = self._other(future, state, machine, 1, deed.decided)
        other.again += deed.decided.what is What.AGAIN
        other.stopped |= deed.decided.what is What.STOP
        other.asked = False
        self.decisions += 1
        self.frontier.push(other)

    # --- going on -----------------------------------------------------------------------------

    def _go_on(self, future: Future, most: int) -> None:
        """Go on with a future until outside decides, it meets another, or others come first."""
        machine = future.machine
        while True:
            question = tick(machine)
            if question is None:
                self._over(future)
                if not machine.robot.running and machine.next_command_s is None:
                    self._ended(future)
                    return
            if question is None and future.asked:
                future.asked = False  # others in this state are met where something is asked next
            elif self._meets(future, question):
                return
            elif question is not None:
                self._asks(future, question)
                return
            else:
                state = self.graph.legs[future.leg].to
                stop = self.operator.stops(future) if self._may_stop else None
                if stop is not None:
                    self._does(future, state, stop)
                future.leg = self.graph.begin(state, future.past, future.cost)
            if self.frontier.is_earlier(future) or len(self.graph.visits) >= most:
                self.frontier.push(future)
                return

    def _asks(self, future: Future, question: Question) -> None:
        """Let outside decide."""
        self.asked.setdefault(question)
        ways = self.outside.ways(future, question)
        if ways:
            self._fork(future, question, ways)
            return
        self.unanswered.setdefault(place(future.machine.robot))
        self.graph.begin(self.graph.legs[future.leg].to, future.past, future.cost)
        self.tree.ends(future.branch, "open", future.machine.now)

    def _meets(self, future: Future, question: Question | None) -> bool:
        """Note the state that a future is in; return whether another one was in it before."""
        machine, graph = future.machine, self.graph
        key = self._key(future, question)
        known = self._known.get(key) if self._merging else None
        if known is not None:
            graph.arrives(future.leg, known, machine.last_tick)
            self.grows.met(machine, known, future.leg)
            self.merged += 1
            self.tree.ends(future.branch, "merged", machine.now, known)
            let_go(machine)
            return True
        place, waits = places(machine)
        asks = question is not None and self.outside.is_open(future, question)
        tick, cost = machine.last_tick, future.cost
        visit = Visit(future.past, tick, cost, place, waits, asks, future.leg)
        self._known[key] = state = graph.add(visit)
        self.frontier.visits(future)
        self.tree.visits(future.branch, state)
        graph.arrives(future.leg, state, machine.last_tick)
        if not self.grows.state(self.keys, key, machine, state):
            return False
        graph.begin(state, future.past, future.cost)  # nobody knows where it comes to
        self.tree.ends(future.branch, "open", future.machine.now)
        return True

    def _key(self, future: Future, question: Question | None) -> Key:
        machine = future.machine
        remembered = None if self.touches is None else future.memory.state(machine)
        memory = self.operator.memory(future)
        return self.keys.of(machine, (question, remembered, future.outside, memory, future.watched))

    def _over(self, future: Future) -> None:
        """Look at what a tick has brought about, and at the motion up to the next one."""
        machine = future.machine
        events = happened(machine)
        if events:
            self._look(future, events)
        if self._may_stop:
            stop = self.operator.next_stop(future)
            if stop is not None:
                machine.next_tick = min(machine.next_tick, stop)  # no stop is skipped
        if self.touches is not None:
            future.memory = self.touches.follow(future, events)
        if machine.robot.running or machine.next_command_s is not None:
            if self.watch is not None:
                self.watch.follow(future)
            if future.outside:
                ticks = machine.next_tick - machine.last_tick
                on = frozenset(machine.system.signals.on)
                future.outside = self.outside.behaviours.advance(future.outside, ticks, on)

    def _look(self, future: Future, events: Sequence[Event]) -> None:
        for event in events:
            if not isinstance(event, Found):
                continue
            found = event.diagnostic
            if found.rule == JOINT_SPEED and self.touches is None:
                wrong = Wrong.LIMIT
            elif found.severity is Severity.ERROR and found.rule != JOINT_SPEED:
                wrong = Wrong.ERROR
            else:
                continue
            code, cause = (found.rule.code,), event.cause
            past, cost = future.past, future.cost
            self.suspects.add(Suspect(wrong, code, found.headline, event.time_s, cause, past, cost))

    def _ended(self, future: Future) -> None:
        """Note how a future ends; it may go on where the operator does something."""
        machine, ending = future.machine, future.machine.robot.ending
        self.ends += 1
        deeds = list(self.operator.afterwards(future))
        if deeds and self._meets(future, None):
            return
        self.tree.ends(future.branch, ending.value, machine.now)
        if self.watch is not None:
            self.watch.finish(future)
        if self.touches is not None:
            self.touches.finish(future)
        if deeds:
            state = self.graph.legs[future.leg].to
            self.graph.begin(state, future.past, future.cost)
            for deed in deeds:
                self._does(future, state, deed)
        if ending not in (Ending.COMPLETED, Ending.HALTED) or future.again or future.stopped:
            return
        ended_s = machine.now if machine.ended_s is None else machine.ended_s
        lies = [track[-1] for track in machine.system.hand.placements.values()]
        lain = tuple((one.body, one.lie, one.support, nearly(one.X)) for one in lies)
        end = (ending, lain, machine.system.hand.held)
        self.endings.setdefault(end, End(future.past, future.cost, ended_s))
