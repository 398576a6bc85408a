"""Joint states as a table of text: a row for each message, a column for each joint."""

import math
import struct
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, cast

from rosbags.serde import SerdeError
from rosbags.typesys import Stores, get_typestore
from rosbags.typesys.store import Typestore
from rosbags.typesys.stores.ros2_humble import sensor_msgs__msg__JointState as JointState

from vrts.validate.log.bags import mcap_file, sqlite_file
from vrts.validate.log.bags.faults import KIND, MOST_MESSAGE, BagFault

MOST_JOINTS = 64
NS = 1_000_000_000
DAMAGED = (SerdeError, struct.error, ValueError, IndexError, OverflowError)


class _Row(NamedTuple):
    time_ns: int
    values: dict[str, float]  # by joint [rad, m]


def bag_text(files: Sequence[bytes]) -> str:
    """Return the joint states of the files of a bag as a table with tabs between its columns.

    Of several topics the one with most messages counts.

    Raises:
        BagFault: A file is damaged, or no joint state is in any.
    """
    topics: dict[str, list[_Row]] = {}
    for data in files:
        of_mcap = data.startswith(mcap_file.MAGIC)
        read = mcap_file.mcap_messages if of_mcap else sqlite_file.sqlite_messages
        for topic, time_ns, message in read(data):
            topics.setdefault(topic, []).append(_row(time_ns, message))
    if not topics:
        raise BagFault(f"it has no messages of the kind `{KIND}`")
    topic = max(topics, key=lambda name: (len(topics[name]), name))
    rows = sorted(topics[topic], key=lambda row: row.time_ns)
    names = list(dict.fromkeys(name for row in rows for name in row.values))
    if len(names) > MOST_JOINTS:
        raise BagFault(f"`{topic[:80]}` names more than {MOST_JOINTS} joints")
    begin = rows[0].time_ns
    lines = ["\t".join(["time_s", *(f"{_cell(name)} [rad]" for name in names)])]
    for row in rows:
        values = (row.values.get(name, math.nan) for name in names)
        time_s = (row.time_ns - begin) / NS
        lines.append("\t".join([f"{time_s:.9f}", *(repr(value) for value in values)]))
    return "\n".join(lines)


@lru_cache(maxsize=1)
def _types() -> Typestore:
    return get_typestore(Stores.ROS2_HUMBLE)


def _row(log_ns: int, message: bytes) -> _Row:
    if len(message) > MOST_MESSAGE:
        raise BagFault(f"a message of it has more than {MOST_MESSAGE:,} bytes")
    try:
        state = cast(JointState, _types().deserialize_cdr(message, KIND))
    except DAMAGED as problem:
        raise BagFault("it is damaged: a message is no joint state") from problem
    stamp = state.header.stamp
    time_ns = stamp.sec * NS + stamp.nanosec or log_ns  # a driver without a clock writes zero
    if len(state.name) > MOST_JOINTS:
        raise BagFault(f"a message of it names more than {MOST_JOINTS} joints")
    return _Row(time_ns, dict(zip(state.name, state.position.tolist(), strict=False)))


def _cell(name: str) -> str:
    """Return a name without what would part columns."""
    return " ".join(name.replace('"', " ").split())[:80]
