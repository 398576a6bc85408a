"""Why a straight line is stopped on its way, in words."""

from vrts.base.diagnostic import Datum
from vrts.base.source import Span
from vrts.base.units import DEG, deg, mm
from vrts.engine.faults import SINGULAR_JUMP, RuntimeFault
from vrts.engine.motion.faults import limit_fault, reach_fault
from vrts.engine.motion.lines.path import LinePath
from vrts.engine.motion.lines.set_points import Obstacle
from vrts.ir.runtime_errors import RuntimeErrorKind

SHORTEST_WAY_MM = 1.0  # a line that is shorter is told by how far it turns


def obstacle_fault(
    obstacle: Obstacle, path: LinePath, shares: tuple[float, float], span: Span | None
) -> RuntimeFault:
    """Return the fault that stops a straight line.

    Args:
        obstacle: Why.
        path: The line.
        shares: At which shares of the way it is met, and is at its worst.
        span: What the program calls the end of the line.
    """
    met, worst = (_after(path, share) for share in shares)
    joint, value = obstacle.joint, obstacle.value
    if obstacle.kind in ("too far", "too close"):
        fault = reach_fault(obstacle.kind, value, span, f"the straight line, {worst},")
        fault.notes = (f"its end is within reach, but {met} it is not",)
        return fault
    if obstacle.kind == "limit":
        what = f"the straight line {worst}"
        fault = limit_fault((joint, value, *obstacle.limits), span, what)
        fault.notes = (f"the joint passes its limit {met}",)
        return fault
    singularity = (
        "a singularity" if obstacle.near == "singular" else f"the {obstacle.near} singularity"
    )
    data: dict[str, Datum] = {}
    if joint:
        limit = obstacle.limits[1]
        turns = f"joint {joint} would have to turn at {value / DEG:.0f} degrees/s"
        turns += f"; its limit is {limit / DEG:.0f}"
        data = {"joint": joint, "needed_deg_s": value / DEG}
    else:
        turns = "the arm cannot go on from there as it stands"
    return RuntimeFault(
        RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE,
        f"the straight line meets {singularity} {met}: {turns}",
        span,
        rule=SINGULAR_JUMP,
        help=("go round the singularity, or use MOVE instead of MOVES",),
        joint=joint,
        data=data,
    )


def advise(fault: RuntimeFault, percent: int | None) -> None:
    """Say with which SPEED a line gets past the singularity that stops it, if one is known."""
    if percent is not None:
        fault.help = (f"SPEED {percent} would do; or {fault.help[0]}",)
        fault.data = {**fault.data, "speed_percent": percent}


def _after(path: LinePath, share: float) -> str:
    """Return a place on a line in words."""
    if mm(path.length) >= SHORTEST_WAY_MM:
        return f"after {mm(path.length) * share:.0f} of {mm(path.length):.0f} mm"
    return f"after {deg(path.turned) * share:.0f} of {deg(path.turned):.0f} degrees"
