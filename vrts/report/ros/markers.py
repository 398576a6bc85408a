"""What touched and what came near, as `visualization_msgs/MarkerArray`, while it lasts."""

from collections.abc import Iterator, Sequence
from typing import Any, cast

import numpy as np
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Vector3 as Vector3
from rosbags.typesys.stores.ros2_humble import sensor_msgs__msg__CompressedImage as CompressedImage
from rosbags.typesys.stores.ros2_humble import visualization_msgs__msg__Marker as Marker
from rosbags.typesys.stores.ros2_humble import visualization_msgs__msg__MarkerArray as MarkerArray
from rosbags.typesys.stores.ros2_humble import visualization_msgs__msg__MeshFile as MeshFile

from vrts.base.pose import Vector
from vrts.check.verdict import CollisionReport, ContactEvent, NearMiss
from vrts.report.page.replay_data import contact_sentence
from vrts.report.plain import one_line
from vrts.report.quantities import millimetres
from vrts.report.ros.messages import (
    STILL,
    WORLD,
    ColorRGBA,
    Point,
    PoseMessage,
    duration,
    header,
    nanoseconds,
)

BALL_M, LINE_M, TEXT_M = 0.04, 0.004, 0.03  # sizes
SHORTEST_S = 0.2  # a marker stays long enough to be seen
RED = ColorRGBA(0.88, 0.11, 0.16, 1.0)
AMBER = ColorRGBA(0.96, 0.62, 0.0, 1.0)
WHITE = ColorRGBA(1.0, 1.0, 1.0, 1.0)
NO_IMAGE = CompressedImage(header(""), "", np.zeros(0, np.uint8))
NO_FILE = MeshFile("", np.zeros(0, np.uint8))


def touches(report: CollisionReport) -> Iterator[tuple[int, MarkerArray]]:
    """Return a message for each contact, graze and near miss, with its time [ns], in order."""
    found = [
        *(_touch("contacts", k, c, RED) for k, c in enumerate(report.contacts)),
        *(_touch("grazes", k, c, AMBER) for k, c in enumerate(report.grazes)),
        *(_near(k, miss) for k, miss in enumerate(report.near_misses)),
    ]
    return iter(sorted(found, key=lambda timed: timed[0]))


def together(markers: Sequence[Marker]) -> MarkerArray:
    """Return markers as one message."""
    # rosbags declares the elements as those of an older edition, which have fewer fields
    return MarkerArray(cast(list[Any], list(markers)))


def marker(
    kind: int,
    frame: str,
    name: tuple[str, int],
    color: ColorRGBA,
    *,
    size: float = 1.0,
    begin_ns: int = 0,
    lasts_s: float = 0.0,
    pose: PoseMessage = STILL,
    points: Sequence[Point] = (),
    text: str = "",
) -> Marker:
    """Return a marker.

    Args:
        kind: A constant of `Marker`.
        frame: The frame it goes with.
        name: Namespace and number, by which a later marker takes its place.
        color: Its colour.
        size: Of each of its three sides [m].
        begin_ns: From when it is shown [ns].
        lasts_s: How long [s]; 0: for ever.
        pose: In the frame.
        points: Of lines and triangles, in the pose [m].
        text: Of a text.
    """
    namespace, number = name
    return Marker(
        header(frame, begin_ns),
        namespace,
        number,
        kind,
        Marker.ADD,
        pose,
        Vector3(size, size, size),
        color,
        duration(lasts_s),
        frame_locked=True,
        points=list(points),
        colors=[],
        texture_resource="",
        texture=NO_IMAGE,
        uv_coordinates=[],
        text=text,
        mesh_resource="",
        mesh_file=NO_FILE,
        mesh_use_embedded_materials=False,
    )


def _touch(name: str, number: int, c: ContactEvent, color: ColorRGBA) -> tuple[int, MarkerArray]:
    begin_ns, lasts_s = _shown(c.start_s, c.end_s)
    ball = marker(
        Marker.SPHERE,
        WORLD,
        (name, number),
        color,
        size=BALL_M,
        begin_ns=begin_ns,
        lasts_s=lasts_s,
        pose=_at(c.point),
    )
    words = _text(name, number, c.point, contact_sentence(c), begin_ns, lasts_s)
    return begin_ns, together([ball, words])


def _near(number: int, miss: NearMiss) -> tuple[int, MarkerArray]:
    begin_ns, lasts_s = _shown(miss.start_s, miss.end_s)
    line = marker(
        Marker.LINE_STRIP,
        WORLD,
        ("near misses", number),
        AMBER,
        size=LINE_M,
        begin_ns=begin_ns,
        lasts_s=lasts_s,
        points=[Point(*place) for place in miss.witnesses],
    )
    first, second = (one_line(part) for part in miss.parts)
    sentence = f"{first} to {second}, {millimetres(miss.distance_m):g} mm"
    words = _text("near misses", number, miss.witnesses[0], sentence, begin_ns, lasts_s)
    return begin_ns, together([line, words])


def _text(
    name: str, number: int, place: Vector, words: str, begin_ns: int, lasts_s: float
) -> Marker:
    above = (place[0], place[1], place[2] + BALL_M)
    return marker(
        Marker.TEXT_VIEW_FACING,
        WORLD,
        (f"{name} in words", number),
        WHITE,
        size=TEXT_M,
        begin_ns=begin_ns,
        lasts_s=lasts_s,
        pose=_at(above),
        text=words,
    )


def _at(place: Vector) -> PoseMessage:
    return PoseMessage(Point(*place), STILL.orientation)


def _shown(start_s: float, end_s: float) -> tuple[int, float]:
    """Return from when [ns] and for how long [s] something is shown."""
    return nanoseconds(start_s), max(end_s - start_s, SHORTEST_S)
