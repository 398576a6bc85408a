"""Ctrl-C while something is counted."""

import os
from pathlib import Path

import pytest

from vrts.cli.shared.console import INTERRUPTED
from vrts.cli.shared.progress import Progress


def closed_twice(folder: Path) -> None:
    """Do what Python's `rmtree` does when Ctrl-C comes just behind its closing of a folder."""
    number = os.open(folder, os.O_RDONLY)
    try:
        os.close(number)
        raise KeyboardInterrupt
    finally:
        os.close(number)


def test_ctrl_c_while_a_folder_is_taken_away_is_still_ctrl_c(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    progress = Progress()
    progress.begin(3)
    with pytest.raises(SystemExit) as ended, progress.interruptible("nothing is kept"):
        closed_twice(tmp_path)
    assert ended.value.code == INTERRUPTED
    assert capsys.readouterr().err == "interrupted: 0 of 3 are marked; nothing is kept\n"


def test_another_problem_with_files_is_none(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), Progress().interruptible("nothing is kept"):
        os.close(os.open(tmp_path / "none", os.O_RDONLY))
