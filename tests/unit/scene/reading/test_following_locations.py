"""Places of a scene that follow others, wherever those come from."""

import pytest

from tests.places import ROOT
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.units import mm
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

CANS = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text("utf-8")


def read(locations: str, scene: str = CANS) -> tuple[Scene | None, tuple[Diagnostic, ...]]:
    return read_scene(SourceFile("scene.toml", f"{scene}\n[locations]\n{locations}\n"))


def test_a_place_follows_another_one_also_where_that_is_worked_out() -> None:
    text = 'Goal = { at = "base2_put" }\nabove = { at = "goal", plus_mm = [0, 10, 50] }\n'
    for scene, x in ((CANS, 1100), (CANS.replace("[1100, 230]", "[1050, 230]"), 1050)):
        found, told = read(f"{text}mine = [900, 0, 100, 90, 90, 0]", scene)
        assert told == ()
        assert found is not None
        goal, above = found.locations["goal"], found.locations["above"]
        assert goal == found.locations["base2_put"]
        assert above.rotation == goal.rotation
        assert [round(mm(value)) for value in goal.translation] == [x, 230, -125]
        assert [round(mm(value)) for value in above.translation] == [x, 240, -75]
        assert "mine" in found.locations


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('goal = { at = "base9_put" }', "V606"),
        ('goal = { at = "above" }\nabove = { at = "base2_put" }', "V606"),  # only those before it
        ("goal = { plus_mm = [0, 0, 1] }", "V603"),
        ('goal = { at = "base2_put", plus = 3 }', "V602"),
        ('goal = { at = "base2_put", plus_mm = [0, 0] }', "V604"),
        ('1goal = { at = "base2_put" }', "V612"),
        ('goal = { at = "base2_put", plus_mm = [0, 0, 3000] }', "V619"),  # a warning
    ],
)
def test_what_is_wrong_is_told_at_its_place(text: str, code: str) -> None:
    _, told = read(text)
    assert [d.rule.code for d in told] == [code]
    assert told[0].primary is not None
