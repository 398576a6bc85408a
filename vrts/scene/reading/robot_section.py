"""The section `[robot]` of a scene: a robot by name, or one described by a URDF file beside it."""

import posixpath
import re
from dataclasses import replace
from typing import NamedTuple, cast

from vrts.base.diagnostic import Label, Rule
from vrts.base.oat import pose_from_components
from vrts.base.pose import IDENTITY, Z_AXIS, Pose, rotation_about
from vrts.base.toml.reading import Table
from vrts.base.units import DEG, MM, deg
from vrts.robots.catalog import WheelMissing, names, robot
from vrts.robots.model import Arm, Configuration, Gripper, Robot
from vrts.robots.urdf.description import UrdfFault
from vrts.robots.urdf.reader import read_urdf
from vrts.robots.urdf.serial_robot import Manner, serial_robot
from vrts.scene.reading.built_section import SECTION as BUILT
from vrts.scene.reading.built_section import read_built
from vrts.scene.reading.files import FileFault, SceneFolder

ROBOT_FILE = Rule("V421", "robot-file")
ROBOT_DESCRIPTION = Rule("V422", "robot-description")
ROBOT_NOT_INSTALLED = Rule("V423", "robot-not-installed")
TWO_ROBOTS = Rule("V424", "two-robots")
JOINT_LIMITS = Rule("V643", "joint-limits")
BLEND_TIME = Rule("V898", "blend-time")

USUAL = "puma761"
FARTHEST = 10_000.0  # [mm]
SLOWEST_S = 10.0  # that an acceleration or a corner may take
MOST_URDF = 1_000_000  # bytes
MOST_MESH = 20_000_000  # bytes
MOST_MESHES = 60_000_000  # bytes of all together

_PACKAGE = re.compile(r"package://[^/]*/")


class Installed(NamedTuple):
    """A robot where it stands."""

    robot: Robot
    X_FT: Pose  # TOOL with which programs start
    X_WS: Pose  # the frame in which the file gives places


def read_robot(section: Table | None, gripper: Gripper, folder: SceneFolder) -> Installed:
    """Return the robot of a scene with its hand, TOOL and place.

    What is wrong is reported; the usual robot then stands in for the rest of the reading.
    """
    if section is None:
        return Installed(replace(robot(USUAL), gripper=gripper), gripper.X_FP, IDENTITY)
    chosen = _described(section, folder) if "urdf" in section else _named(section)
    tool = section.numbers("tool_xyzoat", count=6, minimum=-FARTHEST, maximum=FARTHEST)
    at = section.numbers("at_mm", (0.0, 0.0), count=2, minimum=-FARTHEST, maximum=FARTHEST)
    turn = section.number("turn_deg", 0.0, minimum=-360.0, maximum=360.0) * DEG
    chosen = replace(chosen or robot(USUAL), gripper=gripper)
    chosen = replace(chosen, arm=_measured(section, chosen.arm))
    X_FT = gripper.X_FP if tool is None else _pose(tool)
    chosen = replace(chosen, arm=read_built(section.table(BUILT), chosen.arm, X_FT))
    section.finish()
    x, y = at or (0.0, 0.0)
    X_SW = Pose(rotation_about(Z_AXIS, turn), (x * MM, y * MM, 0.0))
    return Installed(chosen, X_FT, IDENTITY if X_SW == IDENTITY else X_SW.inverse())


def _measured(section: Table, arm: Arm) -> Arm:
    """Return an arm with the limits of a section in place of its own."""
    before = len(section.problems.found)
    lower = section.numbers("lower_deg", count=6, minimum=-3600.0, maximum=3600.0)
    upper = section.numbers("upper_deg", count=6, minimum=-3600.0, maximum=3600.0)
    speed = section.numbers("speed_deg_s", count=6, above=0.0, maximum=3600.0)
    linear = section.number("linear_mm_s", above=0.0, maximum=FARTHEST)
    angular = section.number("angular_deg_s", above=0.0, maximum=3600.0)
    acceleration = section.number("acceleration_s", above=0.0, maximum=SLOWEST_S)
    blend = section.number("blend_s", above=0.0, maximum=SLOWEST_S)
    arm = replace(
        arm,
        lower=arm.lower if lower is None else _angles(lower),
        upper=arm.upper if upper is None else _angles(upper),
        speed=arm.speed if speed is None else _angles(speed),
        linear_speed=arm.linear_speed if linear is None else linear * MM,
        angular_speed=arm.angular_speed if angular is None else angular * DEG,
        acceleration_time=arm.acceleration_time if acceleration is None else acceleration,
        blend_time=arm.blend_time if blend is None else blend,
    )
    if len(section.problems.found) == before:
        _check_limits(section, arm)
        _check_blend(section, arm)
    return arm


