"""A lab laid over a scene: its measures count, whatever it does not say stays."""

import re
from dataclasses import replace
from importlib.resources import files
from math import radians
from pathlib import Path

import pytest

from vrts.assignments.new_lab import LAB
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.geometry.support import bounds
from vrts.pipeline.files import CHECKOUT
from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.robots.arms.puma import PUMA_761
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab

TEXT = (CHECKOUT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
PLAIN, _ = read_scene(SourceFile("scene.toml", TEXT))


def laid(lab: str, scene: str = TEXT) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    found, told, _ = read_scene_in_lab(
        SourceFile("cans-on-bases/scene.toml", scene), SourceFile("lab.toml", lab), None, None
    )
    return found, told


def in_lab(lab: str) -> Scene:
    found, told = laid(lab)
    assert found is not None, told
    assert told == ()
    return found


def example(code: str) -> str:
    page = files("vrts").joinpath("pages", f"{code}.md").read_text("utf-8")
    found = re.search(r"```toml\n(.*?)\n```", page, re.DOTALL)
    assert found is not None
    return found[1] + "\n"


def test_the_written_lab_changes_nothing_but_the_title() -> None:
    """Neither as it is, nor with every number in it taken as it stands."""
    assert PLAIN is not None
    numbers = re.sub(r"^# (\w+ = [-\d\[])", r"\1", LAB, flags=re.MULTILINE)
    for text in (LAB, numbers):
        found = in_lab(text)
        assert found.title == f"{PLAIN.title}, in Our laboratory"
        for body, plain in zip(found.bodies, PLAIN.bodies, strict=True):
            assert replace(body, span=None) == replace(plain, span=None)
        assert found.locations == PLAIN.locations
        assert found.robot.gripper == PLAIN.robot.gripper == TWO_FINGERS
        assert found.robot.arm == PLAIN.robot.arm == PUMA_761
    assert LAB.count("\n# ") - numbers.count("\n# ") == 18


def test_limits_speeds_and_tool_are_those_of_the_lab() -> None:
    found = in_lab(
        "[lab.robot]\nupper_deg = [150, 20, 225, 266, 100, 300]\n"
        "speed_deg_s = [50, 50, 50, 80, 80, 80]\nlinear_mm_s = 250\nangular_deg_s = 30\n"
        "tool_xyzoat = [0, 0, 155, 90, -90, 0]\n"
    )
    arm = found.robot.arm
    assert arm.upper[0] == pytest.approx(radians(150))
    assert arm.lower == PUMA_761.lower
    assert arm.speed[5] == pytest.approx(radians(80))
    assert (arm.linear_speed, arm.angular_speed) == pytest.approx((0.25, radians(30)))
    assert found.X_FT.translation == pytest.approx((0, 0, 0.155))


def test_the_hand_of_the_lab_grips_and_opens_by_its_own_measures() -> None:
    assert PLAIN is not None
    found = in_lab(
        "[lab.gripper]\nlength_mm = 180\nfinger_mm = [24, 20, 100]\nopening_mm=[5, 62]\n"
    )
    hand = found.robot.gripper
    assert hand.X_FP.translation == pytest.approx((0, 0, 0.180))
    assert (hand.opening_min, hand.opening_max) == pytest.approx((0.005, 0.062))
    finger = bounds(hand.fingers[0].pieces, hand.X_FP)
    assert finger.upper[2] - finger.lower[2] == pytest.approx(0.1)
    assert found.X_FT == hand.X_FP
    narrow, told = laid("[lab.gripper]\nopening_mm = [0, 61]\n")
    assert narrow is not None
    assert {d.rule.code for d in told} == {"V615"}, "the cans are 60 mm wide"


def test_what_stands_on_the_table_is_as_high_as_that_of_the_lab() -> None:
    assert PLAIN is not None
    found = in_lab("[lab.table]\ntop_z_mm = -310\n")
    for name in ("base1", "can1"):
        lowered = found.body(name).X_WO.translation[2] - PLAIN.body(name).X_WO.translation[2]
        assert lowered == pytest.approx(-0.010)
    assert found.locations["can1_grip"].translation[2] == pytest.approx(
        PLAIN.locations["can1_grip"].translation[2] - 0.010
    )


def test_where_the_robot_stands_is_where_things_are_seen_from() -> None:
    """A robot 100 mm forward and turned by 90 degrees: (800, -450) is 450 mm to its right."""
    text = TEXT + "\n[locations]\nshelf = [900, 0, 130, 90, 90, 0]\n"
    found, told = laid("[lab.robot]\nat_mm = [100, 0]\nturn_deg = 90\n", text)
    assert found is not None, told
    assert found.body("can1").X_WO.translation[:2] == pytest.approx((-0.450, -0.700))
    assert found.locations["shelf"].translation == pytest.approx((0.0, -0.800, 0.130))
    assert found.body("floor").X_WO.translation[:2] == (0.0, 0.0)


def test_another_robot_leaves_nothing_of_the_scene_s() -> None:
    scene = TEXT.replace('name = "puma761"', 'name = "puma761"\ntool_xyzoat = [0, 0, 99, 0, 0, 0]')
    found, _ = laid('[lab.robot]\nname = "puma762"\n', scene)
    assert found is not None
    assert found.robot.arm.name == "puma762"
    assert found.X_FT == found.robot.gripper.X_FP
    kept, _ = laid("[lab.robot]\nlinear_mm_s = 300\n", scene)
    assert kept is not None
    assert kept.X_FT.translation == pytest.approx((0, 0, 0.099))


@pytest.mark.parametrize("code", ["V640", "V642", "V643"])
def test_example_of_a_page_triggers_its_code_alone(code: str) -> None:
    found, told = laid(example(code))
    assert found is None
    assert [d.rule.code for d in told] == [code]
    assert told[0].primary is not None
    assert told[0].primary.span.source.name == "lab.toml"


def test_a_table_of_which_the_scene_knows_nothing_is_a_warning() -> None:
    found, told = laid(example("V641"), 'title = "empty"\n')
    assert found is not None
    assert [d.rule.code for d in told] == ["V641"]


def test_two_labs_are_one_too_many() -> None:
    found, told = laid(example("V644"), TEXT + "\n[lab]\n")
    assert found is None
    assert [d.rule.code for d in told] == ["V644"]


@pytest.mark.parametrize(
    ("lab", "code", "text"),
    [
        ("[lab.robot]\nlower_dag = 3\n", "V602", "lower_dag"),
        ("[lab.gripper]\nopening_mm = [80, 0]\n", "V642", "[80, 0]"),
        ("[lab.gripper]\npad_mm = [30, 30]\n", "V642", "[30, 30]"),
        ("[lab.gripper]\nlength_mm = 105\n", "V642", "105"),
        ("[lab.gripper]\nlength_mm = -1\n", "V605", "-1"),
        ("[lab.table]\ntop_z = -310\n", "V602", "top_z"),
        ("[lab.arm]\n", "V602", "arm"),
        ("[lab\n", "V600", "\n"),
        ("", "V640", None),
    ],
)
def test_mistakes_are_told_where_they_are(lab: str, code: str, text: str | None) -> None:
    found, told = laid("# our lab\n" + lab)
    assert found is None
    assert [d.rule.code for d in told] == [code]
    label = told[0].primary
    assert (label is None) == (text is None)
    if label is not None and text is not None:
        assert label.span.source.name == "lab.toml"
        assert label.span.line == (2 if lab.startswith("[lab.arm") or code == "V600" else 3)
        assert label.span.text.startswith(text[:4])


def test_mistakes_of_the_scene_stay_in_the_scene() -> None:
    found, told = laid("[lab]\n", TEXT.replace('on = "table"', 'on = "tabel"', 1))
    assert found is None
    assert told[0].primary is not None
    assert told[0].primary.span.source.name == "cans-on-bases/scene.toml"


def test_what_is_wrong_in_a_scene_with_a_lab_alone_says_so() -> None:
    found, told = laid("[lab.table]\nsize_mm = [300, 300]\n")
    assert found is None
    assert {d.rule.code for d in told} == {"V614"}
    assert told[0].notes == ("with `lab.toml` laid over the scene",)


def test_a_scene_that_is_no_toml_is_not_mended_by_a_lab() -> None:
    found, told = laid('[lab]\n# """\n', 'title = """\n')
    assert found is None
    assert [d.rule.code for d in told] == ["V600"]
    assert told[0].primary is not None
    assert told[0].primary.span.source.name == "cans-on-bases/scene.toml"


def test_objects_still_say_where_they_stand_in_the_file() -> None:
    span = in_lab("[lab]\n").body("can2").span
    assert span is not None
    assert (span.source.name, span.text) == ("cans-on-bases/scene.toml", "can2")


def test_scene_and_lab_have_one_hash() -> None:
    assert PLAIN is not None
    first, again = in_lab("[lab]\n"), in_lab("[lab]\n")
    other = in_lab('[lab]\ntitle = "x"\n')
    assert first.digest == again.digest
    assert len({first.digest, other.digest, PLAIN.digest}) == 3


def test_a_lab_may_bring_the_description_of_its_robot(tmp_path: Path) -> None:
    arm = CHECKOUT / "scenes" / "one-can-urdf"
    text = (arm / "scene.toml").read_text()
    section = re.search(r"\[robot\]\n(.*?)\n\n", text, re.DOTALL)
    assert section is not None
    scene = text.replace(section[0], "")
    lab = f"[lab.robot]\n{section[1]}\n"
    found, told, _ = read_scene_in_lab(
        SourceFile("scene.toml", scene), SourceFile("lab.toml", lab), tmp_path, arm
    )
    assert found is not None, told
    assert "urdf" in section[1]


def test_a_lab_says_how_long_acceleration_and_corners_take() -> None:
    arm = in_lab("[lab.robot]\nacceleration_s = 0.28\nblend_s = 0.392\n").robot.arm
    assert (arm.acceleration_time, arm.blend_time) == (0.28, 0.392)


def test_corners_take_at_least_as_long_as_stopping() -> None:
    found, told = laid(example("V898"))
    assert found is None
    assert [d.rule.code for d in told] == ["V898"]
    assert told[0].primary is not None
    assert told[0].primary.text == "a corner takes 0.112 s, stopping 0.224 s"
