"""The locations a student needs, worked out from where things stand.

Every movable object gets `NAME_grip`, every base `NAME_put`, and there is `safe`: all with the hand
straight down, reachable LEFTY ABOVE with a margin to the joint limits, fingers clear of neighbours.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from vrts.base.diagnostic import Rule
from vrts.base.oat import rotation_from_oat
from vrts.base.pose import (
    IDENTITY,
    Z_AXIS,
    Pose,
    Vector,
    add,
    rotation_about,
    rotation_angle,
    translation,
)
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import DEG, MM, mm
from vrts.geometry.support import bounds, extent_of
from vrts.robots.model import Gripper
from vrts.scene.clearance import Placed, placed_body
from vrts.scene.handling.workable import (
    LEAST_GAP,
    LEAST_MARGIN,
    LEAST_PAD_GAP,
    Place,
    best_place,
    near,
)
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reach import branches, obstacle
from vrts.scene.things.symmetry import SAME_TURN, symmetries_of

TOO_WIDE = Rule("V615", "too-wide")
NO_PLACE = Rule("V618", "no-place")
UNREACHABLE = Rule("V619", "location-unreachable")

ALONG_Y = 90.0  # [degrees] the turn that is tried first: the fingers close along Y
PALM_GAP = 15e-3  # [m] between the top of a gripped object and the hand
TIP_GAP = 10e-3  # [m] between the finger tips and what the object stands on
BY_ITS_EDGE = {"dish": "wall", "pizza": "handle"}  # how kinds are gripped that are wide
SAFE_GAP = 0.1  # [m] between the highest thing and an object held at `safe`


def down_pose(x_mm: float, y_mm: float, z_mm: float, turn_deg: float) -> Pose:
    """Return a pose with the hand straight down: O = turn, A = 90, T = 0.

    Args:
        x_mm: Position in mm, as are `y_mm` and `z_mm`.
        y_mm: See `x_mm`.
        z_mm: See `x_mm`.
        turn_deg: Direction in which the fingers close, in degrees counter-clockwise from X.
    """
    return _down((x_mm * MM, y_mm * MM, z_mm * MM), turn_deg)


def find_places(
    scene: Scene, given: Mapping[str, Pose], section: Table | None, problems: Problems
) -> Mapping[str, Pose]:
    """Return the named locations of a scene, those of its file first where names are the same.

    Args:
        scene: The workspace, its locations still empty.
        given: Locations of the file.
        section: Where they stand.
        problems: Receives a warning for everything that cannot be gripped or reached.
    """
    found: dict[str, Pose] = {}
    movable = [body for body in scene.bodies if body.mobility is Mobility.MOVABLE]
    bases = [body for body in scene.bodies if body.kind == "base"]
    heights: dict[str, float] = {}
    for body in movable:
        name = f"{body.name}_grip".lower()
        if name in given:
            found[name] = given[name]
            continue
        if body.kind == "mesh":
            place = _grip_mesh(scene, body, problems)
            if place is not None:
                found[name] = place.X_WT
                heights[body.name] = _height(scene, body, place)
            continue
        if not any(_fits(scene.robot.gripper, body, turn) for turn in _turns(body)):
            _warn_too_wide(scene.robot.gripper, body, problems)
            continue
        height = grip_height(scene.robot.gripper, body)
        place = None if height is None else _grip(scene, body, height)
        if height is None or place is None:
            why = None if height is None else _out_of_reach(scene, body.X_WO.translation, height)
            _warn_no_place(f"`{body.name}` cannot be gripped from above", body, problems, why)
            continue
        heights[body.name] = height
        found[name] = place.X_WT
    for base in bases:
        for name, body in _put_names(scene, base, movable, heights, found):
            if name in given:
                found[name] = given[name]
                continue
            grip = found[f"{body.name}_grip".lower()]
            place = _put(scene, base, body, heights[body.name], grip)
            if place is None:
                headline = f"`{body.name}` cannot be set down on `{base.name}` from above"
                top = (*base.X_WO.translation[:2], bounds(base.pieces, base.X_WO).upper[2])
                why = _out_of_reach(scene, top, heights[body.name])
                _warn_no_place(headline, base, problems, why)
            else:
                found[name] = place.X_WT
    safe = None if "safe" in given else _safe(scene, movable)
    if safe is not None:
        found["safe"] = safe.X_WT
    found.update(given)
    if section is not None:
        check_given(scene, given, section, problems)
    return MappingProxyType(found)


def grip_height(gripper: Gripper, body: Body) -> float | None:
    """Return how high above an object's underside the middle of the pads grips it [m].

    Near the middle, but low enough in the hand and high enough above the support; None when the
    object is too low or too high for that. Rounded to whole millimetres.
    """
    height = extent_of(body.pieces, body.X_WO, (0.0, 0.0, 1.0)).length
    pads = gripper.X_FP.translation[2]
    hand = extent_of(gripper.body, translation(0, 0, 0), (0.0, 0.0, 1.0)).upper
    tips = max(
        extent_of(finger.pieces, translation(0, 0, 0), (0.0, 0.0, 1.0)).upper
        for finger in gripper.fingers
    )
    lowest = max(height - (pads - hand - PALM_GAP), tips - pads + TIP_GAP)
    highest = height - gripper.overlap_min
    if lowest > highest:
        return None
    return math.ceil(round(max(height / 2, lowest) / MM, 6)) * MM


def _down(point: Vector, turn_deg: float) -> Pose:
    return Pose(rotation_from_oat(turn_deg, 90.0, 0.0), point)


def _downs(point: Vector, turns: Sequence[float]) -> list[Pose]:
    return [_down(point, turn) for turn in turns]


def _turns(body: Body) -> Iterator[float]:
    """Yield closing directions that suit an object, in degrees from X, the plainest first."""
    if body.symmetry_axis is not None:
        yield from (ALONG_Y, 0.0, 45.0, 135.0, -90.0, 180.0, -45.0, -135.0)
        return
    own = _own(body)
    for offset in (90.0, 0.0, -90.0, 180.0):
        yield (own + offset + 180.0) % 360.0 - 180.0 or 0.0


def _own(body: Body) -> float:
    """Return how an object is turned about the vertical [degrees]."""
    return math.degrees(math.atan2(body.X_WO.rotation[3], body.X_WO.rotation[0]))


def _fits(gripper: Gripper, body: Body, turn: float) -> bool:
    along = (math.cos(turn * DEG), math.sin(turn * DEG), 0.0)
    width = extent_of(body.pieces, body.X_WO, along).length
    return width + 2 * LEAST_PAD_GAP <= gripper.opening_max


def _grip(scene: Scene, body: Body, height: float) -> Place | None:
    point = add(body.X_WO.translation, (0.0, 0.0, height))
    others = [other for other in scene.bodies if other.name != body.name]
    turns = [turn for turn in _turns(body) if _fits(scene.robot.gripper, body, turn)]
    return best_place(scene, _downs(point, turns), others, own=(placed_body(body),))


def _grip_mesh(scene: Scene, body: Body, problems: Problems) -> Place | None:
    """Return where the hand takes what a mesh describes; None after saying why not."""
    from vrts.scene.handling.mesh_grips import least_height, mesh_grips  # numpy

    grips = mesh_grips(scene.robot.gripper, body)
    least = least_height(scene.robot.gripper)
    if not grips and bounds(body.pieces, IDENTITY).upper[2] < least:
        why = f"it is too low for the fingers to get round it: {mm(least):.0f} mm are needed"
        _warn_no_place(f"`{body.name}` cannot be gripped from above", body, problems, why)
        return None
    if not grips:
        _warn_too_wide(scene.robot.gripper, body, problems)
        return None
    others = [other for other in scene.bodies if other.name != body.name]
    poses = [body.X_WO @ X_OP for X_OP in grips]
    place = best_place(scene, poses, others, own=(placed_body(body),))
    if place is None:
        why = _out_of_reach(scene, poses[0].translation, 0.0)
        _warn_no_place(f"`{body.name}` cannot be gripped from above", body, problems, why)
    return place


def _height(scene: Scene, body: Body, place: Place) -> float:
    """Return how high above an object's underside the pads are at a place [m]."""
    X_WP = place.X_WT @ scene.X_FT.inverse() @ scene.robot.gripper.X_FP
    return X_WP.translation[2] - body.X_WO.translation[2]


