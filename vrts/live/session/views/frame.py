"""Pose frames: what changes all the time, in as few bytes as possible.

Little endian: u8 type 1, u8 version, u16 session, u32 sequence, f64 time [s], 6 x f32 joints [rad],
f32 hand opening [m], u32 outputs 1 to 32 (bit 0 is output 1), u8 flags.
"""

import struct
from collections.abc import Iterable
from typing import Final, NamedTuple

KIND: Final = 1
VERSION: Final = 1
LAYOUT: Final = struct.Struct("<BBHId6ffIB")

RUNNING: Final = 1  # a program executes
MOVING: Final = 2  # the arm moves
STOPPING: Final = 4  # the arm decelerates: panic, BRAKE, a key let go
HOLDING: Final = 8  # something is in the hand


class PoseFrame(NamedTuple):
    """One of them."""

    session: int
    sequence: int
    time_s: float
    joints: tuple[float, ...]  # [rad]
    hand_m: float
    outputs: int
    flags: int


def packed(frame: PoseFrame) -> bytes:
    """Return the bytes of a frame."""
    return LAYOUT.pack(
        KIND,
        VERSION,
        frame.session,
        frame.sequence & 0xFFFFFFFF,
        frame.time_s,
        *frame.joints,
        frame.hand_m,
        frame.outputs,
        frame.flags,
    )


def unpacked(data: bytes) -> PoseFrame:
    """Return the frame that bytes hold.

    Raises:
        ValueError: They hold none of this version.
    """
    if len(data) != LAYOUT.size or data[0] != KIND or data[1] != VERSION:
        raise ValueError("no pose frame of this version")
    _, _, session, sequence, time_s, *rest = LAYOUT.unpack(data)
    return PoseFrame(session, sequence, time_s, tuple(rest[:6]), rest[6], rest[7], rest[8])


def output_bits(signals: Iterable[int]) -> int:
    """Return the outputs 1 to 32 that are on, as bits."""
    bits = 0
    for number in signals:
        if 1 <= number <= 32:
            bits |= 1 << (number - 1)
    return bits
