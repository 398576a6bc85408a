"""Scenes from TOML: every fault is one diagnostic that points at its place."""

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source
from vrts.report.scene_drawing import scene_svg
from vrts.report.screen.scene_text import point_text, scene_text
from vrts.scene.block import location_block
from vrts.scene.handling.places import down_pose
from vrts.scene.model import Scene
from vrts.scene.reach import reach
from vrts.scene.reading.scene_file import read_scene
from vrts.scene.save import with_location

TEXT = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text()


def scene() -> Scene:
    found, diagnostics = read_scene(SourceFile("cans-on-bases/scene.toml", TEXT))
    assert diagnostics == ()
    assert found is not None
    return found


FAULTS = [
    ("radius_mm = 30", "radus_mm = 30", "V602", "radus_mm"),
    ('name = "puma761"', 'name = "puma999"', "V606", '"puma999"'),
    ("radius_mm = 30", 'radius_mm = "30"', "V604", '"30"'),
    ("radius_mm = 30", "radius_mm = -3", "V605", "-3"),
    ('on = "table"', 'on = "tabel"', "V616", '"tabel"'),
    ("[800, -450]", "[940, -130]", "V613", "can1"),
    ('color = "red"', 'color = "redd"', "V607", '"redd"'),
    ("[objects.can2]", "[objects.CAN1]", "V611", "CAN1"),
    ("[objects.can1]", "[objects.1can]", "V612", "1can"),
    ("at_mm = [800, -450]", "at_mm = [800, -450", "V600", ""),
]


@pytest.mark.parametrize(("before", "after", "code", "at"), FAULTS)
def test_a_fault_is_one_error_at_its_place(before: str, after: str, code: str, at: str) -> None:
    assert before in TEXT
    found, diagnostics = read_scene(SourceFile("scene.toml", TEXT.replace(before, after, 1)))
    errors = [d for d in diagnostics if d.is_error]
    assert found is None
    assert [d.rule.code for d in errors][:1] == [code]
    assert errors[0].primary is not None
    assert at.strip('"') in errors[0].primary.span.text or not at


def test_named_locations_are_reachable_with_a_margin() -> None:
    cans = scene()
    assert set(cans.locations) == {"can1_grip", "can2_grip", "base1_put", "base2_put", "safe"}
    for X_WT in cans.locations.values():
        best = reach(cans, X_WT).best
        assert best is not None
        assert best.margin.amount > 0.087  # 5 degrees
        assert X_WT.approach[2] == pytest.approx(-1)  # hand straight down


def test_the_block_compiles_to_the_same_poses() -> None:
    cans = scene()
    program = f".PROGRAM a\n MOVE safe\n.END\n{location_block(cans.locations)}"
    compiled = compile_source(SourceFile("a.v2", program))
    assert compiled.module is not None
    data = {datum.name: datum.value for datum in compiled.module.data}
    for name, X_WT in cans.locations.items():
        pose = data[name]
        assert pose[1] == pytest.approx(X_WT.translation, abs=1e-5)  # type: ignore[index]


def test_out_of_reach_says_by_how_much() -> None:
    cans = scene()
    far = down_pose(2000, 0, -200, 0)
    found = reach(cans, far)
    assert not found.reachable
    assert found.error is not None
    assert found.error[0] == "too far"
    assert "beyond reach" in point_text(cans, far, found)


def test_the_text_names_every_object_and_its_top() -> None:
    text = scene_text(scene())
    for name in ("table", "base1", "base2", "can1", "can2", "safe"):
        assert name in text
    assert "top at Z -150" in text
    assert ".LOCATIONS" in text


def test_the_drawing_shows_every_object_twice() -> None:
    svg = scene_svg(scene())
    for name in ("table", "base1", "can2", "can1_grip"):
        assert svg.count(f">{name}<") == 2
    assert svg.count('class="ring"') == 2


def test_saving_a_location_keeps_everything_else() -> None:
    text = ".PROGRAM a\n ; mine\n MOVE p\n.END\n.LOCATIONS\nq 1 2 3 90 90 0\n.END\n"
    changed = with_location(text, "p", down_pose(800, 0, -100, 0))
    assert isinstance(changed, str)
    assert changed.startswith(text.partition(".LOCATIONS")[0])
    assert "q 1 2 3 90 90 0" in changed
    again = with_location(changed, "p", down_pose(0, 0, 0, 0))
    assert not isinstance(again, str)
    assert again.rule.code == "V620"
