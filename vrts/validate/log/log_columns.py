"""Which column of a log says what, and in which unit, as its names tell."""

import re
from enum import Enum
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, error, warning
from vrts.base.units import DEG, INCH, MM
from vrts.validate.log.log_table import LogTable, Row, line_span

LOG_COLUMNS = Rule("V882", "log-columns")
LOG_JOINTS = Rule("V883", "log-joints")

JOINTS, AXES = 6, 3
OTHER_NAMES = "where the log has other names, `--columns FILE` says which are which"


class Role(Enum):
    """What a column is."""

    TIME = "time"
    JOINT = "joint"
    POSITION = "position"


UNITS: dict[Role, dict[str, float]] = {
    Role.TIME: {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0},
    Role.JOINT: {"deg": DEG, "rad": 1.0},
    Role.POSITION: {"mm": MM, "m": 1.0, "cm": 1e-2, "in": INCH},
}
SPELLINGS = {
    "°": "deg",
    "degree": "deg",
    "degrees": "deg",
    "radian": "rad",
    "radians": "rad",
    "sec": "s",
    "seconds": "s",
    "second": "s",
    "msec": "ms",
    "µs": "us",
    "μs": "us",
    "inch": "in",
    "inches": "in",
    "metre": "m",
    "meter": "m",
    "metres": "m",
    "meters": "m",
}

_UNIT = re.compile(
    r"(?P<name>.*?)[\s_/]*(?:[\[(]\s*(?P<inside>[^\])]*?)\s*[\])]"
    r"|[\s_/](?P<after>deg|degrees?|°|rad|radians?|mm|cm|m|in|s|sec|ms|us|µs|μs|min))"
)
_TIME = re.compile(r"t|time|__time|time[ _]?stamp|clock|zeit|seconds|sec")
_RTDE = re.compile(r"actual_q_([0-5])")  # as clients of Universal Robots' RTDE write it
_TOPIC = re.compile(r"/?(?:.+/)?(?P<joint>[^/]+)/position")  # as PlotJuggler writes a topic of ROS
UNIVERSAL = {  # the joints of Universal Robots as ROS knows them
    "shoulder_pan_joint": 0,
    "shoulder_lift_joint": 1,
    "elbow_joint": 2,
    "wrist_1_joint": 3,
    "wrist_2_joint": 4,
    "wrist_3_joint": 5,
}
_JOINT = re.compile(
    r"(?:jt|j|q|joint|axis|theta|a|gelenk|achse)[\s_.]*([1-6])(?:[\s_](?:pos|position|act|actual))?"
)
_POSITION = re.compile(
    r"(?:(?:tool|tcp|pos|position|p)[\s_.]*)?([xyz])(?:[\s_](?:pos|position|act|actual))?"
)


class Column(NamedTuple):
    """A column that is used."""

    place: int  # from 0
    role: Role
    number: int  # joint 0 to 5, or axis 0 to 2
    unit: str | None  # a key of `UNITS`; None: the name does not say


class Columns(NamedTuple):
    """The columns of a log that are used."""

    time: Column
    joints: tuple[Column, ...]  # six or none, in order
    position: tuple[Column, ...]  # three or none
    findings: tuple[Diagnostic, ...]  # warnings


