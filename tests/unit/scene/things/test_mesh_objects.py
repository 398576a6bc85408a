"""Objects from meshes: read, stood up, gripped, set down, by their pieces alone."""

import hashlib
import json
from collections.abc import Mapping

import pytest

from tests.parts import u_pieces
from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import IDENTITY, translation
from vrts.base.source import SourceFile
from vrts.engine.hand.grip import between
from vrts.engine.hand.resting import Standing
from vrts.engine.hand.settle import settle
from vrts.geometry.shapes import Box, Piece
from vrts.geometry.support import bounds
from vrts.robots.arms.gripper import TWO_FINGERS
from vrts.scene.handling.mesh_grips import mesh_grips
from vrts.scene.model import Mobility, Scene
from vrts.scene.reading.scene_file import read_scene

FILE = "cradle.stl.pieces.json"
TEXT = """
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300

[objects.cradle]
kind = "mesh"
file = "cradle.stl"
unit = "mm"
at_mm = [850, -330]
on = "table"

[objects.base1]
kind = "base"
at_mm = [850, 330]
on = "table"
size_mm = [200, 200, 40]
"""


def read(
    text: str = TEXT, files: Mapping[str, bytes] | None = None
) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    given = {FILE: u_pieces()} if files is None else files
    return read_scene(SourceFile("scene.toml", text), files=given)


def scene(text: str = TEXT) -> Scene:
    found, diagnostics = read(text)
    assert found is not None, diagnostics
    return found


def codes(text: str, files: Mapping[str, bytes] | None = None) -> list[str]:
    return [d.rule.code for d in read(text, files)[1]]


def test_a_mesh_stands_on_its_support_by_its_pieces() -> None:
    body = scene().body("cradle")
    assert body.mobility is Mobility.MOVABLE
    assert body.rests_on == "table"
    box = bounds(body.pieces, IDENTITY)
    assert box.lower == pytest.approx((-0.06, -0.03, 0.0), abs=2e-6)
    assert box.upper == pytest.approx((0.06, 0.03, 0.08), abs=3e-6)
    assert body.centre_of_mass == pytest.approx((0.0, -0.008, 0.04), abs=2e-6)


@pytest.mark.parametrize(
    ("up", "size"),
    [
        ("z", (0.12, 0.06, 0.08)),
        ("-z", (0.12, 0.06, 0.08)),
        ("x", (0.06, 0.08, 0.12)),
        ("-x", (0.08, 0.06, 0.12)),
        ("y", (0.08, 0.12, 0.06)),
        ("-y", (0.12, 0.08, 0.06)),
    ],
)
def test_the_way_up_turns_it_without_mirroring(up: str, size: tuple[float, float, float]) -> None:
    text = TEXT.replace('unit = "mm"', f'unit = "mm"\nup = "{up}"\nfixed = true')
    box = bounds(scene(text).body("cradle").pieces, IDENTITY)
    assert box.upper[2] == pytest.approx(size[2], abs=3e-6)
    widths = tuple(b - a for a, b in zip(box.lower, box.upper, strict=True))
    assert widths == pytest.approx(size, abs=5e-6)


def test_the_run_depends_on_the_pieces_alone() -> None:
    one, two = scene(), read(files={FILE: u_pieces(sha256="0" * 64)})[0]
    assert set(one.files) == {FILE}
    assert two is not None
    assert one.digest != two.digest


def test_what_is_missing_or_does_not_fit_is_told() -> None:
    assert codes(TEXT, {}) == ["V899"]
    assert codes(TEXT, {FILE: b"{}"}) == ["V909"]
    assert codes(TEXT, {FILE: u_pieces(unit="inch")}) == ["V909"]
    assert codes(TEXT, {FILE: u_pieces(mesh="other.stl")}) == ["V909"]
    assert codes(TEXT.replace('unit = "mm"\n', "")) != []
    assert codes(TEXT.replace('"cradle.stl"', '"../cradle.stl"')) == ["V899"]
    assert codes(TEXT.replace("cradle.stl", "cradle.stl.pieces.json")) == ["V899"]


