"""A task with a hidden check, and a small class."""

import shutil
from collections.abc import Mapping
from contextlib import AbstractContextManager, suppress
from pathlib import Path

import dask.config

from vrts.marking.marking import Entry
from vrts.marking.remote.backend import Scheduler
from vrts.marking.remote.dask_cluster import queue_cluster
from vrts.marking.result import Kind
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.refused import Refused

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
GOOD = (EXAMPLE / "solution.v2").read_bytes()
BAD = (EXAMPLE / "submissions" / "hits-base.v2").read_bytes()
TYPO = (EXAMPLE / "submissions" / "syntax-error.v2").read_bytes()
STRANGE = "\n".join(f"dear reader, line {k} is a letter" for k in range(40)).encode()
HIDDEN = '[[via]]\nname = "secretgate"\nat_mm = [612.34, 345.67, 123.45]\nradius_mm = 12\n'

CLASS = (
    Entry("Ünal-Ayşe_471108150815", 'Ayşe\'s <pick> & "place".v2', GOOD),
    Entry("smith-ben", "smith ben.v2", BAD),
    Entry("cara", "cara_homework.txt", TYPO),
    Entry("dora", "", None, Kind.MISSING, "nothing was handed in"),
    Entry("gina", "gina's photo.jpg", None, Kind.UNREADABLE, "`gina's photo.jpg` is a picture"),
    Entry("emil", "emil's letter.v2", STRANGE),
    Entry("fritz", "fritz.v2", b"\x00\x01\x02\xff not a program"),
)
NAMES = (
    "Ünal", "Ayşe", "471108150815", "smith", "ben.v2", "cara", "homework", "dora", "emil",
    "letter.v2", "fritz", "gina", "photo",
)  # fmt: skip


def task(folder: Path, *, hidden: bool = True) -> str:
    """Return the place of a copy of an example's task, with a hidden check."""
    shutil.copytree(EXAMPLE, folder)
    if hidden:
        (folder / "staff").mkdir()
        (folder / "staff" / "task.toml").write_text(HIDDEN)
    return str(folder / "task.toml")


def files(folder: Path) -> dict[str, bytes]:
    """Return the bytes of all files in a folder, by path."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def configured(scheduler: Scheduler, values: Mapping[str, object]) -> AbstractContextManager[None]:
    """Set what jobs of a queue get."""
    with suppress(Refused):
        queue_cluster(scheduler)  # nothing is set yet: this loads what is set by default
    named = {f"jobqueue.{scheduler.value}.{key}": value for key, value in values.items()}
    return dask.config.set(named)
