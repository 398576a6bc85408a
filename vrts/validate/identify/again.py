"""The program executed again by a robot with other numbers: exact, ticks included."""

from collections.abc import Mapping
from dataclasses import replace
from typing import cast

from vrts.engine.controller import execute
from vrts.engine.memory.events import ProgramStarted
from vrts.engine.run import Run
from vrts.robots.built import LINKS, as_built
from vrts.robots.model import Arm, Configuration, SphericalWristArm
from vrts.validate.identify.causes import BY_TICKS, Cause, Kind

KEPT = 400  # runs that are remembered
SHORTEST_S = 0.05
SPEEDS = (Kind.SPEEDS, Kind.SPEED, Kind.LINE_SPEED)
EXECUTED = BY_TICKS | {Kind.COUNTED_LINK}  # what the controller itself has otherwise


class Again:
    """Runs of one program with other numbers; what was asked before is remembered."""

    def __init__(self, run: Run, kept: int = KEPT) -> None:
        """Take the run with the numbers that are assumed; so many others are remembered."""
        self.run = run
        self._kept = kept
        started = (e for e in run.events if isinstance(e, ProgramStarted) and not e.process)
        self._program = next(started).program
        self._known: dict[frozenset[tuple[Cause, float]], Run] = {}
        self._alike: dict[tuple[frozenset[tuple[Cause, float]], tuple[float, ...]], Run] = {}

    def with_values(self, values: Mapping[Cause, float]) -> Run:
        """Return the run of a controller with other numbers.

        With other speeds motions may take just as many ticks: then it is the same run.
        """
        own = frozenset((c, v) for c, v in values.items() if v and c.kind in EXECUTED)
        if not own:
            return self.run
        found = self._known.get(own)
        if found is None:
            if len(self._known) >= self._kept:
                self._known, self._alike = {}, {}
            arm = controller_arm(self.run.scene.robot.arm, values)
            robot = replace(self.run.scene.robot, arm=arm)
            scene = replace(self.run.scene, robot=robot)
            found = execute(self.run.module, scene, self.run.scenario, self._program)
            other = frozenset((c, v) for c, v in own if c.kind not in SPEEDS)
            ends = tuple(time for m in found.motions for time in (m.start_s, m.end_s))
            found = self._known[own] = self._alike.setdefault((other, ends), found)
        return found


def controller_arm(arm: Arm, values: Mapping[Cause, float]) -> Arm:
    """Return the arm as the controller takes it to be."""
    factor = 1.0 + values.get(Cause(Kind.SPEEDS), 0.0)
    if factor != 1.0:
        arm = replace(
            arm,
            speed=cast(Configuration, tuple(factor * speed for speed in arm.speed)),
            linear_speed=factor * arm.linear_speed,
            angular_speed=factor * arm.angular_speed,
        )
    single = [1.0 + values.get(Cause(Kind.SPEED, joint), 0.0) for joint in range(6)]
    if single != [1.0] * 6:
        speeds = tuple(f * speed for f, speed in zip(single, arm.speed, strict=True))
        arm = replace(arm, speed=cast(Configuration, speeds))
    line = 1.0 + values.get(Cause(Kind.LINE_SPEED), 0.0)
    if line != 1.0:
        arm = replace(arm, linear_speed=line * arm.linear_speed)
    longer = values.get(Cause(Kind.ACCELERATION), 0.0)
    wider = values.get(Cause(Kind.CORNERS), 0.0)
    if longer:
        arm = replace(arm, acceleration_time=max(arm.acceleration_time + longer, SHORTEST_S))
    if wider:
        width = (arm.blend_time or 2.0 * arm.acceleration_time) + wider
        arm = replace(arm, blend_time=max(width, arm.acceleration_time))
    return with_links(arm, values, Kind.COUNTED_LINK)


def with_links(arm: Arm, values: Mapping[Cause, float], kind: Kind) -> Arm:
    """Return an arm with other links, of those that are of one kind."""
    if not isinstance(arm, SphericalWristArm):
        return arm
    changed = {link: values.get(Cause(kind, 0, link), 0.0) for link in LINKS}
    if not any(changed.values()):
        return arm
    if kind is Kind.LINK and arm.built is not None:  # it stands so, whatever is counted
        off = arm.built.off
        a, b, c, d = (one + by for one, by in zip(off.links, changed.values(), strict=True))
        return as_built(arm, off._replace(links=(a, b, c, d)))
    return replace(arm, **{link: getattr(arm, link) + by for link, by in changed.items()})
