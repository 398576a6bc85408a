"""Packed tasks: what students get and what they do not, and zips that nobody should open."""

import io
import zipfile
from contextlib import suppress
from pathlib import Path

import pytest

from vrts import __version__
from vrts.assignments.pack import MOST_BYTES, read_zip, staff_zip, student_zip
from vrts.assignments.packed import load_zip, setting_of
from vrts.assignments.task_folder import TaskFiles, read_folder
from vrts.check.task import manifest as manifests
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.settings import load_task

SECRET = "behind the second base"
TASK = """[task]
scene = "cans-on-bases"
[[goal]]
object = "can1"
on = "base2"
[time]
reference_s = 10.6
"""
HIDDEN = f'[[via]]\nname = "{SECRET}"\nat_mm = [913, 37, 123]\nradius_mm = 417\n'
STAFF_VALUES = (SECRET, "913", "417", "Nobody may know", "solution")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the folder of a task with much in it that is nobody's business."""
    lab = tmp_path / "lab"
    for part in ("staff", "submissions", "pictures", ".git"):
        (lab / part).mkdir(parents=True)
    (lab / "task.toml").write_text(TASK)
    (lab / "README.md").write_text("# Lab\n")
    (lab / "start.v2").write_text(".PROGRAM main()\n.END\n")
    (lab / "pictures" / "world.svg").write_text("<svg/>")
    (lab / "staff" / "task.toml").write_text(HIDDEN)
    for private in ("staff/solution.v2", "solution.v2", "notes.md", "submissions/a.v2", ".git/x"):
        (lab / private).write_text("; Nobody may know: solution\n")
    return lab


def members(data: bytes) -> list[str]:
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return archive.namelist()


