"""A server whose verifications announce themselves: each says its number before it begins."""

import os
import select
import stat
import sys
from pathlib import Path

import psutil

from tests.support_lsp import PATIENCE

ANNOUNCES = """#!/bin/sh
echo $$ > {pipe}
exec {python} "$@"
"""
SERVES = """
import sys
sys.executable = {python!r}
from vrts.cli.main import vrts
vrts(["lsp"])
"""


class Begun:
    """What to start a server with, and the processes that it begins."""

    def __init__(self, folder: Path) -> None:
        """Make a pipe and an interpreter that writes to it in a folder of their own."""
        folder.mkdir()
        pipe, python = folder / "pipe", folder / "python"
        os.mkfifo(pipe)
        self._pipe = os.open(pipe, os.O_RDWR)  # both, so that it has no end between two writers
        python.write_text(ANNOUNCES.format(pipe=pipe, python=sys.executable))
        python.chmod(stat.S_IRWXU)
        self.server = ("-c", SERVES.format(python=str(python)))

    def __enter__(self) -> "Begun":
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self._pipe)

    def next(self) -> psutil.Process:
        """Return the process that was begun next, as soon as it is there."""
        line = b""
        while not line.endswith(b"\n"):
            assert select.select([self._pipe], [], [], PATIENCE)[0], "nothing was begun"
            line += os.read(self._pipe, 1)
        return psutil.Process(int(line))