def _check_blend(section: Table, arm: Arm) -> None:
    """Report corners so short that the first motion would have begun to stop."""
    if arm.blend_time is None or arm.blend_time >= arm.acceleration_time:
        return
    key = "blend_s" if "blend_s" in section else "acceleration_s"
    section.problems.error(
        BLEND_TIME,
        "corners are shorter than the arm takes to stop",
        section.value_span(key),
        f"a corner takes {arm.blend_time:g} s, stopping {arm.acceleration_time:g} s",
        help=("give a `blend_s` that is at least `acceleration_s`",),
        data={"blend_s": arm.blend_time, "acceleration_s": arm.acceleration_time},
    )


def _check_limits(section: Table, arm: Arm) -> None:
    """Report the first joint whose limits leave out where it is when the arm stands ready."""
    limits = zip(arm.lower, arm.ready, arm.upper, strict=True)
    for joint, (lower, ready, upper) in enumerate(limits, 1):
        if lower <= ready <= upper:
            continue
        key = "lower_deg" if lower > ready and "lower_deg" in section else "upper_deg"
        section.problems.error(
            JOINT_LIMITS,
            f"the ready position is outside the limits of joint {joint}",
            section.element_span(key, joint - 1) if key in section else section.span,
            f"joint {joint} is at {deg(ready):g} deg there; its limits are {deg(lower):g} and"
            f" {deg(upper):g} deg",
            data={"joint": joint},
        )
        return


def _angles(values: tuple[float, ...]) -> Configuration:
    return cast(Configuration, tuple(value * DEG for value in values))


def _named(section: Table) -> Robot | None:
    name = section.string("name", USUAL, choices=names())
    try:
        return robot(name)
    except WheelMissing as missing:
        section.problems.error(
            ROBOT_NOT_INSTALLED,
            f"robot `{name}` is not installed",
            section.value_span("name"),
            str(missing),
            help=("pip install example-robot-data",),
            data={"robot": name},
        )
        return None


def _described(section: Table, folder: SceneFolder) -> Robot | None:
    if "name" in section:
        section.problems.error(
            TWO_ROBOTS,
            "two robots are given",
            section.span_of("name"),
            "by name",
            secondary=(Label(section.span_of("urdf"), "by a description"),),
            help=("leave out one of the two; `title` says what a described robot is called",),
        )
    section.string("name")
    before = len(section.problems.found)
    file = section.string("urdf", required=True)
    flange = section.string("flange")
    title = section.string("title")
    ready = section.numbers("ready_deg", count=6, minimum=-3600, maximum=3600, required=True)
    height = section.number("base_height_mm", 0.0, minimum=0.0, maximum=FARTHEST)
    linear = section.number("linear_mm_s", 500.0, above=0.0, maximum=FARTHEST)  # [assumed]
    angular = section.number("angular_deg_s", 90.0, above=0.0, maximum=3600.0)  # [assumed]
    if file is None or ready is None or len(section.problems.found) > before:
        return None
    try:
        description = read_urdf(folder.read(file, MOST_URDF), flange)
        manner = Manner(
            description.name,
            title or description.name,
            _angles(ready),
            height * MM,
            linear * MM,
            angular * DEG,
        )
        return serial_robot(description, manner, _Meshes(file, folder).read)
    except FileFault as fault:
        section.problems.error(
            ROBOT_FILE,
            f"cannot read the robot `{file}`",
            section.value_span("urdf"),
            str(fault),
            help=("put the file beside the scene, and write its name",),
            data={"file": file},
        )
    except UrdfFault as fault:
        where = f"{file}, line {fault.line}" if fault.line else file
        section.problems.error(
            ROBOT_DESCRIPTION,
            f"`{file}` does not describe an arm with six turning joints that can be simulated",
            section.value_span("urdf"),
            fault.message,
            notes=(f"in {where}",),
            data={"file": file, "line": fault.line or 0},
        )
    return None


class _Meshes:
    """Meshes beside a description."""

    def __init__(self, file: str, folder: SceneFolder) -> None:
        self.beside = posixpath.dirname(file)
        self.folder = folder
        self.bytes = 0

    def read(self, name: str) -> bytes:
        """Return a mesh by the name that the description gives it; `package://x/` is beside it."""
        place = posixpath.join(self.beside, _PACKAGE.sub("", name, count=1))
        try:
            data = self.folder.contents.get(place) or self.folder.read(place, MOST_MESH)
        except FileFault as fault:
            raise FileFault(f"mesh `{name}`: {fault}") from fault
        self.bytes += len(data)
        if self.bytes > MOST_MESHES:
            raise FileFault(f"its meshes have more than {MOST_MESHES:,} bytes")
        return data


def _pose(xyzoat: tuple[float, ...]) -> Pose:
    x, y, z, o, a, t = xyzoat
    return pose_from_components(x, y, z, o, a, t)