def _put(scene: Scene, base: Body, body: Body, height: float, grip: Pose) -> Place | None:
    """Return where the hand sets an object down so that it stands as it stood, or looks so.

    Args:
        scene: The workspace.
        base: What it is set on, in the middle.
        body: The object.
        height: Of the pads above its underside [m].
        grip: X_WT where it is gripped.
    """
    top = bounds(base.pieces, base.X_WO).upper[2]
    x, y, _ = base.X_WO.translation
    held = Placed(body.name, body.pieces, Pose(body.X_WO.rotation, (x, y, top)))
    others = [other for other in scene.bodies if other.name != body.name]
    for other in others:
        if other.name != base.name and near(held, placed_body(other), LEAST_GAP):
            return None
    if body.kind == "mesh":  # as it is gripped; no turn of it is known to look the same
        X_WP = grip @ scene.X_FT.inverse() @ scene.robot.gripper.X_FP
        poses = [held.X_WO @ body.X_WO.inverse() @ X_WP]
        return best_place(scene, poses, others, own=(held,))
    gripped = _turn_of(scene, grip)
    turns = [
        turn
        for turn in _turns(body)
        if _fits(scene.robot.gripper, body, turn) and _looks_the_same(body, turn - gripped)
    ]
    return best_place(scene, _downs((x, y, top + height), turns), others, own=(held,))


