"""Reads `[start]` of a scenario: how the arm and the hand stand when a run begins."""

from typing import NamedTuple, cast

from vrts.base.diagnostic import Label, Rule
from vrts.base.source import Span
from vrts.base.toml.reading import Table
from vrts.base.units import DEG, MM, deg, mm
from vrts.robots.model import Configuration
from vrts.scene.clearance import overlap_is_within, placed_body, placed_robot
from vrts.scene.model import Scene
from vrts.scene.reach import Reach, reach
from vrts.scene.standing import DEEPEST

OUTSIDE_LIMITS = Rule("V470", "start-outside-limits")
GIVEN_TWICE = Rule("V471", "given-twice")
UNREACHABLE = Rule("V472", "start-unreachable")
IN_CONTACT = Rule("V473", "start-in-contact")

LARGEST_ANGLE = 3600.0  # [deg] what a joint may be said to stand at
ROUNDING = 1e-9  # [rad] a limit written in degrees is within the limits
OPEN, CLOSED = "open", "closed"


class Start(NamedTuple):
    """How a run begins."""

    configuration: Configuration | None  # [rad]; None: the arm's ready configuration
    hand_opening: float  # [m]


def read_start(section: Table | None, scene: Scene) -> Start:
    """Return the start that a scenario asks for: without `[start]` ready, the hand closed."""
    if section is None:
        return Start(None, scene.robot.gripper.opening_min)
    errors_before = len(section.problems.found)
    joints = _joints(section, scene)
    at_location = _at_location(section, scene)
    opening = _opening(section, scene)
    _not_twice(section, "joints_deg", "location")
    _not_twice(section, "hand_mm", "hand")
    section.finish()
    found = Start(joints if joints is not None else at_location, opening)
    if len(section.problems.found) == errors_before:
        _check_contact(section, scene, found)
    return found


def _joints(section: Table, scene: Scene) -> Configuration | None:
    degrees = section.numbers("joints_deg", count=6, minimum=-LARGEST_ANGLE, maximum=LARGEST_ANGLE)
    if degrees is None:
        return None
    q = cast("Configuration", tuple(angle * DEG for angle in degrees))
    arm = scene.robot.arm
    for joint, (value, lower, upper) in enumerate(zip(q, arm.lower, arm.upper, strict=True), 1):
        if lower - ROUNDING <= value <= upper + ROUNDING:
            continue
        section.problems.error(
            OUTSIDE_LIMITS,
            f"joint {joint} cannot start at {deg(value):g} degrees",
            section.element_span("joints_deg", joint - 1),
            f"its limits are {deg(lower):g} and {deg(upper):g} degrees",
            data={"joint": joint, "value_rad": value, "lower_rad": lower, "upper_rad": upper},
        )
    return q


def _at_location(section: Table, scene: Scene) -> Configuration | None:
    name = section.string("location", choices=tuple(scene.locations))
    if name is None:
        return None
    found = reach(scene, scene.locations[name])
    if found.best is not None:
        return found.best.configuration
    section.problems.error(
        UNREACHABLE,
        f"the robot cannot start at `{name}`",
        section.value_span("location"),
        _why(found),
        data={"location": name},
    )
    return None


def _why(found: Reach) -> str:
    """Return in words why a location is on no arm branch within the limits."""
    if found.error is not None:
        kind, excess = found.error
        return f"it is {kind}, by {mm(excess):.0f} mm"
    if not found.branches:
        return "no arm branch leads there"
    margin = found.branches[0].margin
    return f"joint {margin.joint} would be {deg(-margin.amount):.1f} degrees beyond its limit"


def _opening(section: Table, scene: Scene) -> float:
    gripper = scene.robot.gripper
    opening_mm = section.number(
        "hand_mm", minimum=mm(gripper.opening_min), maximum=mm(gripper.opening_max)
    )
    word = section.string("hand", CLOSED, choices=(OPEN, CLOSED))
    if opening_mm is not None:
        return opening_mm * MM
    return gripper.opening_max if word == OPEN else gripper.opening_min


def _not_twice(section: Table, first: str, second: str) -> None:
    if first in section and second in section:
        section.problems.error(
            GIVEN_TWICE,
            f"`{first}` and `{second}` say the same thing twice",
            section.span_of(second),
            secondary=(Label(section.span_of(first), "the first time"),),
            help=("leave out one of the two",),
        )


def _check_contact(section: Table, scene: Scene, start: Start) -> None:
    """Report what is in the robot as it starts. The floor may touch its base."""
    q = start.configuration or scene.robot.arm.ready
    parts = placed_robot(scene.robot, q, start.hand_opening)
    base = scene.robot.arm.links[0].name
    inside = [
        (part.name, body.name)
        for body in scene.bodies
        for part in parts
        if not (body.kind == "floor" and part.name == base)
        and not overlap_is_within(part, placed_body(body), DEEPEST)
    ]
    if not inside:
        return
    (part, name), *_ = inside
    others = tuple(dict.fromkeys(f"`{body}`" for _, body in inside if body != name))
    section.problems.error(
        IN_CONTACT,
        f"the robot is inside `{name}` at the start",
        _where(section),
        f"the {part} of the robot overlaps `{name}`",
        notes=(f"it is inside {', '.join(others)} too",) if others else (),
        help=("let it start elsewhere, or with another opening of the hand",),
        data={"bodies": (part, name)},
    )


def _where(section: Table) -> Span:
    """Return the place that says most about the start."""
    keys = ("joints_deg", "location", "hand_mm", "hand")
    return next((section.value_span(key) for key in keys if key in section), section.span)
