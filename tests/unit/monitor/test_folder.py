"""The monitor's files: nothing outside the working folder is read, written or removed."""

import os
from pathlib import Path

import pytest

from vrts.monitor.folder import MAX_BYTES, CannotUse, WorkingFolder


@pytest.fixture
def root(tmp_path: Path) -> Path:
    (tmp_path / "outside.v2").write_text("secret")
    inside = tmp_path / "work"
    inside.mkdir()
    (inside / "cell.v2").write_text(".PROGRAM main\n.END\n")
    (inside / "sub").mkdir()
    (inside / "sub" / "deep.v2").write_text("deep")
    return inside


@pytest.mark.parametrize(
    "name",
    [
        "../outside.v2",
        "sub/deep.v2",
        "sub\\deep.v2",
        "/etc/passwd",
        "..",
        ".hidden.v2",
        "a..v2",
        "",
        "c:x.v2",
        "x" * 200 + ".v2",
        "a\x00.v2",
        "a\n.v2",
        "sub",
    ],
)
def test_names_that_lead_elsewhere_are_refused(root: Path, name: str) -> None:
    folder = WorkingFolder(root)
    for act in (
        lambda: folder.read(name),
        lambda: folder.write(name, b"", replace=True),
        lambda: folder.delete(name),
    ):
        with pytest.raises(CannotUse):
            act()
    assert (root.parent / "outside.v2").read_text() == "secret"
    assert (root / "sub" / "deep.v2").read_text() == "deep"


@pytest.mark.parametrize("target", ["../outside.v2", "cell.v2", "nowhere.v2"])
def test_links_are_not_followed(root: Path, target: str) -> None:
    (root / "link.v2").symlink_to(target)
    folder = WorkingFolder(root)
    with pytest.raises(CannotUse):
        folder.read("link.v2")
    with pytest.raises(CannotUse):
        folder.write("link.v2", b"new", replace=True)
    with pytest.raises(CannotUse):
        folder.delete("link.v2")
    assert (root / "link.v2").is_symlink()
    assert "link.v2" not in [entry.name for entry in folder.entries()]
    assert (root.parent / "outside.v2").read_text() == "secret"


def test_a_pipe_is_no_file(root: Path) -> None:
    os.mkfifo(root / "pipe.v2")
    with pytest.raises(CannotUse):
        WorkingFolder(root).read("pipe.v2")


def test_nothing_is_overwritten_unasked(root: Path) -> None:
    folder = WorkingFolder(root)
    with pytest.raises(CannotUse) as refused:
        folder.write("cell.v2", b"new", replace=False)
    assert refused.value.words == "File already exists"
    assert folder.read("cell.v2").startswith(b".PROGRAM")
    folder.write("cell.v2", b"new", replace=True)
    assert folder.read("cell.v2") == b"new"


def test_large_files_are_refused(root: Path) -> None:
    (root / "large.v2").write_bytes(b"x" * (MAX_BYTES + 1))
    folder = WorkingFolder(root)
    with pytest.raises(CannotUse, match="4 MB"):
        folder.read("large.v2")
    with pytest.raises(CannotUse, match="4 MB"):
        folder.write("new.v2", b"x" * (MAX_BYTES + 1), replace=False)
    assert not folder.exists("new.v2")


@pytest.mark.parametrize("name", ["grade.py", "Makefile", "cell"])
def test_only_files_of_programs_are_written(root: Path, name: str) -> None:
    (root / name).write_text("mine")
    folder = WorkingFolder(root)
    with pytest.raises(CannotUse):
        folder.write(name, b"", replace=True)
    with pytest.raises(CannotUse):
        folder.delete(name)
    assert (root / name).read_text() == "mine"


def test_files_come_and_go(root: Path) -> None:
    folder = WorkingFolder(root)
    folder.write("two words.lc", b".LOCATIONS\n.END\n", replace=False)
    assert [e.name for e in folder.entries()] == ["cell.v2", "two words.lc"]
    folder.delete("cell.v2")
    assert not folder.exists("cell.v2")
    assert sorted(p.name for p in root.iterdir()) == ["sub", "two words.lc"]  # no drafts left
