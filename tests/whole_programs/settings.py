"""Scenes, places that their arms reach, and scenarios, drawn by chance."""

from dataclasses import replace
from functools import cache
from random import Random

from vrts.base.oat import components
from vrts.base.units import deg
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.default import robot_alone
from vrts.scene.model import (
    FaultKind,
    Limits,
    PlannedFault,
    Region,
    Scenario,
    Sensor,
)

SCENES = (
    "puma761",
    "one-can-puma560",
    "cans-on-bases",
    "one-can-ur5",
    "puma560",
    "final-project",
    "one-can-urdf",
)
LIMITS = Limits(statements=3000, time_s=40.0, motions=150, output_characters=20_000, call_depth=30)
FEWER = 300  # statements of an arm whose solutions are searched for: each costs far more there
SERIAL = ("one-can-ur5", "one-can-urdf")
SWING = 0.4  # [rad] of every joint away from the ready configuration
ZYZ = ("as", "vplus")  # dialects with other angles


@cache
def setting(scene: str) -> Setting:
    """Return a scene, or a robot alone."""
    if scene.startswith("puma"):
        return Setting(robot_alone(scene), None, ())
    return load_scene(scene)


@cache
def places(scene: str) -> dict[str, tuple[float, ...]]:
    """Return places that the arm of a scene reaches, by their names, as numbers of a program."""
    robot, X_FT = setting(scene).scene.robot, setting(scene).scene.X_FT
    draw = Random(scene)
    found: dict[str, tuple[float, ...]] = {}
    for k in range(1, 5):
        q = tuple(angle + draw.uniform(-SWING, SWING) for angle in robot.arm.ready)
        found[f"p{k}"] = components(forward(robot.arm, q) @ X_FT)  # type: ignore[arg-type]
        if k < 4:
            found[f"#j{k}"] = tuple(deg(angle) for angle in q)
    found["q[1]"] = found["p1"]
    return found


def section(scene: str, dialect: str) -> str:
    """Return the places as a section of a file."""
    rows: list[str] = []
    for name, numbers in places(scene).items():
        x, y, z, o, a, t = numbers
        turned = dialect in ZYZ and not name.startswith("#")
        values = (x, y, z, o - 90.0, a + 90.0, t) if turned else numbers
        rows.append(" ".join([name, *(f"{value:.3f}" for value in values)]))
    return "\n".join([".LOCATIONS", *rows, ".END", ""])


def drawn_scenario(draw: Random, scene: str) -> Scenario:
    """Return what happens during a run."""
    chosen = setting(scene).scene
    inputs = sorted(
        (round(draw.uniform(0.0, 8.0), 2), draw.randint(1001, 1003), draw.random() < 0.6)
        for _ in range(draw.choice((0, 0, 2, 6)))
    )
    bodies = [body.name for body in chosen.bodies if body.name not in ("floor", "table")]
    tool = Region((0.2, -0.6, -1.0), (0.9, 0.6, 0.6))
    sensors = (Sensor(1003, tool, ("tool",)),) if draw.random() < 0.3 else ()
    if bodies and draw.random() < 0.2:
        sensors = (*sensors, Sensor(1004, tool, (), inverted=True))
    faults = sorted(_faults(draw), key=lambda fault: fault.time_s)
    return Scenario(
        hand_opening=draw.choice((0.0, chosen.robot.gripper.opening_max)),
        seed=draw.randrange(1000),
        inputs=tuple(inputs),
        limits=replace(LIMITS, statements=FEWER) if scene in SERIAL else LIMITS,
        parameters={"HAND.TIME": 0.3} if draw.random() < 0.2 else {},
        sensors=sensors,
        answers=tuple(
            draw.choice(("1", "2.5", "3 4", "bad", "")) for _ in range(draw.choice((0, 3)))
        ),
        faults=tuple(faults),
        monitor_speed=draw.choice((100.0, 100.0, 50.0, 37.5, 12.5)),
    )


def _faults(draw: Random) -> list[PlannedFault]:
    found: list[PlannedFault] = []
    if draw.random() < 0.1:
        found.append(PlannedFault(draw.uniform(0.0, 8.0), FaultKind.EMERGENCY_STOP))
    if draw.random() < 0.1:
        found.append(PlannedFault(draw.uniform(0.0, 8.0), FaultKind.GRIPPER_SLIPS))
    if draw.random() < 0.1:
        on = draw.random() < 0.5
        found.append(PlannedFault(draw.uniform(0.0, 8.0), FaultKind.INPUT_STUCK, 1001, on))
    return found
