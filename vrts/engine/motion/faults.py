"""Why a motion cannot be made, in words."""

from vrts.base.source import Span
from vrts.base.units import DEG, deg, mm
from vrts.engine.faults import SINGULAR_JUMP, RuntimeFault
from vrts.engine.motion.paths import LinePath
from vrts.engine.motion.set_points import Obstacle
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.model import ArmBranch


def reach_fault(kind: str, excess_m: float, span: Span | None, what: str) -> RuntimeFault:
    """Return the fault of a location that no arm branch reaches."""
    far = kind == "too far"
    return RuntimeFault(
        RuntimeErrorKind.TOO_FAR if far else RuntimeErrorKind.TOO_CLOSE,
        f"{what} is {mm(excess_m):.0f} mm {'beyond reach' if far else 'too close to the robot'}",
        span,
        label=kind,
        help=("`vrts point SCENE X Y Z --down` tells what the arm reaches; lengths are in mm",),
        data={"excess_mm": mm(excess_m)},
    )


def limit_fault(
    violation: tuple[int, float, float, float],
    span: Span | None,
    what: str,
    elsewhere: tuple[ArmBranch, ...] = (),
) -> RuntimeFault:
    """Return the fault of a joint outside its limits."""
    joint, value, lower, upper = violation
    notes = tuple(
        f"the arm branch {' '.join(part.value.upper() for part in branch)} is within the limits"
        for branch in elsewhere[:1]
    )
    return RuntimeFault(
        RuntimeErrorKind.JOINT_OUT_OF_RANGE,
        f"joint {joint} would be at {deg(value):.1f} degrees for {what};"
        f" its limits are {deg(lower):.0f} and {deg(upper):.0f}",
        span,
        joint=joint,
        notes=notes,
        data={"joint": joint, "value_deg": deg(value)},
    )


def obstacle_fault(obstacle: Obstacle, path: LinePath, u: float, span: Span | None) -> RuntimeFault:
    """Return the fault that stops a straight line at a share u of its way."""
    after = f"after {mm(path.length) * u:.0f} of {mm(path.length):.0f} mm"
    joint, value, lower, upper = obstacle.detail
    if obstacle.kind in ("too far", "too close"):
        return reach_fault(obstacle.kind, value, span, f"the straight line, {after},")
    if obstacle.kind == "limit":
        return limit_fault((joint, value, lower, upper), span, f"the straight line {after}")
    return RuntimeFault(
        RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE,
        f"the straight line meets a singularity {after}: joint {joint} would have to turn at"
        f" {value / DEG:.0f} degrees/s; its limit is {upper / DEG:.0f}",
        span,
        rule=SINGULAR_JUMP,
        help=("go round the singularity, or use MOVE instead of MOVES",),
        joint=joint,
        data={"joint": joint, "needed_deg_s": value / DEG},
    )
