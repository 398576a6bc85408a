"""What a student gets of a task with variants: the own numbers, and nothing of anybody else."""

import io
import shutil
import zipfile
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.assignments.new_files import new_program
from vrts.assignments.packed import load_zip
from vrts.assignments.suggested import suggested
from vrts.assignments.variants.handed_out import HandedOut, handed_out, pictures_of, tags_in
from vrts.assignments.variants.key import NAME, key_made, key_of, place_of_handed
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.assignments.variants.places import shown, taught, with_places
from vrts.check.variants.drawn import Variant, drawn
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.report.scene_drawing import scene_svg

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
KEY = b"k" * 32
HIDDEN = '[[via]]\nname = "secret"\nat_mm = [900, 20, 40]\nradius_mm = 300\n'


def copied(folder: Path) -> Path:
    lab = Path(shutil.copytree(LAB, folder / "lab1"))
    (lab / "staff").mkdir()
    (lab / "staff" / "task.toml").write_text(HIDDEN)
    (lab / "solution.v2").rename(lab / "staff" / "solution.v2")
    base = load_varied(lab).base.scene
    (lab / "pictures").mkdir()
    (lab / "pictures" / "scene.svg").write_text(scene_svg(base))
    (lab / "pictures" / "other.svg").write_text("<svg/>")
    key_made(lab / NAME)
    return lab


@pytest.fixture(scope="module")
def varied(tmp_path_factory: pytest.TempPathFactory) -> VariedTask:
    return load_varied(copied(tmp_path_factory.mktemp("varied")))


def given(varied: VariedTask, student: str) -> tuple[Variant, HandedOut, dict[str, str]]:
    variant = drawn(varied.variants, KEY, student)
    found = handed_out(varied, variant, pictures_of(varied))
    with zipfile.ZipFile(io.BytesIO(found.data)) as archive:
        files = {name: archive.read(name).decode() for name in archive.namelist()}
    return variant, found, {name.removeprefix("lab1/"): text for name, text in files.items()}


def test_what_to_type_names_a_file_that_the_student_has(tmp_path: Path) -> None:
    lab = copied(tmp_path)
    (lab / "README.md").write_text("# Lab\n\n    vrts grade lab1-student.zip mine.v2\n")
    (lab / "start.v2").write_text("; vrts grade old-student.zip start.v2\n.PROGRAM main()\n.END\n")
    _, _, files = given(load_varied(lab), "ada")
    assert "    vrts grade task.toml mine.v2\n" in files["README.md"]
    assert "; vrts grade task.toml start.v2\n" in files["start.v2"]
    assert not any("-student.zip" in text for text in files.values())


def test_a_student_gets_the_own_numbers_and_nothing_of_others(varied: VariedTask) -> None:
    variant, _, files = given(varied, "ada")
    values = varied.variants.values(variant.combination)
    scene = varied.setting(variant.combination).scene
    assert sorted(files) == [
        *("README.md", "manifest.json", "pictures/other.svg", "pictures/scene.svg"),
        *("pictures/your-scene.svg", "scene.toml", "start.v2", "task.toml"),
    ]
    x, y = values["can1_x"], values["can1_y"]
    assert f"| `can1`, the red can | {x} | {y} | -300 |" in files["README.md"]
    assert f"at_mm = [{x}, {y}]" in files["scene.toml"]
    on = values["goals"].split('"')[1]
    base = scene.body(on).X_WO.translation
    assert f"can1 on {on} (X {1000 * base[0]:g}, Y {1000 * base[1]:g}, " in files["README.md"]
    assert files["start.v2"].startswith(f"; variant {variant.tag}\n")
    assert tags_in(files["start.v2"].encode()) == (variant.tag,)
    assert taught(files["start.v2"].encode()) == {"safe": shown(scene.locations["safe"])}
    assert files["pictures/scene.svg"] == files["pictures/your-scene.svg"]
    assert files["pictures/scene.svg"] != scene_svg(varied.base.scene)
    for name, text in files.items():
        for secret in ("[variants", "staff_names", "can1_goal", "secret", KEY.decode()):
            assert secret not in text, name


def test_students_who_get_the_task_as_it_is_written_learn_of_no_variants(
    varied: VariedTask,
) -> None:
    files = varied.as_written()
    assert b"[objects.can1]" in files["scene.toml"]
    texts = {name: data for name, data in files.items() if not name.startswith("pictures/")}
    for name, data in texts.items():
        for secret in (b"[variants", b"staff_names", b"can1_goal", b"secret"):
            assert secret not in data, name


def test_what_a_student_gets_is_a_task_that_others_read(varied: VariedTask, tmp_path: Path) -> None:
    variant, found, _ = given(varied, "kurt")
    path = tmp_path / "own.zip"
    path.write_bytes(found.data)
    with pytest.raises(CannotRead, match="has no variants"):
        load_varied(path)
    own = load_zip(path)
    assert set(own.scene.locations) == {"safe"}
    assert set(suggested(own).locations) == {"safe"}
    assert "_grip   " not in new_program("vrts verify mine.v2", own.scene)
    program = varied.reference(variant.combination)
    assert program is not None
    a = assess(Request(ProgramFile(program, "r.v2"), varied.setting(variant.combination)))
    assert a.grade is not None
    assert (a.grade.mark, a.grade.ready) == (a.grade.total, True)


