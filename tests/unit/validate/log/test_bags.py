"""Bags of ROS 2 as logs: written by strangers' libraries, read without trust."""

import struct
import tempfile
from functools import cache
from io import BytesIO
from pathlib import Path

import lz4.frame
import numpy as np
import pytest
import zstandard
from mcap.records import Chunk
from mcap.writer import CompressionType
from mcap_ros2.writer import Writer as ForeignWriter
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore
from rosbags.typesys.stores.ros2_humble import builtin_interfaces__msg__Time as Time
from rosbags.typesys.stores.ros2_humble import sensor_msgs__msg__JointState as JointState
from rosbags.typesys.stores.ros2_humble import std_msgs__msg__Header as Header

from tests.unit.validate.support import path_run
from vrts.pipeline.refused import Refused
from vrts.validate.log.bags import mcap_file
from vrts.validate.log.bags.faults import MOST_CHUNK, BagFault
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.sampling import extent_of, sampled

TIMES = np.arange(0.0, 16.5, 0.05)
NAMES = [f"joint_{k}" for k in range(1, 7)]
BEGIN_NS = 1_790_000_000_000_000_000  # some day of 2026
KIND = "sensor_msgs/msg/JointState"
DEFINITION = """std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""


def times_ns() -> list[int]:
    return [BEGIN_NS + round(1e9 * time_s) for time_s in TIMES.tolist()]


@cache
def of_rosbags(plugin: StoragePlugin, mixed: bool = False) -> bytes:
    """Return the file of a bag with the joints of the closed path; `mixed`: in any order."""
    types, nothing = get_typestore(Stores.ROS2_HUMBLE), np.zeros(0)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bag"
        with Writer(path, version=8, storage_plugin=plugin) as bag:
            topic = bag.add_connection("/joint_states", KIND, typestore=types)
            other = bag.add_connection("/gripper/joint_states", KIND, typestore=types)
            joints = sampled(path_run(), TIMES).joints
            for count, (time_ns, row) in enumerate(zip(times_ns(), joints, strict=True)):
                stamp = Header(Time(time_ns // 10**9, time_ns % 10**9), "")
                order = [(k + mixed * count) % 6 for k in range(6)]
                names = [NAMES[k] for k in order]
                message = JointState(stamp, names, row[order], nothing, nothing)
                bag.write(topic, time_ns, types.serialize_cdr(message, KIND))
            message = JointState(Header(Time(1, 0), ""), ["finger"], np.zeros(1), nothing, nothing)
            bag.write(other, BEGIN_NS, types.serialize_cdr(message, KIND))
        (found,) = [file for file in path.iterdir() if file.suffix in (".mcap", ".db3")]
        return found.read_bytes()


@cache
def of_mcap(compression: CompressionType, size: int = 20_000) -> bytes:
    """Return the same as Foxglove's own library writes it."""
    stream = BytesIO()
    writer = ForeignWriter(stream, chunk_size=size, compression=compression)
    schema = writer.register_msgdef(KIND, DEFINITION)
    joints = sampled(path_run(), TIMES).joints
    for time_ns, row in zip(times_ns(), joints.tolist(), strict=True):
        stamp = {"sec": time_ns // 10**9, "nanosec": time_ns % 10**9}
        message = {
            "header": {"stamp": stamp, "frame_id": ""},
            "name": NAMES,
            "position": row,
            "velocity": [],
            "effort": [],
        }
        writer.write_message("/joint_states", schema, message, log_time=time_ns)
    writer.finish()
    return stream.getvalue()


def read(*files: bytes) -> RobotLog:
    return read_log(GivenLog("bag", files), extent_of(path_run()))


def same(log: RobotLog) -> bool:
    assert log.joints is not None
    near = np.abs(log.joints - sampled(path_run(), TIMES).joints).max() < 1e-9
    return bool(near) and np.abs(log.times - TIMES).max() < 1e-6


@pytest.mark.parametrize("plugin", [StoragePlugin.MCAP, StoragePlugin.SQLITE3])
@pytest.mark.parametrize("mixed", [False, True])
def test_a_bag_tells_the_joints_by_name(plugin: StoragePlugin, mixed: bool) -> None:
    assert same(read(of_rosbags(plugin, mixed)))


@pytest.mark.parametrize("compression", list(CompressionType))
def test_chunks_are_unpacked(compression: CompressionType) -> None:
    assert same(read(of_mcap(compression)))


def test_the_files_of_a_bag_are_one_log() -> None:
    split = [of_mcap(CompressionType.ZSTD), of_rosbags(StoragePlugin.SQLITE3)]
    log = read(*split)  # every instant twice: rows with the same time are left out
    assert same(log)
    assert any("time stamp of the row before" in d.headline for d in log.findings)


def test_a_bag_without_joint_states_says_so() -> None:
    stream = BytesIO()
    writer = ForeignWriter(stream)
    schema = writer.register_msgdef("std_msgs/msg/Bool", "bool data")
    writer.write_message("/lamp", schema, {"data": True}, log_time=1)
    writer.finish()
    with pytest.raises(Refused) as caught:
        read(stream.getvalue())
    (found,) = caught.value.diagnostics
    assert found.rule.code == "V880"
    assert found.notes == ("it has no messages of the kind `sensor_msgs/msg/JointState`",)


# strangers


def test_a_chunk_that_unpacks_to_too_much_is_refused_before_it_is_unpacked() -> None:
    bombs = {
        "zstd": zstandard.compress(bytes(20 * MOST_CHUNK)),
        "lz4": lz4.frame.compress(bytes(20 * MOST_CHUNK)),
    }
    for kind, packed in bombs.items():
        assert len(packed) < MOST_CHUNK
        chunk = Chunk(kind, packed, 0, 0, 0, 20 * MOST_CHUNK)
        with pytest.raises(BagFault, match="unpacks to more than"):
            mcap_file._unpacked(chunk)  # pyright: ignore[reportPrivateUsage]


def damaged(data: bytes, seed: int) -> bytes:
    """Return a file with some bytes changed, cut off or put in."""
    random = np.random.default_rng(seed)
    found = bytearray(data)
    for _ in range(int(random.integers(1, 6))):
        at = int(random.integers(0, len(found)))
        match int(random.integers(0, 4)):
            case 0:
                found[at] = int(random.integers(0, 256))
            case 1:
                del found[at : at + int(random.integers(1, 500))]
            case 2:
                found[at:at] = random.bytes(int(random.integers(1, 50)))
            case _:
                huge = int(random.random() * 2**40)
                found[at : at + 8] = struct.pack("<Q", huge)
        if not found:
            break
    return bytes(found)


def survives(data: bytes, count: int) -> None:
    codes: list[str] = []
    for seed in range(count):
        try:
            read(damaged(data, seed))
        except Refused as problem:
            codes += [d.rule.code for d in problem.diagnostics]
    assert len(codes) > count // 4
    assert all(code.startswith("V88") for code in codes)


@pytest.mark.parametrize("plugin", [StoragePlugin.MCAP, StoragePlugin.SQLITE3])
def test_a_damaged_bag_is_read_or_refused(plugin: StoragePlugin) -> None:
    survives(of_rosbags(plugin), 8)


@pytest.mark.thorough
@pytest.mark.parametrize("compression", list(CompressionType))
def test_damaged_chunks_are_read_or_refused(compression: CompressionType) -> None:
    survives(of_mcap(compression), 400)


@pytest.mark.thorough
@pytest.mark.parametrize("plugin", [StoragePlugin.MCAP, StoragePlugin.SQLITE3])
def test_many_damaged_bags_are_read_or_refused(plugin: StoragePlugin) -> None:
    survives(of_rosbags(plugin), 400)
