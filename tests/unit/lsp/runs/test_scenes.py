"""Scenes and tasks as they are written: what is wrong with a buffer, and the scene to show."""

import json
from pathlib import Path

from tests.places import ROOT
from vrts.lsp.runs.scenes import looked_at

SCENE = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
TASK = ROOT / "examples" / "01-cans-on-bases" / "task.toml"


def test_a_scene_is_shown_as_its_buffer_has_it() -> None:
    text = SCENE.read_text().replace("at_mm = [800, -450]", "at_mm = [800, -400]")
    found = looked_at(str(SCENE), text)
    assert found["rows"] == []
    assert {"can1", "table"} <= set(found["bodies"])
    scene = json.loads(found["recording"])["scene"]
    place = next(body["X"] for body in scene["bodies"] if body["name"] == "can1")
    assert place[9:11] == [0.8, -0.4]


def test_faults_are_told_where_they_stand_and_nothing_is_shown() -> None:
    text = SCENE.read_text().replace('kind = "can" ', 'kind = "cna" ', 1)
    found = looked_at(str(SCENE), text)
    assert found["recording"] is None
    start, end, severity, code, message = found["rows"][0]
    assert text[start:end] == '"cna"'
    assert (severity, code[0]) == ("error", "V")
    assert "can" in message


def test_a_task_is_shown_in_its_scene_with_its_goals() -> None:
    text = TASK.read_text()
    found = looked_at(str(TASK), text)
    assert found["rows"] == []
    assert len(json.loads(found["recording"])["scene"]["goals"]) == 2
    wrong = looked_at(str(TASK), text.replace('on = "base2"', 'on = "base7"'))
    assert wrong["recording"] is None
    start, end = wrong["rows"][0][:2]
    assert text.replace("base2", "base7")[start:end] == '"base7"'
    lost = looked_at(str(TASK), text.replace('"cans-on-bases"', '"no-such-scene"'))
    assert "no-such-scene" in lost["rows"][0][4]


def test_files_of_other_kinds_are_read_too(tmp_path: Path) -> None:
    for name in ("lab", "scenario", "environment", "columns"):
        found = looked_at(str(tmp_path / f"{name}.toml"), "nosuch = \n")
        assert found["rows"], name
        assert found["recording"] is None


def test_columns_are_read_as_a_comparison_reads_them() -> None:
    text = 'time = "stamp [ms]"\njoints = ["a", "b", "c"]\n'
    (row,) = looked_at("columns.toml", text)["rows"]
    assert text[row[0] : row[1]].startswith('["a"')
    assert row[3] == "V896"
    position = 'time = "1 [ms]"\nposition = ["x [m]", "y [m]", "z [m]"]\n'
    assert looked_at("columns.toml", position)["rows"] == []
