"""Where scenes are looked for, so that no hand-in brings its own; and that `-` is for callers."""

import io
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.places import ROOT
from vrts.api.given import Given
from vrts.api.requests import run_request
from vrts.assignments.pack import Bundle, read_zip, student_zip
from vrts.assignments.packed import setting_of
from vrts.assignments.task_folder import TaskFiles
from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.pipeline import files
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.files import CannotRead, asked_scene, find_scene, read_bytes
from vrts.pipeline.refused import Refused
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import load_task, setting_for
from vrts.pipeline.where import Where

NAME = "cans-on-bases"
OWN = (  # what somebody made of it
    (ROOT / "scenes" / NAME / "scene.toml")
    .read_text("utf-8")
    .replace("at_mm = [950, -130]", "at_mm = [950, -230]")
).encode()
TASK = """[task]
scene = "{scene}"
[[goal]]
object = "can1"
on = "base2"
[time]
reference_s = 10.6
"""


@pytest.fixture(autouse=True)
def anna(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder that was handed in, with scenes in it; one stands beside it."""
    folder = tmp_path / "anna"
    for name in (NAME, "pallet"):
        (folder / name).mkdir(parents=True)
        (folder / name / "scene.toml").write_bytes(OWN)
    (folder / "p.v2").write_text(".PROGRAM p\n.END\n")
    monkeypatch.chdir(tmp_path)
    return folder


def same(one: str, other: str) -> bool:
    return load_scene(one).scene.digest == load_scene(other).scene.digest


def test_a_name_of_the_library_means_that_of_the_library(
    anna: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    library = load_scene(NAME).scene.digest
    for folder in (anna.parent, anna):
        monkeypatch.chdir(folder)
        found = setting_for(anna / "p.v2", Where(scene=NAME))
        assert found is not None
        assert found.scene.digest == library
        given = Given(ProgramFile(b"", "p.v2"), anna / "p.v2")
        ran = run_request(given, Where(scene=NAME), Reading(None))
        assert ran.setting.scene.digest == library
    assert not same(NAME, f"./{NAME}"), "a path is what it says"


def test_other_names_and_paths_are_of_the_working_folder_first(
    anna: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert asked_scene("pallet", Path("anna")) == Path("anna", "pallet", "scene.toml")
    (tmp_path / "pallet").mkdir()
    ours = tmp_path / "pallet" / "scene.toml"
    ours.write_text("")
    for name in ("pallet", "pallet/scene.toml", str(ours)):
        assert asked_scene(name, Path("anna")) == ours
    monkeypatch.chdir(anna)
    assert asked_scene("pallet", anna) == anna / "pallet" / "scene.toml"


def test_a_file_means_what_is_beside_it(anna: Path, tmp_path: Path) -> None:
    assert find_scene(NAME, anna) == anna / NAME / "scene.toml"
    assert find_scene(NAME, tmp_path) == asked_scene(NAME)


def test_another_scene_than_the_task_names_is_told_though_its_name_is_the_same(anna: Path) -> None:
    (anna / "task.toml").write_text(TASK.format(scene=NAME))
    assert load_task(anna).stamps == ()
    (stamp,) = load_task(anna, NAME).stamps
    assert stamp.headline == "modified scene: this mark does not count"


@pytest.mark.parametrize("name", ["-", "./-", "a\\u0000b"])
@pytest.mark.parametrize(
    "text",
    [
        TASK.format(scene="{name}"),
        TASK.format(scene=NAME).replace("[[goal]]", 'lab = "{name}"\n[[goal]]'),
        TASK.format(scene=NAME) + '[prove]\nenvironment = "{name}"\n',
    ],
    ids=["scene", "lab", "environment"],
)
def test_a_task_never_reads_what_is_typed(
    text: str, name: str, anna: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In its folder, where `-` is a file, too."""
    monkeypatch.chdir(anna)
    monkeypatch.setattr("sys.stdin", None)  # whoever reads it fails
    Path("-").write_bytes(OWN)
    Path("task.toml").write_text(text.format(name=name))
    for place in (Path("task.toml"), Path()):
        with pytest.raises(CannotRead, match=r"there is no scene|is no name of a file"):
            load_task(place)


def test_a_packed_task_has_no_scene_of_that_name(tmp_path: Path) -> None:
    public = {"task.toml": TASK.format(scene="-").encode(), "-": OWN}
    packed = student_zip(TaskFiles("lab", "-", public, {}, "", ""), 0)
    bundle: Bundle = read_zip(packed)
    with pytest.raises(Refused) as refused:
        setting_of(bundle)
    assert refused.value.diagnostics[0].rule.code == "V677"


def nothing(_event: str, _body: object) -> None:
    """Take an event."""


@pytest.mark.parametrize("name", ["scene", "task", "scenario", "lab"])
def test_a_debug_client_names_files(name: str) -> None:
    asked = Fields({"program": "p.v2", name: "-"})
    with pytest.raises(BadRequest, match="`-` is no name of a file"):
        Adapter(nothing).answer("launch", asked)
    with pytest.raises(BadRequest, match="`-` is no name of a file"):
        Adapter(nothing).answer("launch", Fields({"program": "p.v2", "with": ["-"]}))


def test_stdin_is_read_where_it_is_asked_for_and_never_without_an_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("sys.stdin", SimpleNamespace(buffer=io.BytesIO(b"1234")))
    assert read_bytes(Path("-")) == b"1234"
    monkeypatch.setattr(files, "MAX_STDIN", 3)
    monkeypatch.setattr("sys.stdin", SimpleNamespace(buffer=io.BytesIO(b"1234")))
    with pytest.raises(CannotRead, match="stdin is too large: more than 3 bytes"):
        read_bytes(Path("-"))
