"""What the manual's first page tells a newcomer to type works as it stands there."""

import re
from pathlib import Path

from tests.places import ROOT
from tests.unit.cli.test_commands import vrts

BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.M | re.S)
SHOWS = {"view"}  # commands that open a window


def test_the_first_page_can_be_typed(tmp_path: Path) -> None:
    page = (ROOT / "vrts" / "manual" / "index.md").read_text("utf-8")
    lines = [line for block in BLOCK.findall(page) for line in block.splitlines()]
    assert len(lines) >= 4
    here = tmp_path
    for line in lines:
        first, *words = line.split()
        if first == "cd":
            here /= words[0]
        elif words[0] in SHOWS:
            assert all((here / word).is_file() for word in words[1:]), line
            assert vrts(words[0], "--help").returncode == 0
        else:
            assert first == "vrts", line
            told = vrts(*words, cwd=here)
            assert told.returncode == 0, told.stderr.decode()
    assert b"10.0 / 10" in vrts("verify", "solution.v2", cwd=here).stdout
