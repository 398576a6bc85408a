"""Places that a scene withholds: nothing shows them, and what they are called is checked."""

import pytest

from tests.places import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.report.scene_drawing import scene_svg
from vrts.report.screen.scene_text import scene_text
from vrts.scene.handling.withheld import all_locations
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

CANS = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text("utf-8")
MINE = '\n[locations]\nmine = [900, 0, 100, 90, 90, 0]\nabove = { at = "can1_grip" }\n'


def read(withheld: str, more: str = "") -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    return read_scene(SourceFile("scene.toml", f"withheld = {withheld}\n{CANS}{more}"))


def test_what_is_withheld_is_shown_nowhere_and_may_be_followed() -> None:
    whole, _ = read_scene(SourceFile("scene.toml", f"{CANS}{MINE}"))
    scene, told = read('["CAN1_grip", "mine", "safe"]', MINE)
    assert told == ()
    assert whole is not None
    assert scene is not None
    gone = {"can1_grip", "mine", "safe"}
    assert set(scene.withheld) == gone
    assert dict(scene.locations) == {n: p for n, p in whole.locations.items() if n not in gone}
    assert scene.locations["above"] == whole.locations["can1_grip"]
    assert all_locations(scene) == whole.locations
    rows = [line.split()[0] for line in scene_text(scene).splitlines() if line]
    assert not gone & set(rows)
    assert "You find and teach yourself: can1_grip, mine, safe" in scene_text(scene)
    assert all(f">{name}<" not in scene_svg(scene) for name in gone)
    assert ">can2_grip<" in scene_svg(scene)


def test_a_place_that_vrts_works_out_in_other_variants_may_be_withheld() -> None:
    scene, told = read('"base1_put2"')
    assert told == ()
    assert scene is not None
    assert scene.withheld == {"base1_put2": None}


@pytest.mark.parametrize(
    ("text", "code", "help_"),
    [
        ('["can1_grib"]', "V606", "did you mean `can1_grip`?"),
        ('["can9_grip"]', "V606", None),
        ('["somewhere"]', "V606", "leave it out"),
        ('["safe", "safe"]', "V605", None),
        ("[]", "V605", None),
        ("true", "V604", None),
    ],
)
def test_what_withholds_nothing_is_told_at_its_place(
    text: str, code: str, help_: str | None
) -> None:
    scene, told = read(text)
    assert scene is None
    assert [d.rule.code for d in told] == [code]
    assert told[0].primary is not None
    assert told[0].primary.span.line == 1
    assert help_ is None or told[0].help == (help_,)
