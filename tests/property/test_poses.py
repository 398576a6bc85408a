"""Laws of poses and of VAL's angles."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vrts.base.oat import components, pose_from_components
from vrts.base.pose import IDENTITY, Pose, rotation_about, rotation_angle

angles = st.floats(-180, 180)
lengths = st.floats(-3000, 3000)
poses = st.builds(pose_from_components, lengths, lengths, lengths, angles, angles, angles)


def close(a: Pose, b: Pose, tolerance: float = 1e-9) -> bool:
    return (
        rotation_angle(a.rotation, b.rotation) < tolerance * 10
        and math.dist(a.translation, b.translation) < tolerance
    )


@given(poses)
def test_a_pose_survives_its_printed_components(pose: Pose) -> None:
    assert close(pose_from_components(*components(pose)), pose, 1e-6)


@given(poses, poses, poses)
def test_composition_is_associative(a: Pose, b: Pose, c: Pose) -> None:
    assert close((a @ b) @ c, a @ (b @ c))


@given(poses)
def test_a_pose_and_its_inverse_cancel(pose: Pose) -> None:
    assert close(pose @ pose.inverse(), IDENTITY)
    assert close(pose.inverse() @ pose, IDENTITY)


@given(angles, st.floats(0, math.pi))
def test_the_angle_of_a_rotation_is_the_angle_it_was_made_with(turn: float, angle: float) -> None:
    axis = pose_from_components(0, 0, 0, turn, turn / 3, 0).approach
    made = rotation_about(axis, angle)
    assert rotation_angle(IDENTITY.rotation, made) == pytest.approx(angle, abs=1e-9)