def find_columns(table: LogTable) -> Columns | Diagnostic:
    """Return the columns with time, joints and tool position, or what is missing."""
    found: dict[tuple[Role, int], Column] = {}
    for place, name in enumerate(table.header.cells):
        column = column_of(place, name)
        if column is None:
            continue
        key = (column.role, column.number)
        if key in found:
            other = table.header.cells[found[key].place]
            return _wrong(
                table,
                f"columns `{other}` and `{name}` say the same",
                remedy="`--columns FILE` says which of them counts",
            )
        found[key] = column
    time = found.get((Role.TIME, 0))
    joints = tuple(found[Role.JOINT, k] for k in range(JOINTS) if (Role.JOINT, k) in found)
    position = tuple(found[Role.POSITION, k] for k in range(AXES) if (Role.POSITION, k) in found)
    if time is None:
        return _wrong(table, "no column holds the time")
    if not joints and not position:
        return _wrong(table, "no column holds a joint or a position of the tool")
    if len(position) < AXES and not joints:
        missing = [a for k, a in enumerate("xyz") if (Role.POSITION, k) not in found]
        return _wrong(table, f"of the tool's position {' and '.join(missing)} is missing")
    told: list[Diagnostic] = []
    if 0 < len(joints) < JOINTS:
        report = _joints_missing(table.header, table, joints, fatal=len(position) < AXES)
        if report.is_error:
            return report
        told.append(report)
        joints = ()
    if len(position) < AXES:
        position = ()
    return Columns(time, joints, position, tuple(told))


def column_of(place: int, name: str) -> Column | None:
    """Return what a column is by its name; None: nothing that is compared."""
    ros = _of_ros(place, name.strip().lower())
    if ros is not None:
        return ros
    bare, unit = _split(name.strip().lower())
    if _TIME.fullmatch(bare) and (unit is None or unit in UNITS[Role.TIME]):
        spelled = "s" if unit is None and bare in ("seconds", "sec") else unit
        return Column(place, Role.TIME, 0, spelled)
    joint = _JOINT.fullmatch(bare)
    if joint is not None and (unit is None or unit in UNITS[Role.JOINT]):
        return Column(place, Role.JOINT, int(joint[1]) - 1, unit)
    position = _POSITION.fullmatch(bare)
    if position is not None and (unit is None or unit in UNITS[Role.POSITION]):
        return Column(place, Role.POSITION, "xyz".index(position[1]), unit)
    return None


def _of_ros(place: int, name: str) -> Column | None:
    """Return a joint as programs write it that always mean rad, or None."""
    rtde = _RTDE.fullmatch(name)
    if rtde is not None:
        return Column(place, Role.JOINT, int(rtde[1]), "rad")
    topic = _TOPIC.fullmatch(name)
    bare = topic["joint"] if topic is not None else _split(name)[0]
    if bare in UNIVERSAL:
        return Column(place, Role.JOINT, UNIVERSAL[bare], _split(name)[1] or "rad")
    joint = _JOINT.fullmatch(bare) if topic is not None else None
    return None if joint is None else Column(place, Role.JOINT, int(joint[1]) - 1, "rad")


def _split(name: str) -> tuple[str, str | None]:
    """Return the name without its unit, and the unit."""
    match = _UNIT.fullmatch(name)
    if match is None:
        return name, None
    unit = match["inside"] if match["inside"] is not None else match["after"]
    return match["name"].strip(), SPELLINGS.get(unit, unit)


def _wrong(table: LogTable, headline: str, remedy: str = OTHER_NAMES) -> Diagnostic:
    return error(
        LOG_COLUMNS,
        headline,
        Label(line_span(table.source, table.header.line), "the names of the columns"),
        notes=(
            "expected `time_s`, and `jt1_deg` to `jt6_deg` or `x_mm`, `y_mm`, `z_mm` or both",
            "units may be deg, rad, mm, m, cm, s and ms, also as `JT1 [rad]`",
        ),
        help=(remedy,),
    )


def _joints_missing(
    header: Row, table: LogTable, joints: tuple[Column, ...], *, fatal: bool
) -> Diagnostic:
    there = {column.number for column in joints}
    missing = ", ".join(str(k + 1) for k in range(JOINTS) if k not in there)
    several = "s" if "," in missing else ""
    make = error if fatal else warning
    return make(
        LOG_JOINTS,
        f"joint{several} {missing} {'are' if several else 'is'} missing in the log",
        Label(line_span(table.source, header.line), f"expected six joints, found {len(joints)}"),
        notes=() if fatal else ("only positions of the tool are compared",),
        help=("log all six joints, also those that stand still",) if fatal else (),
        data={"missing": missing},
    )
