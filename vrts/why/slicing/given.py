"""Locations that the scene gives: they are taken to be right."""

import math

from vrts.base.pose import Pose, distance, rotation_angle
from vrts.why.slicing.executed import Steps
from vrts.why.slicing.read import Reading

GIVEN = 1e-3  # [m] a location so near to one of the scene is that one
GIVEN_TURN = math.radians(1.0)


def is_given(steps: Steps, each: Reading) -> bool:
    """Return whether what was read is a location of the scene, as it stands there.

    Of its own name where the scene knows it. A step that sets a variable of another name to such a
    location may have chosen the wrong one; of the elements of an array a subscript chooses.
    """
    if each.cell is None:
        return False
    since = [n for n in each.cell.since if n <= each.before]
    name = each.cell.name
    set_by_step = bool(since) and since[-1] > 0 and "[" not in name
    if set_by_step and name not in steps.run.scene.locations:
        return False
    return is_of_scene(steps, each.value, name)


def is_of_scene(steps: Steps, content: object, name: str = "") -> bool:
    """Return whether a value is a location that the scene names: this one, where it knows it."""
    if not isinstance(content, Pose):
        return False
    locations = steps.run.scene.locations
    meant = [locations[name]] if name in locations else locations.values()
    return any(near(content, pose) for pose in meant)


def near(one: Pose, other: Pose) -> bool:
    """Return whether two poses are within a millimetre and a degree."""
    apart = distance(one.translation, other.translation)
    return apart < GIVEN and rotation_angle(one.rotation, other.rotation) < GIVEN_TURN
