"""Properties of one's own, watched in every tick of every future."""

from vrts.prove.environment.environment import Environment
from vrts.prove.explore.frontier import Future
from vrts.prove.graph.past import Past
from vrts.prove.graph.suspects import Suspect, Suspects
from vrts.prove.proof import Decided, What, Wrong
from vrts.prove.properties.moments import of_machine
from vrts.prove.properties.monitor import Broken, Memory, Monitor
from vrts.scene.model import Scene


class Watch:
    """Watches the properties of an environment."""

    def __init__(self, environment: Environment, scene: Scene, suspects: Suspects) -> None:
        """Take the properties, and who is told."""
        robot = scene.robot
        self._properties = environment.properties
        self._monitor = Monitor(environment.properties, robot.gripper, robot.arm.tick)
        self._suspects = suspects

    def begin(self) -> Memory:
        """Return what is remembered before the first tick."""
        return self._monitor.begin()

    def follow(self, future: Future) -> None:
        """Watch the last tick of a future, and those that it skips."""
        machine = future.machine
        for tick in range(machine.last_tick, machine.next_tick):
            moment = of_machine(machine, tick)
            future.watched, broken = self._monitor.follow(future.watched, moment)
            if broken is not None:
                self._suspects.add(self._suspect(future, broken, moment.time_s))

    def _suspect(self, future: Future, broken: Broken, time_s: float) -> Suspect:
        past = future.past
        for number, on in broken.inputs:
            past = Past(past, Decided(time_s, What.INPUT, number, on, None))
        one = self._properties[broken.number]
        words = f"{one.quantifier.value}: {one.title}"
        what = (str(broken.number),)
        cost = future.cost + len(broken.inputs)
        return Suspect(Wrong.PROPERTY, what, words, time_s, None, past, cost)
