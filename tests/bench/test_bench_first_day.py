"""The path of somebody new, from a wheel to an assignment of their own, with real processes.

`python -m pytest tests/bench/test_bench_first_day.py -s -p no:xdist` prints the seconds of the
machine for each stage, and how many commands were typed. The files that are written on the way are
those of the lessons' texts. How long people read and write is not measured: the lessons say how
many minutes they are made for. Dependencies are there already; `.ci/wheels` installs them, too.
"""

import re
import shutil
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from tests.support_wheel import Installed, installed

FILE = re.compile(
    r"^<!-- file: (?P<name>\S+)(?: above (?P<kept>\S+))? -->\n```\w+\n(?P<body>.*?)^```$",
    re.M | re.S,
)


class Stage(NamedTuple):
    """A part of the path."""

    title: str
    seconds: float
    typed: int


class Walk:
    """Types commands of an installed vrts, and counts them."""

    def __init__(self, here: Installed, folder: Path) -> None:
        self.here, self.folder = here, folder
        self.typed = 0

    def vrts(self, command: str, *allowed: int, says: str = "") -> str:
        """Type a command; it has to answer with one of some statuses, 0 as usual."""
        self.typed += 1
        said = self.here.run(command.split(), self.folder)
        assert said.returncode in (allowed or (0,)), f"{command}\n{said.stdout}{said.stderr}"
        assert says in said.stdout + said.stderr, f"{command}\n{said.stdout}{said.stderr}"
        return said.stdout


def first_mark(walk: Walk) -> None:
    walk.vrts("", says="vrts learn 1")
    walk.vrts("learn")
    answer = walk.vrts("grade 01-cans-on-bases -o out")
    assert re.search(r"^ *7\.0 +hits-base", answer, re.M)


def first_own_program(walk: Walk) -> None:
    walk.vrts("learn 1 -o first")
    walk.folder /= "first"
    walk.vrts("new program first.v2 --from cans-on-bases")
    walk.vrts("point cans-on-bases 900 0 0 --down --save mine first.v2")
    mine = walk.folder / "mine.v2"
    for block in FILE.finditer((walk.folder / "README.md").read_text("utf-8")):
        text = block["body"]
        if block["kept"]:
            rest = mine.read_text("utf-8")
            text += rest[rest.index(block["kept"]) :]
        mine.write_text(text, "utf-8")
        walk.vrts("verify mine.v2", 0, 1)
        walk.vrts("learn next", 1)
    walk.vrts("verify mine.v2", says="10.0 / 10")
    walk.vrts("learn next", 1, says="8 of 10 steps done")


def first_debugged_fault(walk: Walk) -> None:
    shutil.copy(walk.folder / "submissions" / "hits-base.v2", walk.folder / "mended.v2")
    chain = walk.vrts("why mended.v2", 1)
    assert "hits `base1`" in chain
    line = re.search(r"line (\d+) `DEPARTS 40`", chain)
    assert line is not None, "the chain leads back to the step that lifts too little"
    walk.vrts("run mended.v2 --at 4.87", says="APPROS base2_put, 60")
    mended = walk.folder / "mended.v2"
    text = mended.read_text("utf-8").splitlines(keepends=True)
    text[int(line[1]) - 1] = text[int(line[1]) - 1].replace("DEPARTS 40", "DEPARTS 200")
    mended.write_text(
        "".join(text).replace("APPROS base2_put, 60", "APPRO base2_put, 120"), "utf-8"
    )
    walk.vrts("verify mended.v2", says="ready for the real robot: yes")
    walk.vrts("grade . -o out")
    walk.vrts("learn next", says="All steps are done")


def first_own_assignment(walk: Walk) -> None:
    walk.folder = walk.folder.parent
    walk.vrts("new task lab1")
    walk.vrts("task check lab1", says="ready to be handed out")
    walk.vrts("task pack lab1")
    shutil.copy(walk.folder / "lab1" / "staff" / "solution.v2", walk.folder / "anna.v2")
    walk.vrts("grade lab1-student.zip anna.v2", says="10.0")
    walk.vrts("grade lab1-staff.zip anna.v2 -o marks", says="10.0")


STAGES: tuple[tuple[str, Callable[[Walk], None]], ...] = (
    ("first mark", first_mark),
    ("first own program, 10.0", first_own_program),
    ("first debugged fault", first_debugged_fault),
    ("first own assignment", first_own_assignment),
)


def test_somebody_new_gets_from_a_wheel_to_an_assignment(tmp_path: Path) -> None:
    begun = time.monotonic()
    walk = Walk(installed(), tmp_path)
    found = [Stage("wheel built and installed", time.monotonic() - begun, 0)]
    for title, stage in STAGES:
        begun, before = time.monotonic(), walk.typed
        stage(walk)
        found.append(Stage(title, time.monotonic() - begun, walk.typed - before))
    print("\nstage                        seconds   commands")
    for one in (*found, Stage("together", sum(s.seconds for s in found), walk.typed)):
        print(f"{one.title:28} {one.seconds:7.1f}   {one.typed:8}")