def test_a_part_that_stands_on_its_edge_topples() -> None:
    lone = TEXT.replace('unit = "mm"', 'unit = "mm"\nup = "y"')
    assert "V614" not in codes(lone)
    leaning = u_pieces().replace(
        b'"centre_of_mass_mm": [60.0, 22.0, 40.0]', b'"centre_of_mass_mm": [190.0, 22.0, 40.0]'
    )
    assert "V614" in codes(TEXT, {FILE: leaning})


def test_found_grips_hold_something_between_the_pads() -> None:
    body = scene().body("cradle")
    grips = mesh_grips(TWO_FINGERS, body)
    assert grips
    for X_OP in grips:
        held = between(TWO_FINGERS, body.pieces, X_OP.inverse())
        assert held is not None
        assert held.centred
        assert held.overlap >= TWO_FINGERS.overlap_min
        assert held.width < TWO_FINGERS.opening_max
    found = scene()
    assert "cradle_grip" in found.locations
    assert "base1_put" in found.locations


def test_a_grip_that_the_author_states_is_the_one() -> None:
    stated = TEXT.replace('unit = "mm"', 'unit = "mm"\ngrip = { at_mm = [50, 0, 50] }')
    place = scene(stated).locations["cradle_grip"]
    assert place.translation == pytest.approx((0.9, -0.33, -0.25), abs=1e-9)


def test_it_rests_on_several_pieces_at_once() -> None:
    """Upside down the U stands on its two arms, and its middle is above neither."""
    text = TEXT.replace('unit = "mm"', 'unit = "mm"\nup = "-y"')
    body = scene(text).body("cradle")
    floor = Standing("floor", (Piece(Box((1.0, 1.0, 0.05)), IDENTITY),), translation(0, 0, -0.05))
    rest = settle(body.pieces, translation(0, 0, 0.02), body.centre_of_mass, [floor])
    assert rest is not None
    assert rest.stands
    assert rest.height_m == pytest.approx(0.02, abs=2e-5)


def test_something_stands_across_the_arms_of_a_mesh() -> None:
    text = TEXT.replace('unit = "mm"', 'unit = "mm"\nup = "y"')
    body = scene(text).body("cradle")
    cradle = Standing("cradle", body.pieces, IDENTITY)
    bar = (Piece(Box((0.02, 0.07, 0.01)), IDENTITY),)
    rest = settle(bar, translation(0, 0, 0.1), (0.0, 0.0, 0.0), [cradle])
    assert rest is not None
    assert rest.stands
    assert rest.X_WO.translation[2] == pytest.approx(0.07, abs=5e-5)


def test_something_small_falls_between_the_arms() -> None:
    text = TEXT.replace('unit = "mm"', 'unit = "mm"\nup = "y"')
    cradle = Standing("cradle", scene(text).body("cradle").pieces, IDENTITY)
    bar = (Piece(Box((0.02, 0.02, 0.01)), IDENTITY),)
    rest = settle(bar, translation(0, 0, 0.1), (0.0, 0.0, 0.0), [cradle])
    assert rest is not None
    assert rest.stands
    assert rest.X_WO.translation[2] == pytest.approx(0.03, abs=5e-5)


def test_a_mesh_that_is_there_must_be_the_one_that_the_pieces_were_made_of() -> None:
    """A larger part, exported again, would be marked by the shape of before."""
    assert codes(TEXT, {FILE: u_pieces(), "cradle.stl": b"exported again"}) == ["V910"]
    mesh = b"as it was"
    told = json.loads(u_pieces())
    told["sha256"] = hashlib.sha256(mesh).hexdigest()
    pieces = {FILE: json.dumps(told).encode()}
    alone, _ = read(TEXT, pieces)
    beside, found = read(TEXT, {**pieces, "cradle.stl": mesh})
    assert found == ()
    assert alone is not None
    assert beside is not None
    assert (alone.digest, sorted(alone.files)) == (beside.digest, sorted(beside.files))
