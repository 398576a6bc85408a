"""In which other worlds a program is tried: one family of worlds for each margin."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from vrts.base.units import MM, mm
from vrts.dispatch.planning.beside.worlds import (
    DIRECTIONS,
    World,
    base_moved,
    objects_moved,
    standing,
    touched,
    with_corners,
    with_joint_speeds,
    with_speeds,
    with_time,
)
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.robots.built import at_the_ends

OBJECTS = 3.0 * MM  # an object may stand so far from its place
BASE = 2.0 * MM  # the arm's base may
JOINTS = (0.8, 1.25)  # bounds of the assumed joint speeds, as factors [assumed]
LINES = (0.5, 1.0)  # the same of straight lines: 0.5 m/s is what is told of the 560 [assumed]
ACCELERATION = (0.75, 1.25)  # the same of the time of an acceleration [assumed]
FIRST_SPEED = 10.0  # [%] the operator's speed of the first run
SLOWER = 4.0  # a run may take this many times as long when something is slower
LEAST_SHARE = 0.1  # of a time, however wide its interval is
NO_ROOM = 1e6  # a corner so many times as wide fits between no two motions: each one stops
CORNERS = {
    "no corner rounded": NO_ROOM,
    "corners rounded half as wide": 0.5,
    "corners rounded twice as wide": 2.0,
}  # nobody has published how wide they are


class Subject(NamedTuple):
    """A program in the world as the scene has it, and the run there, which is proven."""

    module: Module
    entry: str
    world: World
    run: Run
    clearance_m: float | None  # certified; None: nothing is ever near anything


class Trial(NamedTuple):
    """Another world, and what it is."""

    what: str  # "`can1` 3 mm along +Y"
    world: World


def each_object(subject: Subject) -> Iterator[Trial]:
    """Each object alone, and what something is set down on."""
    known = touched(subject.run)
    for name in (*known.carried, *known.supports):
        for direction, (x, y) in DIRECTIONS.items():
            moved = objects_moved(subject.world, (name,), (OBJECTS * x, OBJECTS * y, 0.0))
            yield Trial(f"`{name}` {mm(OBJECTS):g} mm along {direction}", moved)


def all_objects(subject: Subject, factor: float) -> Iterator[Trial]:
    """All that is carried, the same way."""
    carried, far = touched(subject.run).carried, OBJECTS * factor
    if not carried:
        return
    for direction, (x, y) in DIRECTIONS.items():
        moved = objects_moved(subject.world, carried, (far * x, far * y, 0.0))
        yield Trial(f"all that is carried {mm(far):g} mm along {direction}", moved)


def base(subject: Subject, factor: float) -> Iterator[Trial]:
    """The base of the arm."""
    far = BASE * factor
    for direction, (x, y) in DIRECTIONS.items():
        moved = base_moved(subject.world, (far * x, far * y, 0.0))
        yield Trial(f"the base {mm(far):g} mm along {direction}", moved)


def together(subject: Subject, factor: float) -> Iterator[Trial]:
    """Objects one way and the base the other: what the hand takes is off by both."""
    carried = touched(subject.run).carried
    off, far = OBJECTS * factor, BASE * factor
    if not carried:
        return
    for direction, (x, y) in DIRECTIONS.items():
        away = base_moved(subject.world, (-far * x, -far * y, 0.0))
        moved = objects_moved(away, carried, (off * x, off * y, 0.0))
        what = f"objects {mm(off):g} mm along {direction} and the base {mm(far):g} mm against it"
        yield Trial(what, moved)


def speeds(subject: Subject, factor: float) -> Iterator[Trial]:
    """Joints, straight lines and accelerations at the bounds of what is assumed of them."""
    world = with_time(subject.world, SLOWER * factor)
    for joints in JOINTS:
        share = joints**factor
        yield Trial(f"joints at {share:.0%} of their speed", with_speeds(world, joints=share))
    lines = LINES[0] ** factor
    yield Trial(f"straight lines at {lines:.0%} of their speed", with_speeds(world, lines=lines))
    for acceleration in ACCELERATION:
        share = acceleration**factor
        other = with_speeds(world, acceleration=share)
        yield Trial(f"{share:.0%} of the time of an acceleration", other)


def found_robot(subject: Subject) -> Iterator[Trial]:
    """Every number of a robot that was found, alone, at both ends of its interval."""
    arm = subject.world.scene.robot.arm
    if arm.built is None:
        return
    for one in at_the_ends(arm.built):
        yield Trial(one.what, standing(subject.world, one.off))
    world, within = with_time(subject.world, SLOWER), arm.built.within
    for sign, end in ((-1.0, "lower"), (1.0, "upper")):
        ends = f"at the {end} end of {{}} interval"
        if any(within.speeds):
            a, b, c, d, e, f = (1.0 + sign * one for one in within.speeds)
            other = with_joint_speeds(world, (a, b, c, d, e, f))
            yield Trial(f"speeds of joints {ends.format('their')}", other)
        if within.lines:
            other = with_speeds(world, lines=1.0 + sign * within.lines)
            yield Trial(f"speed of straight lines {ends.format('its')}", other)
        if within.acceleration_s:
            share = max(1.0 + sign * within.acceleration_s / arm.acceleration_time, LEAST_SHARE)
            other = with_speeds(world, acceleration=share)
            yield Trial(f"time of an acceleration {ends.format('its')}", other)
        if within.blend_s:
            blend = arm.blend_time or 2.0 * arm.acceleration_time
            other = with_corners(world, max(1.0 + sign * within.blend_s / blend, LEAST_SHARE))
            yield Trial(f"time of a rounded corner {ends.format('its')}", other)


def first_run(subject: Subject) -> Iterator[Trial]:
    """At the operator's first speed."""
    world = with_time(subject.world, 100.0 / FIRST_SPEED)
    speed = FIRST_SPEED * world.scenario.monitor_speed / 100.0
    slow = world._replace(scenario=replace(world.scenario, monitor_speed=speed))
    yield Trial(f"SPEED {FIRST_SPEED:g}", slow)


def corners(subject: Subject) -> Iterator[Trial]:
    """Corners between motions: none, narrower, wider."""
    world = with_time(subject.world, SLOWER)
    for what, factor in CORNERS.items():
        yield Trial(what, with_corners(world, factor))
