"""What robot and bodies look like, as markers that go with their frames."""

from collections.abc import Iterator

import numpy as np
from rosbags.typesys.stores.ros2_humble import visualization_msgs__msg__Marker as Marker
from rosbags.typesys.stores.ros2_humble import visualization_msgs__msg__MarkerArray as MarkerArray

from vrts.report.picture.lighting import to_srgb
from vrts.report.picture.solids import Color, Solid, body_solids, link_solids
from vrts.report.ros.markers import marker, together
from vrts.report.ros.messages import FLANGE, ColorRGBA, Point, link_frame
from vrts.report.ros.transforms import frame_of_finger
from vrts.scene.model import Scene


def shapes(scene: Scene) -> MarkerArray:
    """Return the surfaces of everything in a scene: the pieces that are tested for collision."""
    named = [*_robot(scene), *((solid.name, solid) for solid in body_solids(scene))]
    return together([_mesh(frame, number, solid) for number, (frame, solid) in enumerate(named)])


def _robot(scene: Scene) -> Iterator[tuple[str, Solid]]:
    robot = scene.robot
    frames = [link_frame(link.joint) for link in robot.arm.links]
    frames += [FLANGE, *(frame_of_finger(finger.name) for finger in robot.gripper.fingers)]
    for frame, solid in zip(frames, link_solids(robot), strict=True):
        if len(solid.surface.corners):
            yield frame, solid


def _mesh(frame: str, number: int, solid: Solid) -> Marker:
    points = [Point(*row) for row in solid.surface.corners.reshape(-1, 3).tolist()]
    return marker(
        Marker.TRIANGLE_LIST, frame, ("shapes", number), _painted(solid.color), points=points
    )


def _painted(color: Color) -> ColorRGBA:
    red, green, blue = (to_srgb(np.array(color, np.float32)) / 255.0).tolist()
    return ColorRGBA(red, green, blue, 1.0)
