"""A scene as it may really be: objects and the arm's base a little beside, joints slower or faster.

Everything is moved level, never up or down: an object pressed into its support by more than 1 mm,
or let go 2 mm above it, fails in every program. Heights have to be right, and the sheet says so.
"""

import math
from collections.abc import Collection
from dataclasses import replace
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, add, distance, dot, scale, subtract
from vrts.check.task.task import Task
from vrts.engine.memory.events import Grasped
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.robots.built import as_built
from vrts.robots.model import Configuration, Off
from vrts.scene.model import Body, Mobility, Region, Scenario, Scene

FLOOR = "floor"
UPRIGHT = 0.1  # level part of the direction of closing: below, the fingers close up and down
DIRECTIONS = {"+X": (1.0, 0.0), "-X": (-1.0, 0.0), "+Y": (0.0, 1.0), "-Y": (0.0, -1.0)}


class World(NamedTuple):
    """What a program is executed in."""

    scene: Scene
    task: Task | None
    scenario: Scenario


class Touched(NamedTuple):
    """Bodies of which the exact place matters, by name."""

    carried: tuple[str, ...]  # by the hand
    supports: tuple[str, ...]  # on which something is set down


def touched(run: Run) -> Touched:
    """Return what a run carries and where it sets it down."""
    carried = [n for n, track in run.placements.items() if any(p.lie is Lie.HELD for p in track)]
    down = {p.support for n in carried for p in run.placements[n][1:] if p.support is not None}
    supports = [body.name for body in run.scene.bodies if body.name in down - {FLOOR}]
    return Touched(tuple(carried), tuple(supports))


def objects_moved(world: World, names: Collection[str], offset: Vector) -> World:
    """Return a world in which objects, with all that stands on them, are moved [m]."""
    moving = set(names)
    while more := {
        b.name for b in world.scene.bodies if b.rests_on in moving and b.name not in moving
    }:
        moving |= more
    bodies = tuple(_moved(b, offset) if b.name in moving else b for b in world.scene.bodies)
    return world._replace(scene=replace(world.scene, bodies=bodies))


def displaced(scene: Scene, run: Run) -> float:
    """Return how far what a run grasps stands from where it stood there, at most [m]."""
    return max(
        (distance(_off(scene, run, name), (0.0, 0.0, 0.0)) for name in _axes(run)), default=0.0
    )


def pushed_to_the_middle(world: World, run: Run) -> World:
    """Return a world in which what is grasped is off only across the direction of closing.

    Args:
        world: In which objects are off as they may be.
        run: In the scene as it is: tells where the hand closes on what, and from which side.
    """
    for name, axis in _axes(run).items():
        off = _off(world.scene, run, name)
        world = objects_moved(world, (name,), scale(axis, -dot(off, axis)))
    return world


def _off(scene: Scene, run: Run, name: str) -> Vector:
    return subtract(scene.body(name).X_WO.translation, run.scene.body(name).X_WO.translation)


def _axes(run: Run) -> dict[str, Vector]:
    """Return from where to where the fingers close on every object first, level, length 1."""
    found: dict[str, Vector] = {}
    for event in run.events:
        if isinstance(event, Grasped) and event.body not in found:
            X_WP = run.at(event.time_s).X_WF @ run.scene.robot.gripper.X_FP
            x, y, _ = X_WP.orientation
            length = math.hypot(x, y)
            if length > UPRIGHT:
                found[event.body] = (x / length, y / length, 0.0)
    return found


def base_moved(world: World, offset: Vector) -> World:
    """Return a world in which the arm's base is moved [m]: all else is moved the other way."""
    x, y, z = offset
    back = (-x, -y, -z)
    scene = replace(world.scene, bodies=tuple(_moved(body, back) for body in world.scene.bodies))
    return World(scene, _task_moved(world.task, back), _scenario_moved(world.scenario, back))


