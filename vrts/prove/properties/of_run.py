"""Whether a run keeps the properties of an environment: what a counterexample has to show."""

from collections.abc import Sequence
from math import ceil, floor
from typing import NamedTuple

from vrts.engine.run import Run
from vrts.prove.environment.environment import Property
from vrts.prove.properties.moments import of_run
from vrts.prove.properties.monitor import Monitor


class BrokenAt(NamedTuple):
    """A property that a run breaks."""

    number: int  # of the property
    time_s: float


def first_broken(run: Run, properties: Sequence[Property], until_s: float) -> BrokenAt | None:
    """Return the first property that a run breaks, tick by tick from 0 to a time [s].

    Once the run is over, everything stays as it is, and only what is due by then may break.
    """
    robot = run.scene.robot
    tick_s = robot.arm.tick
    monitor = Monitor(properties, robot.gripper, tick_s)
    memory, moment = monitor.begin(), of_run(run, 0)
    last = floor(run.horizon_s / tick_s + 1e-6)
    for tick in range(ceil(until_s / tick_s - 1e-6) + 1):
        if tick <= last:
            moment = of_run(run, tick)
        else:
            moment = moment._replace(time_s=tick * tick_s, still=True)
        memory, broken = monitor.follow(memory, moment, over=tick > last)
        if broken is not None:
            return BrokenAt(broken.number, tick * tick_s)
    return None
