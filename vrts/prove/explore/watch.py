"""Properties of one's own, watched in every tick of every future."""

from vrts.prove.environment.environment import Environment
from vrts.prove.environment.states import Behaviours
from vrts.prove.explore.frontier import Future
from vrts.prove.graph.past import Past
from vrts.prove.graph.suspects import Suspect, Suspects
from vrts.prove.proof import Decided, What, Wrong
from vrts.prove.properties.moments import Moment, of_machine
from vrts.prove.properties.monitor import Broken, Memory, Monitor
from vrts.scene.model import Scene


class Watch:
    """Watches the properties of an environment."""

    def __init__(
        self, environment: Environment, scene: Scene, behaviours: Behaviours, suspects: Suspects
    ) -> None:
        """Take the properties, what inputs may be, and who is told."""
        robot = scene.robot
        self._properties = environment.properties
        self._monitor = Monitor(environment.properties, robot.gripper, robot.arm.tick)
        self._behaviours = behaviours
        self._suspects = suspects

    def begin(self) -> Memory:
        """Return what is remembered before the first tick."""
        return self._monitor.begin()

    def follow(self, future: Future) -> None:
        """Watch the last tick of a future, and those that it skips."""
        machine = future.machine
        on, states = frozenset(machine.system.signals.on), future.outside
        for tick in range(machine.last_tick, machine.next_tick):
            if tick > machine.last_tick:
                states = self._behaviours.advance(states, 1, on)
            sure: dict[int, bool] = {}
            moment = self._with_behaviours(of_machine(machine, tick), states, sure)
            future.watched, broken = self._monitor.follow(future.watched, moment)
            if broken is not None:
                self._suspects.add(self._suspect(future, broken, moment.time_s, sure))

    def _with_behaviours(self, moment: Moment, states: object, sure: dict[int, bool]) -> Moment:
        """Return a moment in which inputs that can only be one thing are that, and note them."""
        decided = moment.signal

        def signal(number: int) -> bool | None:
            found = decided(number)
            if found is not None:
                return found
            may = self._behaviours.may(states, number)
            if len(may) == 1:
                sure[number] = may[0]
                return may[0]
            return None

        return moment._replace(signal=signal)

    def _suspect(
        self, future: Future, broken: Broken, time_s: float, sure: dict[int, bool]
    ) -> Suspect:
        past = future.past
        changed = (
            (n, on) for n, on in sorted(sure.items()) if future.inputs.get(n, False) is not on
        )
        for number, on in (*broken.inputs, *changed):
            past = Past(past, Decided(time_s, What.INPUT, number, on, None))
        one = self._properties[broken.number]
        words = f"{one.quantifier.value}: {one.title}"
        what = (str(broken.number),)
        cost = future.cost + len(broken.inputs)
        return Suspect(Wrong.PROPERTY, what, words, time_s, None, past, cost)
