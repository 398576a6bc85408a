"""The search: futures go on one after another, part where outside decides, and meet again."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Severity
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.nearly import nearly
from vrts.engine.memory.events import Cause, Event, Found
from vrts.engine.memory.records import Ending
from vrts.engine.motion.remarks import JOINT_SPEED
from vrts.engine.programs.cycles import place
from vrts.engine.programs.outside import Kind, Question
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.ir.ranges import INPUTS
from vrts.prove.asking import Asking, Told
from vrts.prove.environment.environment import Environment
from vrts.prove.environment.states import Behaviours
from vrts.prove.explore.contacts import Certifies
from vrts.prove.explore.executed import Executed, watched
from vrts.prove.explore.frontier import Frontier, Future
from vrts.prove.explore.goals import End
from vrts.prove.explore.graph import AWAY, Graph, Visit
from vrts.prove.explore.never import never_ending, places
from vrts.prove.explore.operator import Deed, Operator
from vrts.prove.explore.outside import Outside, Way
from vrts.prove.explore.past import Past
from vrts.prove.explore.suspects import Suspect, Suspects
from vrts.prove.proof import Branch, Decided, What, Wrong
from vrts.scene.model import Scene

AFTERWARDS_S = 0.5  # of motion that is looked at behind the end of a program
MOST_BRANCHES = 5_000  # of the tree of decisions that are kept
TELL = 1_000  # states between looks at whether it is enough
CERTIFY = 4_000  # states between certificates, at least


class Counts(NamedTuple):
    """What a search went through."""

    states: int
    decisions: int
    merged: int
    ends: int


class Search:
    """All futures of a program in an environment."""

    def __init__(
        self,
        module: Module,
        scene: Scene,
        environment: Environment,
        behaviours: Behaviours,
        contacts: Certifies,
        *,
        merging: bool = True,
    ) -> None:
        """Take what is the same in every future.

        Args:
            module: The programs.
            scene: Where the robot stands.
            environment: What may come from outside.
            behaviours: What the environment says of inputs.
            contacts: Certifies that nothing touches.
            merging: Whether futures in the same state go on as one; without, few programs end.
        """
        self.module, self.scene = module, scene
        self.outside = Outside(environment, behaviours)
        self.environment = environment
        self.contacts = contacts
        self.keys = Keys(module)
        self.executed = Executed()
        self.first: Machine  # that knows the programs
        self.graph = Graph()
        self.frontier = Frontier()
        self.suspects = Suspects()
        self.asked: dict[Question, None] = {}
        self.unanswered: dict[object, None] = {}  # places of questions that nobody answers
        self.tree: list[Branch] = []
        self.decisions = self.merged = self.ends = 0
        self.is_over = False
        self.endings: dict[tuple[object, ...], End] = {}
        self._known: dict[Key, int] = {}
        self._pasts: list[tuple[Past | None, int]] = []  # by number of future, with its cost
        self._merging = merging

    def run(self, entry: str, states: object, asking: Asking) -> None:
        """Look at every future of a program, as far as is asked."""
        self.operator = Operator(self.environment, entry)
        self._begin(entry, states)
        told = certified = 0
        while self.frontier:
            count = len(self.graph.visits)
            if count >= asking.states:
                break
            if count - told >= TELL:
                told = count
                asking.told(Told(count, len(self.frontier), len(self.suspects)))
                if asking.enough():
                    break
            if count - certified >= CERTIFY:
                certified = count
                self._certify()
            self._go_on(self.frontier.pop(), asking.states)
        self._certify()
        self.is_over = not self.frontier
        for future in self.frontier.waiting():
            self.graph.leads(future.state, AWAY)
        for suspect in never_ending(self.graph, self.first):
            self.suspects.add(suspect)
        asking.told(Told(len(self.graph.visits), len(self.frontier), len(self.suspects)))

    @property
    def counts(self) -> Counts:
        """What the search went through so far."""
        return Counts(len(self.graph.visits), self.decisions, self.merged, self.ends)

    # --- beginnings and forks -----------------------------------------------------------------

    def _begin(self, entry: str, states: object) -> None:
        """Let the program be executed at every monitor speed."""
        environment = self.environment
        usual = environment.scenario
        said = {number for _, number, _ in usual.inputs}
        said |= {sensor.signal for sensor in usual.sensors}
        free = frozenset(INPUTS) - said
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
            )
            watched(machine, self.executed)
            command(machine, Execute(entry))
            self.first = machine if k == 0 else self.first
            decided = Decided(0.0, What.SPEED, 0, speed, None)
            past = Past(None, decided) if len(environment.speeds) > 1 else None
            branch = self._branch(None, None if past is None else decided)
            self._push(Future(0, machine.copy(), past, int(k > 0), {}, states, branch))

    def _push(self, future: Future) -> None:
        """Let a future wait under a number of its own."""
        future.number = len(self._pasts)
        self._pasts.append((future.past, future.cost))
        self.frontier.push(future)

    def _fork(self, future: Future, question: Question, ways: tuple[Way, ...]) -> None:
        """Let a future go on in every way."""
        self.decisions += 1
        behaviours = self.outside.behaviours
        for k, way in enumerate(ways):
            machine = future.machine if k == len(ways) - 1 else future.machine.copy()
            decide(machine, question, way.value)
            other = self._other(future, machine, way.cost, way.decided)
            if question.kind is Kind.INPUT:
                assert isinstance(way.value, bool)
                if way.decided is not None:
                    other.inputs = {**future.inputs, question.number: way.value}
                other.outside = behaviours.told(future.outside, question.number, value=way.value)
            self._push(other)
            if question.kind is Kind.GRIP:
                self._watch(other)

    def _other(
        self, future: Future, machine: Machine, cost: int, decided: Decided | None
    ) -> Future:
        """Return a future that goes on from another one, in which something was decided."""
        known = decided is None
        return Future(
            future.number,
            machine,
            future.past if known else Past(future.past, decided),
            future.cost + cost,
            future.inputs,
            future.outside,
            future.branch if known else self._branch(future, decided),
            future.state,
            future.again,
            future.stopped,
        )

    def _does(self, future: Future, deed: Deed) -> None:
        """Let a future go on in which the operator does something."""
        machine = future.machine.copy()
        machine.issue(deed.commands)
        other = self._other(future, machine, 1, deed.decided)
        other.again += deed.decided.what is What.AGAIN
        other.stopped |= deed.decided.what is What.STOP
        self.decisions += 1
        self._push(other)

    def _branch(self, future: Future | None, decided: Decided | None) -> int | None:
        if len(self.tree) >= MOST_BRANCHES or (future is not None and future.branch is None):
            return None
        self.tree.append(Branch(None if future is None else future.branch, decided, ""))
        return len(self.tree) - 1

    def _ends(self, future: Future, how: str) -> None:
        if future.branch is not None and not self.tree[future.branch].ends:
            self.tree[future.branch] = self.tree[future.branch]._replace(ends=how)

    # --- going on -----------------------------------------------------------------------------

    def _go_on(self, future: Future, most: int) -> None:
        """Go on with a future until outside decides, it meets another, or others come first."""
        machine, graph = future.machine, self.graph
        while True:
            question = tick(machine)
            if question is None:
                self._over(future)
                if not machine.robot.running and machine.next_command_s is None:
                    self._ended(future)
                    return
            if self._meets(future, question):
                return
            stop = self.operator.stops(future) if question is None else None
            if stop is not None:
                self._does(future, stop)
            if question is not None:
                self.asked.setdefault(question)
                ways = self.outside.ways(future, question)
                if not ways:
                    self.unanswered.setdefault(place(machine.robot))
                    graph.leads(future.state, AWAY)
                    self._ends(future, "open")
                    return
                self._fork(future, question, ways)
                return
            if self.frontier.is_earlier(future) or len(graph.visits) >= most:
                self.frontier.push(future)
                return

    def _meets(self, future: Future, question: Question | None) -> bool:
        """Note the state that a future is in; return whether another one was in it before."""
        machine, graph = future.machine, self.graph
        key = self._key(future, question)
        known = self._known.get(key) if self._merging else None
        if known is not None:
            graph.leads(future.state, known)
            self.merged += 1
            self._ends(future, "merged")
            return True
        visit = Visit(
            future.past,
            machine.last_tick,
            future.cost,
            *places(machine),
            question is not None,
        )
        state = graph.add(visit)
        self._known[key] = state
        graph.leads(future.state, state)
        future.state = state
        return False

    def _key(self, future: Future, question: Question | None) -> Key:
        memory = self.operator.memory(future)
        remembered = self.contacts.state(future.machine)
        return self.keys.of(future.machine, (question, remembered, future.outside, memory))

    def knows(self, machine: Machine, states: object) -> bool:
        """Return whether a machine, at the end of a tick, is in a state that was looked at."""
        return self._key(Future(0, machine, None, 0, {}, states, None), None) in self._known

    def _over(self, future: Future) -> None:
        """Look at what a tick has brought about, and at the motion up to the next one."""
        machine = future.machine
        events = happened(machine)
        if events:
            self._look(future, events)
        self.contacts.happened(machine, events)
        if self.operator.may_stop(future):
            machine.next_tick = machine.last_tick + 1  # there may be a stop in each of them
        if machine.robot.running or machine.next_command_s is not None:
            self._watch(future)
            ticks = machine.next_tick - machine.last_tick
            on = frozenset(machine.system.signals.on)
            future.outside = self.outside.behaviours.advance(future.outside, ticks, on)

    def _watch(self, future: Future) -> None:
        """Let the motion up to the next tick be certified."""
        machine = future.machine
        self.contacts.look(machine, machine.next_tick * machine.tick, future.number)

    def _look(self, future: Future, events: Sequence[Event]) -> None:
        for event in events:
            if not isinstance(event, Found):
                continue
            found = event.diagnostic
            if found.rule == JOINT_SPEED:
                wrong = Wrong.LIMIT
            elif found.severity is Severity.ERROR:
                wrong = Wrong.ERROR
            else:
                continue
            code = (found.rule.code,)
            self._suspect(future, wrong, code, found.headline, event.time_s, event.cause)

    def _ended(self, future: Future) -> None:
        machine = future.machine
        self.ends += 1
        self.graph.leads(future.state, AWAY)
        ending = machine.robot.ending
        self._ends(future, ending.value)
        ended_s = machine.ended_s or machine.now
        self.contacts.look(machine, ended_s + AFTERWARDS_S, future.number)
        for deed in self.operator.afterwards(future):
            self._does(future, deed)
        if ending not in (Ending.COMPLETED, Ending.HALTED) or future.again or future.stopped:
            return
        lies = [track[-1] for track in machine.system.hand.placements.values()]
        lain = tuple((one.body, one.lie, one.support, nearly(one.X)) for one in lies)
        end = (ending, lain, machine.system.hand.held)
        self.endings.setdefault(end, End(future.past, future.cost, ended_s))

    def _suspect(
        self,
        future: Future,
        wrong: Wrong,
        what: tuple[str, ...],
        headline: str,
        time_s: float,
        cause: Cause | None,
    ) -> None:
        suspect = Suspect(wrong, what, headline, time_s, cause, future.past, future.cost)
        self.suspects.add(suspect)

    # --- what is found now and then -------------------------------------------------------------

    def _certify(self) -> None:
        for touch in self.contacts.certify():
            past, cost = self._pasts[touch.future]
            bodies = (touch.first, touch.second)
            words = f"{touch.first} touches {touch.second}, {1e3 * touch.depth_m:.1f} mm deep"
            self.suspects.add(Suspect(Wrong.CONTACT, bodies, words, touch.time_s, None, past, cost))
