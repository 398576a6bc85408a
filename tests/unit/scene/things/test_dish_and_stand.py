"""A dish and a tilted stand: their shapes, and what can be done with them."""

import math

import pytest

from vrts.base.pose import Z_AXIS, rotate, translation
from vrts.base.source import SourceFile
from vrts.base.units import DEG
from vrts.engine.hand.grip import between
from vrts.geometry.support import bounds
from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene
from vrts.scene.things.forms import dish, stand
from vrts.scene.things.seat import seat

TEXT = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.dish]
kind = "dish"
at_mm = [850, -330]
on = "table"
radius_mm = 110
height_mm = 45

[objects.stand]
kind = "stand"
at_mm = [980, 330]
on = "table"
size_mm = [280, 280]
height_mm = 120
slope_deg = 20

[locations]
dish_grip = [850, -227, -268, 90, 90, 0]
"""


def scene(text: str = TEXT) -> Scene:
    found, diagnostics = read_scene(SourceFile("scene.toml", text))
    assert diagnostics == ()
    assert found is not None
    return found


def test_a_dish_is_as_wide_and_high_as_asked_for_and_stands_on_its_foot() -> None:
    form = dish(0.11, 0.045, 0.005)
    box = bounds(form.pieces, translation(0.0, 0.0, 0.0))
    assert box.upper == pytest.approx((0.11, 0.11, 0.045), abs=1e-3)
    foot, *wall = form.pieces
    assert bounds((foot,), translation(0.0, 0.0, 0.0)).lower[2] == 0.0
    assert bounds(wall, translation(0.0, 0.0, 0.0)).lower[2] > 1e-3


def test_a_stand_is_lower_toward_minus_x() -> None:
    plate, *_ = stand(0.28, 0.28, 0.12, 0.016, 20 * DEG).pieces
    normal = rotate(plate.X_OP.rotation, Z_AXIS)
    assert normal == pytest.approx((-math.sin(20 * DEG), 0.0, math.cos(20 * DEG)))


def test_the_seat_of_a_stand_is_the_middle_of_its_plate() -> None:
    X_WS = seat(scene().body("stand"))
    assert X_WS is not None
    assert X_WS.translation == pytest.approx((0.98, 0.33, -0.18))
    assert seat(scene().body("table")) is None


def test_dishes_can_be_carried_and_stand_on_what_is_below() -> None:
    assert scene().body("dish").rests_on == "table"


def test_a_stand_whose_low_end_is_too_low_is_refused_where_its_height_stands() -> None:
    found, diagnostics = read_scene(
        SourceFile("scene.toml", TEXT.replace("height_mm = 120", "height_mm = 50"))
    )
    assert found is None
    assert [d.rule.code for d in diagnostics] == ["V485"]
    assert diagnostics[0].primary is not None
    assert diagnostics[0].primary.span.text == "50"


def test_the_wall_of_a_dish_is_gripped_though_the_dish_is_wider_than_the_hand() -> None:
    pieces = dish(0.11, 0.045, 0.005).pieces
    met = between(TWO_FINGERS, pieces, translation(0.0, -0.103, -0.032))
    assert met is not None
    assert met.centred
    assert met.width < 0.02
    assert met.overlap >= TWO_FINGERS.overlap_min
    assert between(TWO_FINGERS, pieces, translation(0.0, -0.25, -0.032)) is None


def test_a_dish_whose_place_for_the_hand_is_not_given_says_how_to_give_it() -> None:
    found, diagnostics = read_scene(SourceFile("scene.toml", TEXT.split("[locations]")[0]))
    assert found is not None
    (warning,) = diagnostics
    assert warning.rule.code == "V615"
    assert warning.help == (
        "write in `[locations]`, as `dish_grip`, where it is gripped by its wall",
    )
