"""Logs as they are given on the command line: files, and folders with bags of ROS 2."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from vrts.cli.shared.console import WRONG, fail, show_diagnostics

if TYPE_CHECKING:
    from vrts.validate.log.columns_file import ChosenColumns
    from vrts.validate.log.log import GivenLog

BAGS = (".mcap", ".db3")


def given_log(path: Path, columns: "ChosenColumns | None") -> "GivenLog":
    """Return the bytes of a log: of a file, or of all files of a bag in a folder."""
    from vrts.pipeline.files import read_bytes, shown
    from vrts.validate.log.log import GivenLog

    files = [path]
    if path.is_dir():
        files = sorted(file for file in path.iterdir() if file.suffix in BAGS and file.is_file())
        if not files:
            fail(f"`{path}` holds no bag of ROS 2", (f"a bag is {' or '.join(BAGS)} files",))
    return GivenLog(shown(path), tuple(read_bytes(file) for file in files), columns)


def given_columns(path: Path | None, color: str) -> "ChosenColumns | None":
    """Return what a file says of the columns of logs, or end where something is wrong in it."""
    if path is None:
        return None
    from vrts.base.source import SourceFile
    from vrts.pipeline.files import read_bytes, shown
    from vrts.validate.log.columns_file import ChosenColumns, read_columns

    text = read_bytes(path).decode("utf-8", "replace")
    found = read_columns(SourceFile(shown(path), text))
    if not isinstance(found, ChosenColumns):
        show_diagnostics(found, color)
        sys.exit(WRONG)
    return found
