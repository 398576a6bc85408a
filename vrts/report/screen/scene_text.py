"""Where things are, for the terminal. Lengths in mm, angles in degrees, as programs write them."""

from collections.abc import Sequence

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.units import deg, mm
from vrts.geometry.support import bounds
from vrts.report.plain import one_line, plain_text
from vrts.robots.kinematics.branch import has_branches
from vrts.robots.model import ArmBranch
from vrts.scene.block import location_block
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reach import BranchReach, Reach

HOW_TO_READ = """\
X points forward, Y to the left, Z up, from the robot's {origin}, {floor:.0f} mm above the floor.
O, A, T turn the hand: A = 90 points it straight down; O then turns it about the vertical."""

HOW_TO_USE = """\
Paste this at the end of a program; MOVE, APPRO and their like then know the names:
"""


def scene_text(scene: Scene, tried: Sequence[str] = ()) -> str:
    """Return every object with position and size, and the locations ready to paste.

    Args:
        scene: The workspace, with the locations to show.
        tried: What came of carrying objects with them, a line each.
    """
    arm = scene.robot.arm
    rows = [("object", "X", "Y", "Z underside", "size X x Y x Z", "stands on", "")]
    rows += [_row(body) for body in scene.bodies if body.name != "floor"]
    widths = [max(len(row[k]) for row in rows) for k in range(6)]
    lines = [
        f"{one_line(scene.title)}  ({scene.name}; {arm.title})",
        "",
        *(_aligned(row, widths) for row in rows),
        "",
        HOW_TO_READ.format(
            origin="shoulder" if has_branches(arm) else "foot", floor=mm(arm.shoulder_height)
        ),
    ]
    if scene.locations:
        lines += ["", HOW_TO_USE + location_block(scene.locations).rstrip("\n")]
    if scene.withheld:
        lines += ["", f"You find and teach yourself: {', '.join(map(one_line, scene.withheld))}"]
    if tried:
        lines += ["", *map(one_line, tried)]
    return plain_text("\n".join(lines))


def point_text(scene: Scene, X_WT: Pose, found: Reach) -> str:
    """Return whether the tool reaches a pose, in which ways, and what is near."""
    x, y, z, o, a, t = components(X_WT)
    lines = [f"X {x:.2f}  Y {y:.2f}  Z {z:.2f}  O {o:.2f}  A {a:.2f}  T {t:.2f}"]
    best = found.best
    if found.error is not None:
        kind, amount = found.error
        words = "beyond reach" if kind == "too far" else "too close to the robot"
        return plain_text("\n".join([*lines, f"not reachable: {mm(amount):.0f} mm {words}"]))
    if best is None:
        nearest = max(found.branches, key=lambda way: way.margin.amount)
        over = deg(-nearest.margin.amount)
        joint = nearest.margin.joint
        lines.append(f"not reachable: joint {joint} would be {over:.1f} degrees past its limit")
    else:
        way = f", {_branch(best.branch)}" if has_branches(scene.robot.arm) else ""
        lines.append(f"reachable{way}; {_margin(best)}")
        joints = "  ".join(f"JT{k} {deg(q):.1f}" for k, q in enumerate(best.configuration, 1))
        lines.append(f"joints: {joints}")
    if found.nearest is not None:
        near = found.nearest
        gap = mm(near.clearance)
        words = f"{gap:.1f} mm from" if gap > 0 else f"{-gap:.1f} mm inside"
        lines.append(f"with the hand open, {near.part} is {words} `{near.body}`")
    if has_branches(scene.robot.arm):
        others = [way for way in found.branches if way is not best]
        lines.append("")
        lines += [f"  {_branch(way.branch):<22} {_margin(way)}" for way in (best, *others) if way]
    return plain_text("\n".join(lines))


def _row(body: Body) -> tuple[str, ...]:
    box = bounds(body.pieces, body.X_WO)
    x, y, _ = body.X_WO.translation
    size = " x ".join(f"{mm(b - a):.0f}" for a, b in zip(box.lower, box.upper, strict=True))
    note = "" if body.mobility is Mobility.FIXED else "can be carried"
    top = f"top at Z {mm(box.upper[2]):.0f}"
    return (
        body.name,
        f"{mm(x):.0f}",
        f"{mm(y):.0f}",
        f"{mm(box.lower[2]):.0f}",
        size,
        body.rests_on or ("floor" if body.name == "table" else "table"),
        ", ".join(part for part in (top, note) if part),
    )


def _aligned(row: tuple[str, ...], widths: list[int]) -> str:
    numbers = "  ".join(row[k].rjust(widths[k]) for k in (1, 2, 3))
    left = "  ".join(row[k].ljust(widths[k]) for k in (4, 5))
    return f"{row[0].ljust(widths[0])}  {numbers}  {left}  {row[6]}".rstrip()


def _branch(branch: ArmBranch) -> str:
    return " ".join(part.value.upper() for part in branch)


def _margin(way: BranchReach) -> str:
    amount, joint = deg(way.margin.amount), way.margin.joint
    if amount < 0:
        return f"joint {joint} {-amount:.1f} degrees past its limit"
    return f"{amount:.1f} degrees to the limit of joint {joint}"
