"""Findings on a whole scene that is right as a file: what an author would rather know.

Overlaps, objects that fall or are too wide, and locations out of reach are found by the reader of
scene files (V613 to V619). What is left concerns things that may be meant so.
"""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.units import mm
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.reach import reach
from vrts.scene.standing import DEEPEST, find_support, must_stand

FLOATING = Rule("V665", "floating-object")
LOCATION_INSIDE = Rule("V666", "location-inside")


def scene_findings(scene: Scene) -> tuple[Diagnostic, ...]:
    """Return notes on fixed things in the air, and warnings about locations inside bodies."""
    floating = [_floating(body) for body in scene.bodies if _floats(scene, body)]
    inside = [_inside(scene, name) for name in scene.locations]
    return (*floating, *(finding for finding in inside if finding is not None))


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
    near = reach(scene, scene.locations[name]).nearest
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
