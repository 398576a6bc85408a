"""Every reason why a mark is unsafe, by a real marking that has it and no other."""

import io
import shutil
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from tests.unit.marking import proven_task
from vrts.assignments.pack import staff_zip, student_zip
from vrts.assignments.task_folder import read_folder
from vrts.base.zips import packed
from vrts.marking.class_plan import merged_class, plan_class
from vrts.marking.layout import Layout
from vrts.marking.submission import one
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.supervise.limits import Limits
from vrts.marking.supervise.supervisor import CAN_FORK
from vrts.marking.unsafe import Reason
from vrts.marking.whole_class import HowTo, Marked, mark_whole_class
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
GOOD = (EXAMPLE / "solution.v2").read_bytes()
HIDDEN = '[[via]]\nname = "gate"\nat_mm = [612, 345, 123]\nradius_mm = 12\n'
LATE = "\n[late]\ndue = 2026-11-30T23:00:00+01:00\nper_day = 1\n"
PLAIN = Wanted(pages=False)


def task(folder: Path, *, late: bool = False, hidden: bool = False) -> Path:
    """Write a copy of an example's task."""
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("submissions"))
    path = folder / "task.toml"
    if late:
        text = path.read_text("utf-8")
        head, mark, rest = text.partition("\n[[")
        path.write_text(f"{head}\n{LATE}{mark}{rest}", "utf-8")
    if hidden:
        (folder / "staff").mkdir(exist_ok=True)
        (folder / "staff" / "task.toml").write_text(HIDDEN)
    return folder


def changed(data: bytes, ending: str, change: Callable[[bytes], bytes]) -> bytes:
    """Return a packed task after a change of one of its files."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    (name,) = (name for name in files if name.endswith(ending))
    return packed({**files, name: change(files[name])}, 0o644)


def reasons(
    place: Path, tmp_path: Path, wanted: Wanted = PLAIN, files: Mapping[str, bytes] | None = None
) -> list[Reason]:
    """Mark one hand-in, and return why its mark is unsafe."""
    download = tmp_path / "download"
    for name, data in (files or {"anna.v2": GOOD}).items():
        (download / name).parent.mkdir(parents=True, exist_ok=True)
        (download / name).write_bytes(data)
    marker = Marker(Place(str(place)), wanted)
    (row,) = mark_whole_class(marker, download, None, HowTo()).rows.rows
    return list(dict.fromkeys(doubt.reason for doubt in row.unsafe))


def zip_of(path: Path, data: bytes) -> Path:
    path.write_bytes(data)
    return path


@pytest.mark.thorough
def test_each_reason_comes_from_a_marking_that_has_it(tmp_path: Path) -> None:
    plain = task(tmp_path / "plain")
    late, hidden = task(tmp_path / "late", late=True), task(tmp_path / "hidden", hidden=True)
    whole = staff_zip(read_folder(plain), 0)
    scene = changed(whole, "/scene.toml", lambda data: data + b"\n# a remark\n")
    asked = changed(whole, "/task.toml", lambda data: data + b"\n# a remark\n")
    other = staff_zip(read_folder(plain), 0, ("9.9.9",))
    public = student_zip(read_folder(hidden), 1)
    asks = proven_task.TASK.replace("hidden = true", "hidden = true\nstates = 2")
    proven = proven_task.written(tmp_path / "proven", asks)
    two = {"anna/a.v2": GOOD, "anna/b.v2": GOOD + b"; another\n"}
    found = {
        "safe": reasons(zip_of(tmp_path / "whole.zip", whole), tmp_path / "1"),
        "safe with hidden checks": reasons(hidden, tmp_path / "2"),
        "scene": reasons(zip_of(tmp_path / "scene.zip", scene), tmp_path / "3"),
        "task": reasons(zip_of(tmp_path / "asked.zip", asked), tmp_path / "4"),
        "version": reasons(zip_of(tmp_path / "other.zip", other), tmp_path / "5"),
        "student's zip": reasons(zip_of(tmp_path / "public.zip", public), tmp_path / "6"),
        "late": reasons(late, tmp_path / "7"),
        "proof": reasons(proven, tmp_path / "10", files={"a.v2": proven_task.GOOD.encode()}),
        "two files": reasons(plain, tmp_path / "8", files=two),
        "collisions": reasons(plain, tmp_path / "9", Wanted(pages=False, collisions=False)),
    }
    assert found == {
        "safe": [],
        "safe with hidden checks": [],
        "scene": [Reason.ALTERED],
        "task": [Reason.ALTERED],
        "version": [Reason.VERSION],
        "student's zip": [Reason.HIDDEN],
        "late": [Reason.LATE],
        "proof": [Reason.UNDETERMINED],
        "two files": [Reason.AMBIGUOUS],
        "collisions": [Reason.UNCHECKED],
    }


@pytest.mark.thorough
@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_what_fails_here_is_no_zero(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*_: object) -> None:
        raise ZeroDivisionError

    with monkeypatch.context() as patched:
        patched.setattr(one.mark, "__defaults__", (one.ALONE, failing))
        assert reasons(EXAMPLE / "task.toml", tmp_path / "1") == [Reason.CRASHED]
    monkeypatch.setattr(Marker, "limits", Limits(wall_s=0.001))
    assert reasons(EXAMPLE / "task.toml", tmp_path / "2") == [Reason.RESOURCE]


def codes(marked: Marked) -> list[str]:
    return [warning.rule.code for warning in marked.warnings]


def doubts(marked: Marked) -> list[list[str]]:
    """Return the reasons of all rows, in an order that pseudonyms do not change."""
    return sorted([doubt.reason.value for doubt in row.unsafe] for row in marked.rows.rows)


@pytest.mark.thorough
def test_a_canvas_class_is_as_safe_here_elsewhere_and_without_names(tmp_path: Path) -> None:
    names = ("bergeranna_31_901_pick.v2", "wolfben_32_902_pick.v2", "mailed.v2")
    download = tmp_path / "download"
    download.mkdir()
    for name in names:
        (download / name).write_bytes(GOOD)
    marker = Marker(Place(str(task(tmp_path / "late", late=True))), PLAIN)
    layout = Layout(tmp_path / "out")
    here = mark_whole_class(marker, download, layout, HowTo())
    assert (doubts(here), codes(here)) == ([[], []], ["V756"])
    planned = plan_class(marker, download, 1, HowTo())
    assert [warning.rule.code for warning in planned.warnings] == ["V756"]
    assert planned.plan.key.home is not None
    merged = merged_class(marker, planned.plan.key.home, layout)
    assert (merged.rows, codes(merged)) == (here.rows, ["V756"])

    table = tmp_path / "table.csv"  # Ben's file came by mail
    table.write_text(layout.intake.read_text("utf-8-sig").replace(names[1], names[2]), "utf-8")
    for how in (HowTo(table=table), HowTo(table=table, pseudonyms=True)):
        again = mark_whole_class(marker, download, Layout(tmp_path / f"{how.pseudonyms}"), how)
        assert (doubts(again), codes(again)) == ([[], ["late"]], ["V756"])
