"""Descriptions of arms: whatever a file holds, it is read as an arm or refused in words."""

import math
from typing import cast

from hypothesis import given
from hypothesis import strategies as st

from tests.places import ROOT
from vrts.base.pose import distance
from vrts.robots.kinematics.branch import INITIAL_BRANCH
from vrts.robots.kinematics.kinematics import forward, limit_violations, solve
from vrts.robots.model import Configuration, SerialArm
from vrts.robots.urdf.description import Description, UrdfFault
from vrts.robots.urdf.reader import read_urdf
from vrts.robots.urdf.serial_robot import Manner, serial_robot
from vrts.robots.urdf.stl import stl_points

ARM = (ROOT / "scenes" / "one-can-urdf" / "arm.urdf").read_bytes()
READY: Configuration = (0.0, 0.0, 0.0, 0.0, math.pi / 2, 0.0)


def cut_and_pasted(first: int, length: int, at: int, piece: bytes) -> bytes:
    text = ARM[:first] + ARM[first + length :]
    return text[:at] + piece + text[at:]


def read_or_refuse(data: bytes) -> Description | None:
    try:
        description = read_urdf(data)
        serial_robot(description, Manner("arm", "arm", READY, 0.5, 0.5, 1.0), lambda _: ARM)
    except UrdfFault:
        return None
    return description


@given(
    st.integers(0, len(ARM)),
    st.integers(0, 200),
    st.integers(0, len(ARM)),
    st.sampled_from(
        [b"", b"<link/>", b'"', b"<", b"&amp;", b"1e400", b"\xff", b"<joint>", b" 0 0"]
    ),
)
def test_damaged_files_are_read_or_refused(first: int, length: int, at: int, piece: bytes) -> None:
    read_or_refuse(cut_and_pasted(first, length, at, piece))


@given(st.binary(max_size=300))
def test_any_bytes_are_refused(data: bytes) -> None:
    assert read_or_refuse(data) is None


@given(st.binary(max_size=300) | st.binary(max_size=200).map(lambda b: b"solid vertex 1 2 3 " + b))
def test_any_bytes_are_a_mesh_or_none(data: bytes) -> None:
    points = stl_points(data)
    assert points is None or points.shape[1] == 3


@st.composite
def arms(draw: st.DrawFn) -> SerialArm:
    """Make up an arm: offsets of hand's breadths, axes along x, y or z by turns."""
    lengths = st.floats(0.05, 0.4).map(lambda value: round(value, 3))
    text = ARM.decode()
    for before in ("0.05 0 0.16", "0 0 0.42", "0.40 0 0.06"):
        x, y, z = draw(lengths), draw(lengths), draw(lengths)
        text = text.replace(f'<origin xyz="{before}"/> <axis', f'<origin xyz="{x} {y} {z}"/> <axis')
    description = read_urdf(text.encode())
    arm = serial_robot(description, Manner("arm", "arm", READY, 0.5, 0.5, 1.0), lambda _: b"").arm
    assert isinstance(arm, SerialArm)
    return arm


@given(arms(), st.lists(st.floats(-0.8, 0.8), min_size=6, max_size=6))
def test_what_is_reached_is_reached_exactly(arm: SerialArm, shares: list[float]) -> None:
    q = cast(
        Configuration,
        tuple(
            0.5 * (lower + upper) + 0.5 * share * (upper - lower)
            for share, lower, upper in zip(shares, arm.lower, arm.upper, strict=True)
        ),
    )
    X_BF = forward(arm, q)
    found = solve(arm, X_BF, INITIAL_BRANCH, q)
    assert found is not None
    assert not limit_violations(arm, found)
    assert distance(forward(arm, found).translation, X_BF.translation) < 1e-9