def zipped(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return buffer.getvalue()


def repacked(data: bytes, **changes: bytes) -> bytes:
    """Return a zip with other bytes in files, named by their last part with `_` for `.`."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    for key, new in changes.items():
        names = [name for name in files if name.rsplit("/", 1)[-1].replace(".", "_") == key]
        assert names, key
        files[names[0]] = new
    return zipped(files)


def refusal(data: bytes) -> str:
    with pytest.raises(Refused) as refused:
        read_zip(data)
    (finding,) = refused.value.diagnostics
    assert finding.rule.code == "V677"
    return finding.headline


def test_students_get_what_is_on_the_list_and_nothing_else(folder: Path) -> None:
    assert members(student_zip(read_folder(folder), 1)) == [
        "lab/README.md",
        "lab/cans-on-bases/scene.toml",
        "lab/manifest.json",
        "lab/pictures/world.svg",
        "lab/start.v2",
        "lab/task.toml",
    ]


def test_no_value_of_the_staff_is_in_what_students_get(folder: Path) -> None:
    data = student_zip(read_folder(folder), 1)
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist()}
    found = [
        (name, value) for name, text in texts.items() for value in STAFF_VALUES if value in text
    ]
    assert found == []
    assert '"hidden_checks": 1' in texts["lab/manifest.json"]


def test_the_same_task_gives_the_same_bytes(folder: Path) -> None:
    first = read_folder(folder)
    backwards = dict(reversed(list(first.public.items())))
    assert student_zip(first, 1) == student_zip(first._replace(public=backwards), 1)
    (folder / "start.v2").touch()
    assert staff_zip(first, 1) == staff_zip(read_folder(folder), 1)


def test_students_and_staff_mark_by_what_they_have(folder: Path, tmp_path: Path) -> None:
    files = read_folder(folder)
    (tmp_path / "s.zip").write_bytes(student_zip(files, 1))
    (tmp_path / "t.zip").write_bytes(staff_zip(files, 1))
    student, staff = load_zip(tmp_path / "s.zip"), load_zip(tmp_path / "t.zip")
    assert student.task is not None
    assert staff.task is not None
    assert (student.task.vias, student.more, student.hidden) == ((), 1, 0)
    assert ([via.name for via in staff.task.vias], staff.more, staff.hidden) == ([SECRET], 0, 1)
    public = load_zip(tmp_path / "t.zip", staff=False)
    assert public.task is not None
    assert (public.task.vias, public.task.digest) == ((), student.task.digest)
    assert student.stamps == staff.stamps == ()
    assert student.scene.digest == load_task(folder).scene.digest


def test_places_in_a_packed_task_name_no_folder_of_this_machine(folder: Path) -> None:
    setting = setting_of(read_zip(staff_zip(read_folder(folder), 1)))
    assert setting.task is not None
    spans = [setting.task.goals[0].span, setting.task.vias[0].span]
    names = [span.source.name for span in spans if span is not None]
    assert names == ["lab/task.toml", "lab/staff/task.toml"]


def test_a_changed_scene_or_task_is_stamped(folder: Path) -> None:
    data = student_zip(read_folder(folder), 1)
    scene = read_folder(folder).public["cans-on-bases/scene.toml"]
    moved = read_zip(repacked(data, scene_toml=scene.replace(b"[800, -450]", b"[810, -450]")))
    assert [d.headline for d in moved.stamps] == ["modified scene: this mark does not count"]
    longer = read_zip(repacked(data, task_toml=TASK.replace("10.6", "99").encode()))
    assert [d.rule.code for d in longer.stamps] == ["V672"]
    words = read_zip(repacked(data, README_md=b"# Notes of my own\n"))
    assert words.stamps == ()


def test_an_unpacked_task_is_stamped_when_its_scene_is_changed(
    folder: Path, tmp_path: Path
) -> None:
    with zipfile.ZipFile(io.BytesIO(student_zip(read_folder(folder), 3))) as archive:
        archive.extractall(tmp_path / "home")
    home = tmp_path / "home" / "lab"
    same = load_task(home)
    assert (same.stamps, same.more) == ((), 3)
    scene = home / "cans-on-bases" / "scene.toml"
    scene.write_text(scene.read_text().replace("[800, -450]", "[810, -450]"))
    assert [d.rule.code for d in load_task(home).stamps] == ["V671"]


def test_another_scene_than_the_task_s_is_stamped(folder: Path, tmp_path: Path) -> None:
    other = tmp_path / "other" / "scene.toml"
    other.parent.mkdir()
    text = read_folder(folder).public["cans-on-bases/scene.toml"].decode()
    other.write_text(text)
    assert load_task(folder, str(other)).stamps == (), "a copy is the same scene"
    other.write_text(text.replace("[800, -450]", "[810, -450]"))
    (stamp,) = load_task(folder, str(other)).stamps
    assert stamp.headline == "modified scene: this mark does not count"


def test_another_vrts_than_allowed_is_stamped(folder: Path) -> None:
    files = read_folder(folder)
    assert read_zip(student_zip(files, 1, ("9.9.9", __version__))).stamps == ()
    (stamp,) = read_zip(student_zip(files, 1, ("9.9.9",))).stamps
    assert stamp.headline == f"this is vrts {__version__}: this mark does not count"


@pytest.mark.parametrize(
    "name",
    [
        "../evil.toml",
        "a/../../evil.toml",
        "/etc/passwd",
        "C:/evil",
        "a\\b",
        "nul.txt",
        "a/.ssh",
        "a/x\n",
        "a/" + "x" * 200,
        "a/\u202egpj.exe",
    ],
)
def test_names_that_lead_elsewhere_are_refused(name: str, folder: Path) -> None:
    data = student_zip(read_folder(folder), 1)
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        files = {member: archive.read(member) for member in archive.namelist()}
    refusal(zipped({**files, f"lab/{name}": b"x"}))
    refusal(zipped({**files, name: b"x"}))


def test_a_zip_that_grows_is_refused_before_it_is_unpacked(folder: Path) -> None:
    files = {"lab/manifest.json": b"{}", "lab/README.md": bytes(MOST_BYTES)}
    assert "40,000,000 bytes" in refusal(zipped(files))


def test_a_size_that_is_a_lie_is_found_out(folder: Path) -> None:
    data = bytearray(zipped({"lab/manifest.json": bytes(100_000)}))
    at = data.rindex(b"PK\x01\x02") + 24  # uncompressed size, in the table of contents
    data[at : at + 4] = (10).to_bytes(4, "little")
    refusal(bytes(data))


def test_other_damage_is_told_in_one_sentence(folder: Path) -> None:
    good = student_zip(read_folder(folder), 1)
    assert "is no zip file" in refusal(b"")
    assert "is no zip file" in refusal(b"PK\x03\x04 and then nothing")
    assert "is no zip file" in refusal(good[: len(good) // 2])
    assert "not in one folder" in refusal(zipped({"a/x": b"", "b/y": b""}))
    assert "manifest.json" in refusal(zipped({"lab/task.toml": TASK.encode()}))
    assert "does not name" in refusal(
        repacked(
            good,
            manifest_json=b'{"schema": "vrts.task/1", "name": "x", "hidden_checks": 0,'
            b' "vrts": [], "scene": "s", "sha256": {}}',
        )
    )
    many = {f"lab/{number}": b"" for number in range(300)}
    assert "more than 200 files" in refusal(zipped(many))
    twice = zipped({"lab/a": b"1", "lab/b": b"2"}).replace(b"lab/b", b"lab/a")
    assert "twice" in refusal(twice)
    assert "twice" in refusal(zipped({"lab/a": b"1", "lab/A": b"2"}))


@pytest.mark.parametrize("cut", range(0, 2000, 97))
def test_a_byte_that_is_another_never_raises_anything_else(cut: int, folder: Path) -> None:
    data = bytearray(student_zip(read_folder(folder), 1))
    data[cut % len(data)] ^= 0x41
    with suppress(Refused, CannotRead):
        setting_of(read_zip(bytes(data)))


def test_a_packed_task_takes_no_scene_from_elsewhere(folder: Path) -> None:
    files = read_folder(folder)
    public = {"task.toml": TASK.encode(), "README.md": b""}
    alone = TaskFiles("lab", "task.toml", public, {})
    with pytest.raises(Refused) as refused:
        setting_of(read_zip(student_zip(alone, 0)))
    assert [d.rule.code for d in refused.value.diagnostics] == ["V677"]
    public["task.toml"] = TASK.replace("cans-on-bases", "../../../secret").encode()
    with pytest.raises(Refused):
        setting_of(read_zip(student_zip(alone, 0)))
    assert setting_of(read_zip(student_zip(files, 0))).task is not None


@pytest.mark.parametrize(
    "text", ["", "[]", "3", "{", '{"schema": "vrts.task/1"}', "[" * 100_000, '"\\ud800"']
)
def test_what_is_no_manifest_is_none(text: str) -> None:
    assert manifests.read_manifest(text.encode()) is None


def test_a_scene_in_the_hidden_folder_is_refused(folder: Path) -> None:
    scene = read_folder(folder).public["cans-on-bases/scene.toml"]
    (folder / "staff" / "scene.toml").write_bytes(scene)
    (folder / "task.toml").write_text(TASK.replace("cans-on-bases", "staff/scene.toml"))
    with pytest.raises(CannotRead, match="students do not get"):
        read_folder(folder)
