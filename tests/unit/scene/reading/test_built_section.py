"""`[robot.built]`: how an arm stands where that is not what its controller counts with."""

import pytest

from tests.unit.scene.reading.test_lab import in_lab, laid
from vrts.base.units import DEG, MM
from vrts.robots.arms.puma import PUMA_761
from vrts.robots.built import as_built
from vrts.robots.kinematics.kinematics import forward, hand_pose
from vrts.robots.model import Off, Within

START = "[lab]\n[lab.robot.built]\n"


def test_numbers_are_read_in_their_units() -> None:
    scene = in_lab(
        f"{START}stands_off_deg = [0, 0, 0.5, 0, 0, 0]\nzero_deg = [1, 0, 0, 0, 0, 0]\n"
        "link_mm = [1, 2, 3, 4]\nbase_mm = [1, 0, 2]\nbase_turn_deg = [0, 0, 0.1]\n"
        "[lab.robot.built.within]\nstands_off_deg = [0, 0, 0.02, 0, 0, 0]\nlinear_percent = 2\n"
        "speed_percent = [1, 1, 1, 1, 1, 1]\nacceleration_s = 0.028\n"
    )
    off = Off(
        shown=(0.0, 0.0, 0.5 * DEG, 0.0, 0.0, 0.0),
        zeros=(DEG, 0.0, 0.0, 0.0, 0.0, 0.0),
        links=(1 * MM, 2 * MM, 3 * MM, 4 * MM),
        base=(1 * MM, 0.0, 2 * MM),
        turn=(0.0, 0.0, 0.1 * DEG),
    )
    within = Within(
        Off(shown=(0.0, 0.0, 0.02 * DEG, 0.0, 0.0, 0.0)),
        (0.01, 0.01, 0.01, 0.01, 0.01, 0.01),
        0.02,
        0.028,
        0.0,
    )
    assert scene.robot.arm == as_built(PUMA_761, off, within)


def test_the_tool_is_off_along_its_own_axes() -> None:
    """TOOL 0 0 150 90 0 0 turns X of the tool along Y of the flange."""
    tool = "tool_xyzoat = [0, 0, 150, 180, -90, 0]\n"
    scene = in_lab(f"[lab]\n[lab.robot]\n{tool}[lab.robot.built]\ntool_mm = [1, 0, 0]\n")
    built = scene.robot.arm.built
    assert built is not None
    x, y, z = scene.X_FT.rotation[0] * MM, scene.X_FT.rotation[3] * MM, scene.X_FT.rotation[6] * MM
    assert built.off.tool == pytest.approx((x, y, z), abs=1e-12)
    assert abs(y) > 0.9 * MM


def test_a_link_that_is_counted_wrong_changes_the_controller_and_not_the_arm() -> None:
    arm = in_lab(f"{START}counted_link_mm = [2, 0, 0, 0]\n").robot.arm
    q = (0.1, -0.8, 1.0, 0.2, 0.3, 0.0)
    assert hand_pose(arm, q).translation == pytest.approx(forward(PUMA_761, q).translation)
    there = hand_pose(arm, q).translation
    far = [a - b for a, b in zip(forward(arm, q).translation, there, strict=True)]
    assert sum(x * x for x in far) ** 0.5 == pytest.approx(2 * MM)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("stands_off_deg = [0, 0, 25, 0, 0, 0]\n", "stands_off_deg"),
        ("tool_mm = [1, 2]\n", "tool_mm"),
        ("tilt_deg = 3\n", "tilt_deg"),
        ("link_mm = [1, 0, 0]\n", "link_mm"),
        ("within = 3\n", "within"),
        ("[lab.robot.built.within]\ntool_mm = [0, 0, -1]\n", "tool_mm"),
        ("[lab.robot.built.within]\nspeed_percent = [99, 0, 0, 0, 0, 0]\n", "speed_percent"),
    ],
)
def test_what_is_wrong_is_told_where_it_stands(text: str, said: str) -> None:
    found, told = laid(START + text)
    assert found is None
    (one,) = [d for d in told if d.is_error]
    assert said in one.headline
    assert one.primary is not None
    assert one.primary.span.source.name.endswith("lab.toml")


def test_links_of_the_family_belong_to_the_family() -> None:
    found, told = laid(
        "[lab]\n[lab.robot]\nname = 'ur5'\n[lab.robot.built]\nlink_mm = [1, 0, 0, 0]\n"
    )
    assert found is None
    assert any("link_mm" in d.headline for d in told)
