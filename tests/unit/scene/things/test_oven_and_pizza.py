"""An oven with its door open, and a pizza in its pan: shapes, and what can be done with them."""

from typing import cast

import pytest

from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY, Z_AXIS, Pose, rotate, translation
from vrts.base.source import SourceFile
from vrts.engine.hand.grip import between
from vrts.engine.hand.settle import Standing, settle
from vrts.geometry.support import bounds
from vrts.report.page.viewer_data import scene_data
from vrts.report.picture.solids import body_solids
from vrts.report.scene_drawing import scene_svg
from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.scene.clearance import Placed, clearance, placed_body
from vrts.scene.colors import hex_code
from vrts.scene.model import Mobility, Scene
from vrts.scene.reading.scene_file import read_scene
from vrts.scene.things.oven import Oven, oven
from vrts.scene.things.pizza import pizza
from vrts.scene.things.seat import seat

TEXT = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.oven]
kind = "oven"
at_mm = [1200, 30]
on = "table"
size_mm = [340, 360, 270]
color = "green"

[objects.pizza]
kind = "pizza"
at_mm = [960, -370]
on = "table"
radius_mm = 120

[locations]
pizza_grip = [775, -370, -268, 90, 60, 0]
"""
GREY = (0.5, 0.5, 0.5)
SIZE = Oven(0.34, 0.36, 0.27, 0.08)
RADIUS, HANDLE = 0.12, 0.1


def scene(text: str = TEXT) -> Scene:
    found, diagnostics = read_scene(SourceFile("scene.toml", text))
    assert diagnostics == ()
    assert found is not None
    return found


def refused(text: str) -> list[str]:
    found, diagnostics = read_scene(SourceFile("scene.toml", text))
    assert found is None
    return [d.rule.code for d in diagnostics]


def test_an_oven_is_as_large_as_asked_for_and_its_door_reaches_out_in_front() -> None:
    box = bounds(oven(SIZE, GREY).pieces, IDENTITY)
    assert box.lower == pytest.approx((-0.17 - SIZE.door, -0.18, 0.0))
    assert box.upper == pytest.approx((0.17, 0.18, 0.27))
    assert SIZE.mouth == pytest.approx(0.27 - 0.015 - 0.035 - 0.08)


def test_a_pizza_stands_on_the_stone_of_an_oven_without_touching_anything_else() -> None:
    X_WS = seat(scene().body("oven"))
    assert X_WS is not None
    assert X_WS.translation == pytest.approx((1.2, 0.03, -0.22))
    assert rotate(X_WS.rotation, Z_AXIS) == pytest.approx(Z_AXIS)
    body = scene().body("oven")
    lifted = Placed("pizza", pizza(RADIUS, HANDLE, GREY).pieces, translation(0.0, 0.0, 1e-3) @ X_WS)
    assert clearance(lifted, placed_body(body)) == pytest.approx(1e-3, abs=1e-5)
    form = pizza(RADIUS, HANDLE, GREY)
    rest = settle(
        form.pieces,
        translation(0.0, 0.0, 4e-3) @ X_WS,
        form.centre_of_mass,
        [Standing("oven", body.pieces, body.X_WO)],
    )
    assert rest is not None
    assert rest.stands
    assert rest.height_m == pytest.approx(4e-3, abs=2e-5)


def test_a_pizza_is_gripped_by_its_handle_and_not_by_its_edge() -> None:
    pieces = pizza(RADIUS, HANDLE, GREY).pieces
    leaning = rotation_from_oat(90.0, 60.0, 0.0)
    handle = between(TWO_FINGERS, pieces, Pose(leaning, (-0.185, 0.0, 0.032)).inverse())
    assert handle is not None
    assert handle.centred
    assert handle.width == pytest.approx(0.02, abs=1e-4)
    assert handle.overlap >= TWO_FINGERS.overlap_min
    edge = between(TWO_FINGERS, pieces, Pose(leaning, (0.0, 0.0, 0.01)).inverse())
    assert edge is not None
    assert edge.width > TWO_FINGERS.opening_max


def test_pizzas_can_be_carried_and_ovens_cannot() -> None:
    assert scene().body("pizza").mobility is Mobility.MOVABLE
    assert scene().body("oven").mobility is Mobility.FIXED


def test_pieces_have_colours_of_their_own_and_an_oven_the_one_it_is_given() -> None:
    setting = scene()
    body = setting.body("oven")
    assert len(body.painted) == len(body.pieces)
    assert body.color in body.paint
    solids = [solid for solid in body_solids(setting) if solid.group == "oven"]
    assert [solid.color for solid in solids] == list(dict.fromkeys(body.paint))
    table = setting.body("table")
    assert {color for _, color in table.painted} == {table.color}


def test_browser_and_drawing_show_the_colours_of_pieces() -> None:
    setting = scene()
    bodies = cast(list[dict[str, object]], scene_data(setting, None)["bodies"])
    drawn = next(body for body in bodies if body["name"] == "oven")
    pieces = cast(list[dict[str, object]], drawn["pieces"])
    shown = [piece.get("color", drawn["color"]) for piece in pieces]
    assert shown == [pytest.approx(color, abs=1e-4) for color in setting.body("oven").paint]
    table = next(body for body in bodies if body["name"] == "table")
    assert all("color" not in piece for piece in cast(list[dict[str, object]], table["pieces"]))
    svg = scene_svg(setting)
    for color in setting.body("pizza").paint:
        assert f'fill="{hex_code(color)}"' in svg


def test_an_oven_whose_mouth_is_too_low_is_refused_where_its_size_stands() -> None:
    text = TEXT.replace("size_mm = [340, 360, 270]", "size_mm = [340, 360, 175]")
    found, diagnostics = read_scene(SourceFile("scene.toml", text))
    assert found is None
    assert [d.rule.code for d in diagnostics] == ["V486"]
    assert diagnostics[0].primary is not None
    assert diagnostics[0].primary.span.text == "[340, 360, 175]"
    assert "45 mm" in diagnostics[0].primary.text


def test_measures_that_leave_no_room_for_hand_or_door_are_refused() -> None:
    assert refused(TEXT.replace('color = "green"', "stone_mm = 20")) == ["V605"]
    assert refused(TEXT.replace("radius_mm = 120", "radius_mm = 120\nhandle_mm = 30")) == ["V605"]
