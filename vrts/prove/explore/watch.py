"""Properties of one's own, watched in every tick of every future."""

from collections.abc import Iterable, Iterator

from vrts.prove.environment.environment import Environment
from vrts.prove.environment.states import Behaviours
from vrts.prove.explore.frontier import Future
from vrts.prove.graph.past import Past, story
from vrts.prove.graph.suspects import Suspect, Suspects
from vrts.prove.proof import Decided, What, Wrong
from vrts.prove.properties.moments import Moment, of_machine
from vrts.prove.properties.monitor import Broken, Memory, Monitor
from vrts.scene.model import Scene


class Watch:
    """Watches the properties of an environment."""

    def __init__(
        self, environment: Environment, behaviours: Behaviours, scene: Scene, suspects: Suspects
    ) -> None:
        """Take the properties, what inputs may be, and who is told."""
        robot = scene.robot
        self._properties = environment.properties
        self._behaviours, self._tick_s = behaviours, robot.arm.tick
        self._monitor = Monitor(environment.properties, robot.gripper, robot.arm.tick)
        self._suspects = suspects

    def begin(self) -> Memory:
        """Return what is remembered before the first tick."""
        return self._monitor.begin()

    def follow(self, future: Future) -> None:
        """Watch the last tick of a future, and those that it skips."""
        machine, states = future.machine, future.outside
        on = frozenset(machine.system.signals.on)
        for tick in range(machine.last_tick, machine.next_tick):
            moment = self._moment(future, tick, states)
            future.watched, broken = self._monitor.follow(future.watched, moment)
            if broken is not None:
                self._suspects.add(self._suspect(future, broken, moment.time_s))
            if tick + 1 < machine.next_tick:
                states = self._behaviours.advance(states, 1, on)

    def finish(self, future: Future) -> None:
        """Watch on after a future has ended: until the arm stands and nothing is due any more."""
        machine, states, watched = future.machine, future.outside, future.watched
        on = frozenset(machine.system.signals.on)
        stands = machine.tick_of(machine.system.planner.settled_at) + 1
        tick = machine.last_tick
        while tick <= stands or any(due is not None for _, due in watched):
            moment = self._moment(future, tick, states)
            watched, broken = self._monitor.follow(watched, moment, over=tick > stands)
            if broken is not None:
                self._suspects.add(self._suspect(future, broken, moment.time_s))
            states = self._behaviours.advance(states, 1, on)
            tick += 1

    def _moment(self, future: Future, tick: int, states: object) -> Moment:
        """Return a tick in which inputs that nobody decided are what they may be."""
        moment = of_machine(future.machine, tick)

        def looked(number: int) -> bool:
            return moment.signal(number) is not None

        def signal(number: int) -> bool | None:
            found = moment.signal(number)
            if found is None:
                levels = self._behaviours.may(states, number)
                return levels[0] if len(levels) == 1 else None
            return found

        return moment._replace(signal=signal, looked=looked)

    def _suspect(self, future: Future, broken: Broken, time_s: float) -> Suspect:
        more = [
            Decided(time_s, What.INPUT, number, on, None)
            for number, on in broken.inputs
            if _known(future, number, time_s) is not on
        ]
        if broken.began is not None:
            more += self._began(future, broken.began, time_s)
        past = future.past if not more else _with(future.past, more)
        one = self._properties[broken.number]
        words = f"{one.quantifier.value}: {one.title}"
        what = (str(broken.number),)
        cost = future.cost + len(more)
        return Suspect(Wrong.PROPERTY, what, words, time_s, None, past, cost)

    def _began(
        self, future: Future, began: tuple[int, bool, int], time_s: float
    ) -> Iterator[Decided]:
        """Yield how an input came to its level, for a tick only where it is free."""
        number, level, ago = began
        came_s = time_s - ago * self._tick_s
        known = _known(future, number, came_s)
        if known is level:
            yield Decided(came_s - self._tick_s, What.INPUT, number, not level, None)
        yield Decided(came_s, What.INPUT, number, level, None)
        if known is not level and ago > 0 and not self._behaviours.says(number):
            yield Decided(came_s + self._tick_s, What.INPUT, number, known, None)


def _known(future: Future, number: int, until_s: float) -> bool:
    """Return what an input was when it was decided last before a time [s]."""
    known = False
    for decided in story(future.past):
        if decided.what is What.INPUT and decided.number == number and decided.time_s < until_s:
            known = decided.value is True
    return known


def _with(past: Past | None, more: Iterable[Decided]) -> Past | None:
    """Return a past with decisions that nobody had to take, in time order."""
    found: Past | None = None
    for decided in sorted([*story(past), *more], key=_time):
        found = Past(found, decided)
    return found


def _time(decided: Decided) -> float:
    return decided.time_s
