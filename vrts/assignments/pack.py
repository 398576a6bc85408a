"""Tasks as zip files: one for students, one for the staff. The same content, the same bytes.

A zip that is read may come from anybody: names, kinds and sizes are checked before anything is
decompressed, and nothing is written outside a folder of our own.
"""

import re
from collections.abc import Mapping
from typing import NamedTuple

from vrts import __version__
from vrts.assignments.task_folder import TaskFiles
from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.zips import BadZip, Flaw, Unpacker, packed
from vrts.check.task.manifest import NAME as MANIFEST
from vrts.check.task.manifest import Manifest, altered, manifest_bytes, read_manifest, sha256
from vrts.pipeline.refused import Refused

BAD_ARCHIVE = Rule("V677", "bad-task-archive")

MODE = 0o644  # of members
MOST_FILES = 200
MOST_BYTES = 40_000_000  # of all files, decompressed
MOST_OF_ZIP = 40_000_000  # bytes of the zip itself
LONGEST_NAME = 160

_PART = r"[\w+-][\w+. -]*(?<![. ])"
_NAME = re.compile(rf"{_PART}(/{_PART})*")
_DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


class Bundle(NamedTuple):
    """A packed task."""

    manifest: Manifest
    files: Mapping[str, bytes]  # by name, without the manifest
    stamps: tuple[Diagnostic, ...]  # why its marks do not count


def student_zip(files: TaskFiles, hidden: int, versions: tuple[str, ...] = ()) -> bytes:
    """Return what students get: the public files, and how many checks are hidden."""
    return _zip(files, files.public, hidden, versions, staff=False)


def staff_zip(files: TaskFiles, hidden: int, versions: tuple[str, ...] = ()) -> bytes:
    """Return everything: what marks are given by."""
    return _zip(files, {**files.public, **files.staff}, hidden, versions, staff=True)


def _zip(
    files: TaskFiles,
    members: Mapping[str, bytes],
    hidden: int,
    versions: tuple[str, ...],
    *,
    staff: bool,
) -> bytes:
    hashes = {name: sha256(data) for name, data in members.items()}
    allowed = versions or (__version__,)
    manifest = Manifest(files.name, staff, hidden, allowed, files.scene, files.lab, hashes)
    contents = {MANIFEST: manifest_bytes(manifest), **members}
    _check({files.name: 0, **{name: len(data) for name, data in contents.items()}})
    return packed({f"{files.name}/{name}": contents[name] for name in sorted(contents)}, MODE)


def read_zip(data: bytes) -> Bundle:
    """Return a packed task.

    Raises:
        Refused: It is none, is damaged, or promises too much; the diagnostic says what.
    """
    if len(data) > MOST_OF_ZIP:
        raise _bad(f"it has more than {MOST_OF_ZIP:,} bytes")
    try:
        contents = _contents(Unpacker(data))
    except BadZip as problem:
        raise _flaw(problem) from problem
    manifest = read_manifest(contents.get(MANIFEST, b""))
    if manifest is None:
        raise _bad(f"its `{MANIFEST}` is missing, or is not as vrts writes it")
    stamps = altered(contents)
    strange = sorted(contents.keys() - manifest.files.keys() - {MANIFEST})
    if strange:
        raise _bad(f"its `{MANIFEST}` does not name `{strange[0]}`")
    del contents[MANIFEST]
    return Bundle(manifest, contents, stamps)


def _contents(archive: Unpacker) -> dict[str, bytes]:
    """Return the members by name, without the folder that holds them all."""
    files = {name: size for name, size in archive.sizes.items() if not name.endswith("/")}
    folders = {name.split("/", 1)[0] for name in files}
    if len(folders) != 1 or any("/" not in name for name in files):
        raise _bad("its files are not in one folder")
    folder = folders.pop()
    start = len(folder) + 1
    sizes = {name[start:]: size for name, size in files.items()}
    if len({name.casefold() for name in sizes}) != len(sizes):
        raise _bad("a file is in it twice")
    _check({**sizes, folder: 0})
    return {name: archive.read(f"{folder}/{name}") for name in sizes}


def _flaw(problem: BadZip) -> Refused:
    match problem.flaw:
        case Flaw.INCOMPLETE:
            return _bad("it is incomplete, or is no zip file")
        case Flaw.FOREIGN:
            return _bad("it is packed in a way that tasks are not")
        case Flaw.TWICE:
            return _bad("a file is in it twice")
        case Flaw.LENGTH:
            name = problem.member.split("/", 1)[-1]
            return _bad(f"`{name}` has another length than it says")


def _check(sizes: Mapping[str, int]) -> None:
    """Refuse names that lead elsewhere, and more than a task needs."""
    for name in sizes:
        parts = name.split("/")
        sound = _NAME.fullmatch(name) is not None and len(name) <= LONGEST_NAME
        if not sound or any(_DEVICE.fullmatch(part) for part in parts):
            raise _bad(f"`{name}` is no name of a file in a task")
    if len(sizes) > MOST_FILES:
        raise _bad(f"it has more than {MOST_FILES} files")
    if sum(sizes.values()) > MOST_BYTES:
        raise _bad(f"its files have more than {MOST_BYTES:,} bytes")


def _bad(why: str) -> Refused:
    headline = f"this is no task that vrts has packed: {why}"
    remedy = "get the file again from where it was handed out, or pack it with `vrts task pack`"
    return Refused((error(BAD_ARCHIVE, headline, help=(remedy,)),))
