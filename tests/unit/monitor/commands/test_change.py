"""What the answer to `Change?` does, and the names TEACH counts through."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vrts.base.oat import components, pose_from_components
from vrts.base.units import DEG
from vrts.lang.dialect import Angles
from vrts.lang.names import is_truncated
from vrts.monitor.commands.change import with_components
from vrts.monitor.commands.teaching import successor
from vrts.monitor.listings import printed

PICK = pose_from_components(500, 200, 100, 90, 90, 0)
ANGLE = st.floats(-179, 179)


def test_omitted_components_stay() -> None:
    changed = with_components(PICK, (None, None, 150.0, None, None, None))
    assert components(changed) == pytest.approx((500, 200, 150, 90, 90, 0))  # type: ignore[arg-type]
    assert changed[0] == PICK.rotation  # to the last digit


@given(st.tuples(ANGLE, st.floats(-89, 89), ANGLE), ANGLE)
def test_one_angle_changes_alone(angles: tuple[float, float, float], new: float) -> None:
    X = pose_from_components(1, 2, 3, *angles)
    changed = with_components(X, (None, None, None, new, None, None))
    o, a, t = components(changed)[3:]  # type: ignore[arg-type]
    assert (o, a, t) == pytest.approx((new, angles[1], angles[2]), abs=1e-6)


def test_joints_are_degrees() -> None:
    changed = with_components((0.0,) * 6, (None, -90.0, None, None, None, 45.0))  # type: ignore[arg-type]
    assert changed == pytest.approx((0, -90 * DEG, 0, 0, 0, 45 * DEG))


@pytest.mark.parametrize(
    ("name", "indices", "following"),
    [
        ("p1", (), ("p2", ())),
        ("p9", (), ("p10", ())),
        ("grip", (), ("grip1", ())),
        ("#safe", (), ("#safe1", ())),
        ("a", (0,), ("a", (1,))),
        ("a", (2, 9), ("a", (2, 10))),
    ],
)
def test_names_count_up(
    name: str, indices: tuple[int, ...], following: tuple[str, tuple[int, ...]]
) -> None:
    assert successor(name, indices) == following


def test_counting_ends_where_names_and_arrays_do() -> None:
    assert successor("abcdefghijklmno", ()) is None
    assert successor("abcdefghijklm99", ()) is None
    assert successor("a", (32767,)) is None


@given(st.from_regex(r"#?[a-z][a-z0-9.]{0,14}", fullmatch=True))
def test_a_name_never_becomes_too_long(name: str) -> None:
    found = successor(name, ())
    assert found is None or (found[0] != name and not is_truncated(found[0]))


@given(st.tuples(ANGLE, st.floats(1, 179), ANGLE))
def test_in_v_plus_and_as_the_angles_are_those_of_z_y_z(angles: tuple[float, float, float]) -> None:
    changed = with_components(PICK, (1.0, 2.0, 3.0, *angles), Angles.ZYZ)
    assert printed(changed, Angles.ZYZ) == pytest.approx((1, 2, 3, *angles), abs=1e-6)  # type: ignore[arg-type]
    assert components(changed)[4:] == pytest.approx((angles[1] - 90, angles[2]), abs=1e-6)  # type: ignore[arg-type]
