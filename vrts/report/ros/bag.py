"""The bag: all messages of a run in one MCAP file, with the description that `ros2 bag` wants."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any, Protocol

from rosbags.interfaces import (
    Qos,
    QosDurability,
    QosHistory,
    QosLiveliness,
    QosReliability,
    QosTime,
)
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from vrts.report.assessment import Assessment
from vrts.report.poses.sampled import coordinates, times_of
from vrts.report.ros.joints import joint_states
from vrts.report.ros.markers import touches
from vrts.report.ros.program_log import log_messages
from vrts.report.ros.shapes import shapes
from vrts.report.ros.trajectories import trajectories
from vrts.report.ros.transforms import moving_frames, still_frames

VERSION = 8  # of the description; ROS 2 Iron and later, and all tools that read MCAP
RATE_HZ = 100.0  # joint states a second; transforms come as often
FOREVER = QosTime(9223372036, 854775807)  # as ROS 2 writes "no limit"


class Message(Protocol):
    """Any message; `rosbags` makes their classes."""

    __msgtype__: str


def write_bag(a: Assessment, folder: Path) -> Path:
    """Write a bag into a folder that is not there yet, and return the MCAP file in it.

    It holds no path of this machine and no time of day: the same run gives the same bytes.

    Raises:
        ValueError: There is no run.
    """
    if a.run is None or a.scene is None:
        raise ValueError("nothing was run")
    times = times_of(a.run, RATE_HZ)
    states, rates = coordinates(a.run, times)
    report = a.judgement.collisions if a.judgement else None
    with Writer(folder, version=VERSION, storage_plugin=StoragePlugin.MCAP) as bag:
        out = _Out(bag)
        out.send("/tf_static", [(0, still_frames(a.run))], latched=True)
        out.send("/shapes", [(0, shapes(a.scene))], latched=True)
        out.send("/joint_states", joint_states(a.scene.robot.arm, times, states, rates))
        out.send("/tf", moving_frames(a.run, times, states))
        out.send("/joint_trajectory", trajectories(a.run))
        out.send("/contacts", touches(report) if report else ())
        out.send("/rosout", log_messages(a))
    return folder / f"{folder.name}.mcap"


class _Out:
    """Topics of a bag that is open."""

    def __init__(self, bag: Writer) -> None:
        self._bag = bag
        self._types = get_typestore(Stores.ROS2_HUMBLE)

    def send(
        self, topic: str, messages: Iterable[tuple[int, Any]], *, latched: bool = False
    ) -> None:
        """Write the messages of a topic, if there are any."""
        connection = None
        for time_ns, message in messages:
            kind: str = message.__msgtype__
            if connection is None:
                connection = self._bag.add_connection(
                    topic, kind, typestore=self._types, offered_qos_profiles=[_quality(latched)]
                )
            self._bag.write(connection, time_ns, self._types.serialize_cdr(message, kind))


def _quality(latched: bool) -> Qos:
    """Return how a topic was offered; what is latched is sent to late subscribers too."""
    return Qos(
        QosHistory.KEEP_LAST,
        1 if latched else 10,
        QosReliability.RELIABLE,
        QosDurability.TRANSIENT_LOCAL if latched else QosDurability.VOLATILE,
        FOREVER,
        FOREVER,
        QosLiveliness.AUTOMATIC,
        FOREVER,
        avoid_ros_namespace_conventions=False,
    )
