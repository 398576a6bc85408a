"""VAL's orientation angles: check values of the literature and of hand calculation."""

import math

import pytest

from vrts.base.oat import (
    components,
    known_components,
    oat_from_rotation,
    plain_angles,
    pose_from_components,
    rotation_from_oat,
)
from vrts.base.pose import Pose, Vector, rotation_angle

# (O, A, T), normal, orientation, approach; the first two are stated in words by the 1977 text
CHECK_VALUES: list[tuple[tuple[float, float, float], Vector, Vector, Vector]] = [
    ((0, 0, 0), (0, 0, -1), (1, 0, 0), (0, -1, 0)),
    ((90, 0, 0), (0, 0, -1), (0, 1, 0), (1, 0, 0)),
    ((90, -90, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((0, 90, 0), (0, 1, 0), (1, 0, 0), (0, 0, -1)),
    ((90, 90, 0), (-1, 0, 0), (0, 1, 0), (0, 0, -1)),
]


@pytest.mark.parametrize(("angles", "normal", "orientation", "approach"), CHECK_VALUES)
def test_angles_give_the_hand_vectors_of_the_literature(
    angles: tuple[float, float, float], normal: Vector, orientation: Vector, approach: Vector
) -> None:
    pose = Pose(rotation_from_oat(*angles), (0.0, 0.0, 0.0))
    assert pose.normal == normal
    assert pose.orientation == orientation
    assert pose.approach == approach


def test_identity_is_printed_as_90_minus_90_0() -> None:
    identity = pose_from_components(0, 0, 0, 90, -90, 0)
    assert components(identity) == (0, 0, 0, 90, -90, 0)


@pytest.mark.parametrize(
    ("yaw_pitch_roll", "angles"),
    [((20, 100, -60), (110, 10, -60)), ((30, 180, -45), (165, 90, 0)), ((0, 180, 0), (90, 90, 0))],
)
def test_plain_zyz_angles_differ_by_constant_offsets(
    yaw_pitch_roll: tuple[float, float, float], angles: tuple[float, float, float]
) -> None:
    yaw, pitch, roll = yaw_pitch_roll
    as_val = components(pose_from_components(0, 0, 0, yaw + 90, pitch - 90, roll))
    assert as_val[3:] == pytest.approx(angles, abs=1e-6)


def test_a_vertical_hand_is_printed_with_t_zero() -> None:
    down = pose_from_components(500, 200, 100, 30, 90, 75)
    assert components(down)[3:] == pytest.approx((-45, 90, 0), abs=1e-9)


def test_lengths_are_metres_inside() -> None:
    assert pose_from_components(1000, -2000, 500, 90, -90, 0).translation == (1.0, -2.0, 0.5)


def test_minus_180_is_printed_as_180() -> None:
    o = components(pose_from_components(0, 0, 0, -180, 0, 0))[3]
    assert o == pytest.approx(180)
    assert math.copysign(1, o) == 1


def test_rotation_angle_keeps_digits_near_zero() -> None:
    a = rotation_from_oat(10, 20, 30)
    b = rotation_from_oat(10, 20, 30 + 1e-7)
    assert math.degrees(rotation_angle(a, b)) == pytest.approx(1e-7, rel=1e-4)


@pytest.mark.parametrize("pitch", [0.0, 180.0])
@pytest.mark.parametrize("yaw", [0.0, 40.0, 90.0, -135.0, 180.0])
@pytest.mark.parametrize("roll", [0.0, 30.0, -170.0])
def test_a_hand_that_is_vertical_has_yaw_0_in_plain_angles(
    pitch: float, yaw: float, roll: float
) -> None:
    rotation = rotation_from_oat(yaw + 90.0, pitch - 90.0, roll)
    shown = plain_angles(*oat_from_rotation(rotation))
    assert shown[:2] == (0.0, pitch)
    assert -180.0 < shown[2] <= 180.0
    again = rotation_from_oat(shown[0] + 90.0, shown[1] - 90.0, shown[2])
    assert again == pytest.approx(rotation, abs=1e-12)


def test_plain_angles_of_a_hand_that_is_not_vertical() -> None:
    assert plain_angles(90.0, 0.0, 30.0) == (0.0, 90.0, 30.0)
    assert plain_angles(-100.0, 10.0, -30.0) == (170.0, 100.0, -30.0)
    assert plain_angles(-90.0, 89.0, 5.0) == (180.0, 179.0, 5.0)


def test_what_is_only_rounding_is_0() -> None:
    noisy = pose_from_components(3.98e-14, 190.0, 1645.0, 1e-9, 0.0, -1e-9)
    assert known_components(noisy)[:3] == (0.0, 190.0, 1645.0)
    assert known_components(noisy)[3:] == (0.0, 0.0, 0.0)
    small = pose_from_components(1e-6, 0.0, 0.0, 90.0, -90.0, 0.0)
    assert known_components(small)[0] == pytest.approx(1e-6)
    seen = pose_from_components(2e-4, 190.0, 1645.0, 90.0, -90.0, 0.0)
    assert known_components(seen)[0] == pytest.approx(2e-4)
