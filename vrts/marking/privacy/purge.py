"""Deletes what a marking wrote about persons: by name what vrts writes, and nothing else.

How old a marking is, it says itself, from its begin on; dates of files tell when they were copied.
Links are not followed.
"""

import os
import shutil
import stat
from collections.abc import Iterator
from datetime import datetime, timedelta
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.marking import about
from vrts.marking.about import About
from vrts.marking.layout import (
    AGAIN_LOCK,
    COMPARED,
    DECISIONS,
    FORGETTING,
    STAFF,
    STAGING,
    STUDENTS,
    write_atomically,
)
from vrts.marking.privacy.plans import KEY, SHARDS, holds_plan
from vrts.marking.privacy.statistics_of_class import NAME as STATISTICS
from vrts.marking.privacy.statistics_of_class import statistics_of
from vrts.marking.privacy.statistics_of_class import to_bytes as statistics_to_bytes
from vrts.marking.result import Damaged
from vrts.marking.row import LARGEST, class_from_bytes
from vrts.pipeline.refused import Refused

NOT_OURS = Rule("V768", "not-written-by-marking")
A_LINK = Rule("V769", "link-in-the-way")

RESULTS = "results.json"
FOLDERS = (
    *(STUDENTS, f"{STAFF}/{STUDENTS}", f"{STAFF}/exports", f"{STAFF}/{STAGING}"),
    *(f"{STAFF}/{COMPARED}", f"{STAFF}/variants", f"{STAFF}/{DECISIONS}"),
)
FILES = (
    *(
        f"{STAFF}/{name}{end}"
        for name in (
            *("index.html", RESULTS, "marks.csv", "intake.csv", "overrides.toml"),
            *("names.csv", "pseudonyms.key", "similarity.html", "similarity.json"),
        )
        for end in ("", ".part")
    ),
    f"{STAFF}/{about.NAME}.part",
    *(f"{STAFF}/{name}" for name in (AGAIN_LOCK, ".writing.lock", ".renewing")),
    *(f"{STAFF}/{FORGETTING}{end}" for end in ("", ".part")),
)
MARKER = f"{STAFF}/{about.NAME}"  # deleted last: where it is, there may be more
LARGEST_ABOUT = 4_000_000  # bytes


class State(Enum):
    """What is to be done with a folder."""

    DUE = "due"
    YOUNG = "not old enough"
    PURGED = "purged before"


class Looked(NamedTuple):
    """What was found in the output of a marking; nothing has been changed."""

    folder: Path
    state: State
    about: About | None  # None: purged before
    age: timedelta
    files: int  # that are to be deleted
    size: int  # bytes
    left: tuple[str, ...]  # what vrts has not written, and which stays


def look(folder: Path, older_than: timedelta, now: datetime) -> Looked:
    """Return what is to be done with a folder.

    Raises:
        Refused: No marking was written there but perhaps a plan, or a link is in the way.
    """
    for part in ("", STAFF, *FOLDERS):
        if (folder / part).is_symlink():
            raise _link(folder / part)
    if not _is_file(folder / MARKER) and _is_file(folder / STAFF / STATISTICS):
        return Looked(folder, State.PURGED, None, timedelta(0), 0, 0, ())
    if not _is_file(folder / MARKER) and holds_plan(folder):
        raise _plan(folder)
    marked = _about(folder)
    age = now - marked.when
    state = State.DUE if age >= older_than else State.YOUNG
    sizes = [path.lstat().st_size for path in _all_files(folder)]
    return Looked(folder, state, marked, age, len(sizes), sum(sizes), tuple(_left(folder)))


def purge(looked: Looked, *, keep_statistics: bool) -> None:
    """Delete what is about persons.

    Args:
        looked: A folder that is due.
        keep_statistics: Whether to write marks without students first.

    Raises:
        Refused: There is nothing to make statistics of; nothing is deleted then.
    """
    folder = looked.folder
    assert looked.about is not None
    if keep_statistics:
        _write_statistics(folder, looked.about)
    else:
        (folder / STAFF / STATISTICS).unlink(missing_ok=True)
    for name in FOLDERS:
        if (folder / name).is_symlink():
            raise _link(folder / name)
        if (folder / name).is_dir():
            shutil.rmtree(folder / name)  # which deletes links, and does not follow them
    for name in (*FILES, MARKER):
        (folder / name).unlink(missing_ok=True)
    for place in (folder / STAFF, folder):
        if not any(place.iterdir()):
            place.rmdir()


def _write_statistics(folder: Path, marked: About) -> None:
    place = folder / STAFF / RESULTS
    try:
        if place.stat().st_size > LARGEST:
            raise _not_ours(folder, f"`{RESULTS}` is too large to make statistics of")
        rows = class_from_bytes(place.read_bytes())
    except (OSError, Damaged) as problem:
        why = f"there is no `{RESULTS}` to make statistics of"
        raise _not_ours(folder, why) from problem
    data = statistics_to_bytes(statistics_of(rows, marked))
    write_atomically(folder / STAFF / STATISTICS, data)


def _about(folder: Path) -> About:
    place = folder / MARKER
    if not _is_file(place) or place.lstat().st_size > LARGEST_ABOUT:
        raise _not_ours(folder, f"there is no `{MARKER}` in it")
    try:
        marked = about.from_bytes(place.read_bytes())
    except Damaged as problem:
        raise _not_ours(folder, f"its `{MARKER}` is not as vrts writes it") from problem
    if marked.when.tzinfo is None:
        raise _not_ours(folder, f"its `{MARKER}` does not tell when the marking was")
    return marked


def _all_files(folder: Path) -> Iterator[Path]:
    """Yield every file that is to be deleted; links are files."""
    for name in FOLDERS:
        for home, folders, files in os.walk(folder / name):
            links = [sub for sub in folders if (Path(home) / sub).is_symlink()]
            yield from (Path(home) / file for file in (*files, *links))
    yield from (folder / name for name in (*FILES, MARKER) if os.path.lexists(folder / name))


def _left(folder: Path) -> Iterator[str]:
    """Yield what stays, by its name in the folder."""
    ours = {*FOLDERS, *FILES, MARKER, STAFF, f"{STAFF}/{STATISTICS}"}
    for home in ("", STAFF):
        for path in sorted((folder / home).iterdir()):
            name = f"{home}/{path.name}".lstrip("/")
            if name not in ours:
                yield name


def _is_file(path: Path) -> bool:
    """Return whether there is a file, and not a link to one."""
    try:
        return stat.S_ISREG(path.lstat().st_mode)
    except OSError:
        return False


def _plan(folder: Path) -> Refused:
    headline = f"`{folder}` is a plan for marking on other machines: nothing is deleted"
    notes = (
        f"`{KEY}` and `{SHARDS}` hold the names and the programs of the class",
        "a plan does not say when it was made, so its age cannot be told",
    )
    remedy = "when its results are merged, delete the folder by hand, here and where it was sent"
    return Refused((error(NOT_OURS, headline, notes=notes, help=(remedy,)),))


def _not_ours(folder: Path, why: str) -> Refused:
    headline = f"`{folder}` is not the output of a marking: nothing is deleted"
    remedy = "name the folder that was given to `vrts grade` with `-o`"
    return Refused((error(NOT_OURS, headline, notes=(why,), help=(remedy,)),))


def _link(path: Path) -> Refused:
    headline = f"`{path}` is a link: nothing is deleted"
    remedy = "name the folder itself; delete by hand what a link leads to"
    return Refused((error(A_LINK, headline, help=(remedy,)),))
