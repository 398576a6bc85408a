"""Where the hand grips and sets down, as the page takes it: fixed to the object it is about."""

from typing import Final

from vrts.base.pose import IDENTITY
from vrts.live.session.channel.rows import HandPlace
from vrts.report.page.viewer_data import pose_numbers
from vrts.scene.model import Scene

MOST: Final = 200  # places that are told
_ENDS: Final = ("_grip", "_put")


def places_of(scene: Scene) -> tuple[HandPlace, ...]:
    """Return the named locations of a scene.

    Those of objects are in the frame of their object, so that they go where it goes; others, and
    those of objects that nobody knows, are in the world.
    """
    found: list[HandPlace] = []
    bodies = sorted(scene.bodies, key=lambda body: -len(body.name))
    for name, X_WT in list(scene.locations.items())[:MOST]:
        end = next((end for end in _ENDS if name.lower().endswith(end)), "")
        stem = name.lower().removesuffix(end) if end else ""
        body = next((each for each in bodies if stem and stem.endswith(each.name.lower())), None)
        X_WO = IDENTITY if body is None else body.X_WO
        numbers = tuple(pose_numbers(X_WO.inverse() @ X_WT))
        found.append(HandPlace(name, "" if body is None else body.name, numbers))
    return tuple(found)