def test_values_of_a_programs_own_stay(varied: VariedTask) -> None:
    scene = varied.base.scene
    there = varied.setting(drawn(varied.variants, KEY, "ada").combination).scene
    safe, other = scene.locations["safe"], there.locations["safe"]
    line = "safe 900 20, 40.0 90 90 0 ; high\r\nmine 900 20 40 90 90 0\r\ncan1_grip 1 2 3 4 5 6\r\n"
    program = f"TYPE 'ä'\r\n.LOCATIONS\r\n{line}.END\r\n".encode("latin-1")
    moved = with_places(program, scene.locations, there.locations, {"can1_grip"})
    assert shown(safe) != shown(other)
    assert taught(moved) == {"safe": shown(other), "mine": (900, 20, 40, 90, 90, 0)}
    assert moved.startswith("TYPE 'ä'\r\n".encode("latin-1"))


def test_start_of_those_who_get_the_task_as_written_withholds_names_too(tmp_path: Path) -> None:
    lab = copied(tmp_path)
    start = lab / "start.v2"
    block = ".LOCATIONS\ncan1_goal 1 2 3 4 5 6\nmine 7 8 9 0 0 0\n.END\n"
    start.write_text(f".PROGRAM main()\n.END\n{block}")
    assert taught(load_varied(lab).as_written()["start.v2"]) == {"mine": (7, 8, 9, 0, 0, 0)}


def test_what_students_have_may_not_need_what_is_withheld(tmp_path: Path) -> None:
    lab = copied(tmp_path)
    with (lab / "scene.toml").open("a") as file:
        file.write('above = { at = "can1_goal", plus_mm = [0, 0, 50] }\n')
    varied = load_varied(lab)
    variant = varied.drawn(KEY, "ada")
    for ask in (
        varied.as_written,
        lambda: handed_out(varied, variant, pictures_of(varied)),
    ):
        with pytest.raises(Refused) as refused:
            ask()
        found = refused.value.diagnostics[0]
        assert "can1_goal" in str(found)
        assert (
            "so it is in the zips of students, in which `staff_names` are left out" in found.notes
        )


def test_too_few_combinations_for_a_draw_are_told(
    varied: VariedTask, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.check.variants.drawn.MOST_TRIES", 0)
    with pytest.raises(Refused) as refused:
        varied.drawn(KEY, "ada")
    assert refused.value.diagnostics[0].rule.code == "V867"


def test_a_key_that_is_gone_is_not_made_anew_once_variants_were_handed_out(tmp_path: Path) -> None:
    path = tmp_path / NAME
    place_of_handed(path).write_text("{}")
    with pytest.raises(Refused) as refused:
        key_made(path)
    assert "is gone, and variants were handed out by it" in refused.value.diagnostics[0].headline
    assert not path.exists()


def test_a_variant_that_is_no_sound_task_is_named(tmp_path: Path) -> None:
    lab = copied(tmp_path)
    text = (lab / "task.toml").read_text()
    (lab / "task.toml").write_text(text.replace("[980, -90]", "[1060, 190]"))  # as base2
    with pytest.raises(Refused) as refused:
        load_varied(lab).setting((0, 0, 0, 0, 4, 0, 0, 0))
    (found,) = refused.value.diagnostics
    assert "base1" in found.headline
    assert any("base1 = [1060, 190], base2 = [1060, 190]" in note for note in found.notes)


def test_hidden_scenes_are_refused_since_nothing_varies_in_them(tmp_path: Path) -> None:
    lab = copied(tmp_path)
    (lab / "staff" / "scenes").mkdir()
    shutil.copy(lab / "scene.toml", lab / "staff" / "scenes" / "other.toml")
    with pytest.raises(Refused) as refused:
        load_varied(lab)
    (found,) = refused.value.diagnostics
    assert found.rule.code == "V920"
    assert found.headline == "scenes in `staff/scenes` cannot vary, and the task has `[variants]`"
    assert found.primary is not None
    assert found.primary.span.text.startswith("[variants]")


def test_the_key_is_for_its_owner_and_is_never_taken_from_elsewhere(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with pytest.raises(CannotRead, match="there is no key"):
        key_of(path)
    key, made = key_made(path)
    assert (len(key), made, path.stat().st_mode & 0o777) == (32, True, 0o600)
    assert key_made(path) == (key, False)
    link = tmp_path / "link"
    link.symlink_to(path)
    for wrong in (link, tmp_path / "other"):
        if wrong is not link:
            wrong.write_text("secret\n")
        with pytest.raises(Refused) as refused:
            key_made(wrong)
        assert "is no key that vrts has written" in refused.value.diagnostics[0].headline
