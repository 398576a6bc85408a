"""Pose frames as bytes."""

import math
import struct

import pytest

from vrts.live.session.views.frame import (
    HOLDING,
    LAYOUT,
    MOVING,
    PoseFrame,
    output_bits,
    packed,
    unpacked,
)

FRAME = PoseFrame(513, 70_000, 12.345678, (0.1, -1.5, 1.5, 0.0, math.pi, -2.0), 0.04, 0b101, MOVING)


def test_a_frame_is_small_and_comes_back() -> None:
    data = packed(FRAME)
    assert len(data) == LAYOUT.size <= 100
    again = unpacked(data)
    assert again.joints == pytest.approx(FRAME.joints, abs=1e-6)
    assert again.hand_m == pytest.approx(FRAME.hand_m)
    assert again[:3] == FRAME[:3]
    assert again[5:] == FRAME[5:]


def test_bytes_lie_where_browsers_read_them() -> None:
    data = packed(FRAME)
    assert data[0] == 1
    assert data[1] == 1
    assert struct.unpack_from("<H", data, 2) == (513,)
    assert struct.unpack_from("<I", data, 4) == (70_000,)
    assert struct.unpack_from("<d", data, 8) == (12.345678,)
    assert struct.unpack_from("<f", data, 16) == pytest.approx((0.1,))
    assert struct.unpack_from("<f", data, 40) == pytest.approx((0.04,))
    assert struct.unpack_from("<I", data, 44) == (0b101,)
    assert data[48] == MOVING


def test_sequence_numbers_begin_again_instead_of_failing() -> None:
    assert unpacked(packed(FRAME._replace(sequence=2**32 + 5))).sequence == 5


def test_only_outputs_have_bits() -> None:
    assert output_bits({1, 3, 32, 33, 1001, 2010}) == 0b101 | 1 << 31


@pytest.mark.parametrize("data", [b"", b"\x01", packed(FRAME)[:-1], b"\x02" + packed(FRAME)[1:]])
def test_other_bytes_are_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="no pose frame"):
        unpacked(data)


def test_flags_are_bits_of_their_own() -> None:
    assert unpacked(packed(FRAME._replace(flags=MOVING | HOLDING))).flags == MOVING + HOLDING
