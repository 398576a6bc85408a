"""Findings on a whole scene that is right as a file: what an author would rather know.

Overlaps, objects that fall or are too wide, and locations out of reach are found by the reader of
scene files (V613 to V619). What is left concerns things that may be meant so, and objects that
nobody can pick up: a scene with one can still be run.
"""

from collections.abc import Iterable

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.units import mm
from vrts.scene.handling.holds import holds
from vrts.scene.handling.places import NO_PLACE
from vrts.scene.handling.withheld import all_locations
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reach import obstacle, reach
from vrts.scene.standing import DEEPEST, find_support, must_stand

FLOATING = Rule("V665", "floating-object")
LOCATION_INSIDE = Rule("V666", "location-inside")
OUT_OF_REACH = Rule("V791", "object-out-of-reach")


def scene_findings(scene: Scene) -> tuple[Diagnostic, ...]:
    """Return errors, warnings and notes on a scene.

    Errors for objects that no arm branch reaches, warnings about locations inside bodies, notes on
    fixed things in the air.
    """
    away = [_away(scene, body) for body in scene.bodies if body.mobility is Mobility.MOVABLE]
    floating = [_floating(body) for body in scene.bodies if _floats(scene, body)]
    inside = [_inside(scene, name) for name in all_locations(scene)]
    return (*filter(None, away), *floating, *filter(None, inside))


def without_repeats(
    reader: Iterable[Diagnostic], found: Iterable[Diagnostic]
) -> tuple[Diagnostic, ...]:
    """Return findings of the reader and of `scene_findings`, every cause once."""
    found = tuple(found)
    away = {d.data["body"] for d in found if d.rule == OUT_OF_REACH}
    kept = (d for d in reader if d.rule != NO_PLACE or d.data.get("body") not in away)
    return (*kept, *found)


def _away(scene: Scene, body: Body) -> Diagnostic | None:
    """Return that no arm branch brings the hand to an object, however it holds it."""
    gripper = scene.robot.gripper
    X_PF = gripper.X_FP.inverse()
    poses = [body.X_WO @ X_OP @ X_PF for X_OP in holds(gripper, body)]
    own = all_locations(scene).get(f"{body.name}_grip".lower())
    poses += [] if own is None else [own @ scene.X_FT.inverse()]
    if not poses or any(obstacle(scene.robot, X_WF) is None for X_WF in poses):
        return None
    why = obstacle(scene.robot, poses[0])
    return Diagnostic(
        OUT_OF_REACH,
        Severity.ERROR,
        f"the robot cannot reach `{body.name}` on any arm branch",
        None if body.span is None else Label(body.span),
        notes=(f"with the hand straight down: {why}", f"tried: {len(poses)} ways to hold it"),
        help=("move it nearer to the robot, or write fixed = true",),
        data={"body": body.name},
    )


def _floats(scene: Scene, body: Body) -> bool:
    if body.kind == "floor" or must_stand(body) or body.mobility is Mobility.MOVABLE:
        return False  # what must stand and does not is refused by the reader
    return not find_support(body, scene.bodies).touching


def _floating(body: Body) -> Diagnostic:
    return Diagnostic(
        FLOATING,
        Severity.NOTE,
        f"`{body.name}` is fixed in the air: it stands on nothing",
        None if body.span is None else Label(body.span),
        help=('write on = "NAME" of what it stands on, unless it hangs on a wall',),
        data={"body": body.name},
    )


def _inside(scene: Scene, name: str) -> Diagnostic | None:
    """Return a warning if the open hand at a location is inside a body."""
    near = reach(scene, all_locations(scene)[name]).nearest
    if near is None or near.clearance >= -DEEPEST:
        return None
    return Diagnostic(
        LOCATION_INSIDE,
        Severity.WARNING,
        f"at `{name}` the {near.part} is inside `{near.body}`",
        notes=(f"{mm(-near.clearance):.1f} mm deep, with the hand open",),
        help=("move the location, or turn the hand there",),
        data={"name": name, "body": near.body, "depth_m": -near.clearance},
    )