def _turn_of(scene: Scene, X_WT: Pose) -> float:
    """Return in which direction the fingers close at a place [degrees from X]."""
    X_WP = X_WT @ scene.X_FT.inverse() @ scene.robot.gripper.X_FP
    across = X_WP.orientation
    return math.degrees(math.atan2(across[1], across[0]))


def _looks_the_same(body: Body, turn: float) -> bool:
    """Return whether an object that is turned about the vertical [degrees] looks as before."""
    found = symmetries_of(body).upright()
    if found.axis is not None:
        return True
    about = rotation_about(Z_AXIS, turn * DEG)
    return any(rotation_angle(about, known.rotation) < SAME_TURN for known in found.turns)


def _put_names(
    scene: Scene,
    base: Body,
    movable: Sequence[Body],
    heights: Mapping[str, float],
    grips: Mapping[str, Pose],
) -> Iterator[tuple[str, Body]]:
    """Yield the names of places on a base: one if all objects are gripped alike, else one each.

    Alike they are gripped that end alike when they are set down at one place.
    """
    bodies = [body for body in movable if body.name in heights]
    turns = [_turn_of(scene, grips[f"{body.name}_grip".lower()]) - _own(body) for body in bodies]
    alike = len({heights[body.name] for body in bodies}) == 1 and all(
        body.pieces == bodies[0].pieces and _looks_the_same(body, turn - turns[0])
        for body, turn in zip(bodies, turns, strict=True)
    )
    alike = alike and all(_looks_the_same(body, _own(body) - _own(bodies[0])) for body in bodies)
    if alike:
        yield f"{base.name}_put".lower(), bodies[0]
        return
    for number, body in enumerate(bodies, 1):
        yield f"{base.name}_put{number}".lower(), body


def _safe(scene: Scene, movable: Sequence[Body]) -> Place | None:
    """Return a place above the middle of the work, higher than everything with what is held."""
    work = [body for body in scene.bodies if body.kind not in ("floor", "table")]
    if not work:
        return None
    top = max(
        bounds(body.pieces, body.X_WO).upper[2] for body in scene.bodies if body.kind != "floor"
    )
    tall = max(
        (bounds(body.pieces, body.X_WO).upper[2] - body.X_WO.translation[2]) for body in work
    )
    x = sum(body.X_WO.translation[0] for body in work) / len(work)
    y = sum(body.X_WO.translation[1] for body in work) / len(work)
    z = top + SAFE_GAP + (tall if movable else 0.0)
    point = (_tens(x), _tens(y), _tens(z))
    turns = (ALONG_Y, 0.0, -90.0, 180.0)
    return best_place(scene, _downs(point, turns), scene.bodies, own=())


def _tens(length: float) -> float:
    return round(length / (10 * MM)) * 10 * MM


def _warn_too_wide(gripper: Gripper, body: Body, problems: Problems) -> None:
    remedy = "make it narrower, or write fixed = true"
    if body.kind == "mesh":
        remedy = "say where it is held: grip = { at_mm = [x, y, z], turn_deg = 90 }"
    if body.kind in BY_ITS_EDGE:
        part = BY_ITS_EDGE[body.kind]
        remedy = f"write in `[locations]`, as `{body.name}_grip`, where it is gripped by its {part}"
    problems.warning(
        TOO_WIDE,
        f"`{body.name}` is too wide for the hand",
        body.span,
        notes=(f"the hand opens {mm(gripper.opening_max):.0f} mm",),
        help=(remedy,),
        data={"body": body.name},
    )


def _out_of_reach(scene: Scene, foot: Vector, height: float) -> str | None:
    """Return why the hand, straight down, does not get to what stands at a point; None: it does."""
    X_WP = _down(add(foot, (0.0, 0.0, height)), ALONG_Y)
    why = obstacle(scene.robot, X_WP @ scene.robot.gripper.X_FP.inverse())
    return None if why is None else f"with the hand straight down: {why}"


def _warn_no_place(headline: str, body: Body, problems: Problems, why: str | None) -> None:
    least = math.degrees(LEAST_MARGIN)
    tried = f"hand down, LEFTY ABOVE, clear of neighbours, {least:.0f} degrees inside the limits"
    problems.warning(
        NO_PLACE,
        headline,
        body.span,
        notes=(why or tried,),
        help=("move it, or give the location in [locations]",),
        data={"body": body.name},
    )


def check_given(
    scene: Scene, given: Mapping[str, Pose], section: Table, problems: Problems
) -> None:
    """Warn of places of a file that the robot cannot reach."""
    keys = {key.lower(): key for key in section.keys}
    for name, X_WT in given.items():
        ways = branches(scene.robot, X_WT @ scene.X_FT.inverse())
        if any(way.within_limits for way in ways):
            continue
        problems.warning(
            UNREACHABLE,
            f"the robot cannot reach `{name}`",
            section.span_of(keys[name]),
            notes=("with the scene's TOOL, on any arm branch",),
            data={"name": name},
        )
