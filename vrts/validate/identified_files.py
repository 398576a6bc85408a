"""What was found wrong with a robot, as a lab that can be laid over any scene."""

import json
from collections.abc import Callable, Mapping, Sequence

from vrts.base.units import DEG, MM
from vrts.report.plain import one_line
from vrts.robots.built import AXES, LINKS
from vrts.validate.identify.again import controller_arm
from vrts.validate.identify.causes import BY_TICKS, Cause, Kind
from vrts.validate.identify.identified import Identified, Number
from vrts.validate.identify.words import clause_of
from vrts.validate.reports.identified_text import sentence

BUILT: Mapping[Kind, tuple[str, float]] = {  # key of a lab, and the unit in it
    Kind.ZERO: ("stands_off_deg", DEG),
    Kind.HIDDEN_ZERO: ("zero_deg", DEG),
    Kind.LINK: ("link_mm", MM),
    Kind.COUNTED_LINK: ("counted_link_mm", MM),
    Kind.TOOL: ("tool_mm", MM),
    Kind.BASE: ("base_mm", MM),
    Kind.TURN: ("base_turn_deg", DEG),
}
COUNTS = {Kind.LINK: len(LINKS), Kind.COUNTED_LINK: len(LINKS)} | dict.fromkeys(
    (Kind.TOOL, Kind.BASE, Kind.TURN), len(AXES)
)
JOINTS = 6
LEAST = {DEG: 1e-4, MM: 1e-3}  # no half interval is written shorter, in the unit of the lab


def identified_lab(found: Identified) -> str:
    """Return a lab with the robot as it was found, and how surely.

    Speeds and times are what the controller counts; joints, links, tool and base how the arm
    stands. The clock and the lag of servos change nothing of where an arm goes: comments.
    """
    numbers = {n.cause: n for n in found.numbers}
    values = {cause: n.value for cause, n in numbers.items() if cause.kind in BY_TICKS}
    arm = controller_arm(found.arm, values)
    rows = ["# The robot as found by `vrts validate --identify`, to be laid over a scene: `--lab`."]
    rows.append(f"# {sentence(found)}")
    rows.append(f"# from `{one_line(found.log).replace('`', chr(39))}`, sha256 {found.sha256}")
    if found.synthetic:
        rows.append("# SYNTHETIC: a log was made by a computer; this describes no real robot.")
    if not found.fits:
        rows.append("# DOES NOT FIT: something else is wrong, too; do not trust the intervals.")
    rows += [
        f"# not in this lab, for the arm goes the same way: {clause_of(number)}"
        for number in found.numbers
        if number.cause.kind in (Kind.LAG, Kind.RATE)
    ]
    rows += ["", "[lab]", f"title = {json.dumps(f'the {found.arm.name} as identified')}", ""]
    rows.append("[lab.robot]")
    rows.append(f"speed_deg_s = [{', '.join(f'{speed / DEG:.4f}' for speed in arm.speed)}]")
    rows.append(f"linear_mm_s = {arm.linear_speed / MM:.3f}")
    rows.append(f"angular_deg_s = {arm.angular_speed / DEG:.4f}")
    rows.append(f"acceleration_s = {arm.acceleration_time:.4f}")
    if arm.blend_time is not None:
        rows.append(f"blend_s = {arm.blend_time:.4f}")
    geometry = [n for n in found.numbers if n.cause.kind in BUILT]
    paces = _pace_rows(numbers)
    if geometry or paces:
        rows += ["", "[lab.robot.built]  # how the arm stands, beside what its controller counts"]
        rows += _geometry_rows(geometry, _value)
        rows += ["", "[lab.robot.built.within]  # half of each interval of 95 %"]
        rows += _geometry_rows(geometry, _half)
        rows += paces
    return "\n".join(rows) + "\n"


def _geometry_rows(numbers: Sequence[Number], of: Callable[[Number], float]) -> list[str]:
    """Return one row for each kind, with a number for each joint, link or axis."""
    rows: list[str] = []
    for kind, (key, unit) in BUILT.items():
        held = {_place(n.cause): of(n) / unit for n in numbers if n.cause.kind is kind}
        if held:
            each = (held.get(place, 0.0) + 0.0 for place in range(COUNTS.get(kind, JOINTS)))
            rows.append(f"{key} = [{', '.join(f'{one:.5f}' for one in each)}]")
    return rows


def _place(cause: Cause) -> int:
    return LINKS.index(cause.link) if cause.link else cause.place


def _value(number: Number) -> float:
    return number.value


def _half(number: Number) -> float:
    """Return half an interval about the value that is written, so that the whole lies in it."""
    unit = BUILT[number.cause.kind][1]
    return max(number.high - number.value, number.value - number.low, LEAST[unit] * unit)


def _pace_rows(numbers: Mapping[Cause, Number]) -> list[str]:
    """Return how far speeds and times may be from what was found."""

    def half(kind: Kind, place: int = 0) -> float:
        number = numbers.get(Cause(kind, place))
        if number is None:
            return 0.0
        return max(number.high - number.value, number.value - number.low)

    both = half(Kind.SPEEDS)
    speeds = [100.0 * (both + half(Kind.SPEED, joint)) for joint in range(JOINTS)]
    rows: list[str] = []
    if any(speeds):
        rows.append(f"speed_percent = [{', '.join(f'{one:.4f}' for one in speeds)}]")
    if lines := 100.0 * (both + half(Kind.LINE_SPEED)):
        rows.append(f"linear_percent = {lines:.4f}")
    if acceleration := half(Kind.ACCELERATION):
        rows.append(f"acceleration_s = {acceleration:.4f}")
    if blend := half(Kind.CORNERS):
        rows.append(f"blend_s = {blend:.4f}")
    return rows
