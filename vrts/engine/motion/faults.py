"""Why a location cannot be reached, in words."""

from vrts.base.source import Span
from vrts.base.units import deg, mm
from vrts.engine.faults import RuntimeFault
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