def with_speeds(
    world: World, *, joints: float = 1.0, lines: float = 1.0, acceleration: float = 1.0
) -> World:
    """Return a world in which joints, straight lines and accelerations take other times.

    Args:
        world: As it is.
        joints: Factor of the largest joint speeds.
        lines: Factor of the speed of straight lines.
        acceleration: Factor of the time in which a motion comes to its speed.
    """
    arm = world.scene.robot.arm
    a, b, c, d, e, f = (speed * joints for speed in arm.speed)
    speeds: Configuration = (a, b, c, d, e, f)
    other = replace(
        arm,
        speed=speeds,
        linear_speed=arm.linear_speed * lines,
        angular_speed=arm.angular_speed * lines,
        acceleration_time=arm.acceleration_time * acceleration,
    )
    robot = replace(world.scene.robot, arm=other)
    return world._replace(scene=replace(world.scene, robot=robot))


def standing(world: World, off: Off) -> World:
    """Return a world in which the arm stands otherwise than it was found to."""
    robot = world.scene.robot
    robot = replace(robot, arm=as_built(robot.arm, off))
    return world._replace(scene=replace(world.scene, robot=robot))


def with_joint_speeds(world: World, shares: Configuration) -> World:
    """Return a world in which each joint has its own share of its largest speed."""
    robot = world.scene.robot
    a, b, c, d, e, f = (one * share for one, share in zip(robot.arm.speed, shares, strict=True))
    robot = replace(robot, arm=replace(robot.arm, speed=(a, b, c, d, e, f)))
    return world._replace(scene=replace(world.scene, robot=robot))


def with_corners(world: World, factor: float) -> World:
    """Return a world in which corners between motions are rounded so many times as wide."""
    scene = world.scene
    arm, model = scene.robot.arm, scene.controller
    corners, blend = model.corners, arm.blend_time
    wider = corners._replace(
        half_accelerations=corners.half_accelerations * factor,
        whole_s=None if corners.whole_s is None else corners.whole_s * factor,
    )
    arm = replace(arm, blend_time=None if blend is None else blend * factor)
    robot = replace(scene.robot, arm=arm)
    controller = replace(model, corners=wider)
    return world._replace(scene=replace(scene, robot=robot, controller=controller))


def with_time(world: World, factor: float) -> World:
    """Return a world in which a program may take longer: marks are not what is looked at."""
    limits = world.scenario.limits
    scenario = replace(world.scenario, limits=replace(limits, time_s=limits.time_s * factor))
    task = world.task and replace(world.task, t_max=world.task.t_max * factor)
    return World(world.scene, task, scenario)


def without_parts(world: World) -> World:
    """Return a world without anything that can be carried, and without a task."""
    bodies = tuple(b for b in world.scene.bodies if b.mobility is Mobility.FIXED)
    return World(replace(world.scene, bodies=bodies), None, world.scenario)


def _moved(body: Body, offset: Vector) -> Body:
    X_WO = Pose(body.X_WO.rotation, add(body.X_WO.translation, offset))
    return replace(body, X_WO=X_WO)


def _task_moved(task: Task | None, offset: Vector) -> Task | None:
    if task is None:
        return None
    goals = tuple(
        goal._replace(
            X_WG=_shifted(goal.X_WG, offset),
            others=tuple(c._replace(X_WG=_shifted(c.X_WG, offset)) for c in goal.others),
        )
        for goal in task.goals
    )
    relations = tuple(
        r._replace(lower=add(r.lower, offset), upper=add(r.upper, offset)) for r in task.relations
    )
    vias = tuple(via._replace(point=add(via.point, offset)) for via in task.vias)
    demands = tuple(
        d._replace(lower=add(d.lower, offset), upper=add(d.upper, offset)) for d in task.demands
    )
    return replace(task, goals=goals, relations=relations, vias=vias, demands=demands)


def _shifted(X: Pose, offset: Vector) -> Pose:
    return Pose(X.rotation, add(X.translation, offset))


def _scenario_moved(scenario: Scenario, offset: Vector) -> Scenario:
    sensors = tuple(
        sensor._replace(
            region=Region(add(sensor.region.lower, offset), add(sensor.region.upper, offset))
        )
        for sensor in scenario.sensors
    )
    return replace(scenario, sensors=sensors)
