"""Files that commands write."""

import os
from pathlib import Path

import pytest

from vrts.cli.shared.console import write_file


def test_a_file_is_replaced_and_no_draft_stays(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_bytes(b"earlier")
    write_file(file, b"later")
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"page.html": b"later"}


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    file, link = tmp_path / "page.html", tmp_path / "newest.html"
    file.write_bytes(b"earlier")
    link.symlink_to(file)
    write_file(link, b"later")
    assert link.is_symlink()
    assert file.read_bytes() == b"later"


def test_a_pipe_stays_a_pipe(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    end = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        write_file(pipe, b"through")
        assert os.read(end, 100) == b"through"
    finally:
        os.close(end)
    assert pipe.is_fifo()
    assert [path.name for path in tmp_path.iterdir()] == ["pipe"]


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(IsADirectoryError):
        write_file(tmp_path, b"nothing")


def test_what_cannot_be_written_is_called_by_its_own_name(tmp_path: Path) -> None:
    wanted = tmp_path / "nowhere" / "file"
    with pytest.raises(FileNotFoundError) as problem:
        write_file(wanted, b"something")
    assert problem.value.filename == str(wanted)
