"""Which files are the submissions, and what each is called in results."""

import re
import unicodedata
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

SUFFIXES = (".v2", ".val", ".pg", ".txt")
SOLUTION = "solution.v2"
FOLDER = "submissions"
TASK_FILE = "task.toml"
LONGEST_ID = 100  # bytes
RESERVED = frozenset(  # names of devices on Windows, whatever their ending
    (
        "CON",
        "PRN",
        "AUX",
        "NUL",
        *(f"{device}{n}" for device in ("COM", "LPT") for n in "123456789"),
    )
)


class Submission(NamedTuple):
    """One program to mark."""

    identifier: str  # unique, safe for file names
    path: Path
    title: str  # as shown


def of_example(folder: Path) -> list[Submission]:
    """Return the solution of an example and every submission in it."""
    paths = [folder / SOLUTION] if (folder / SOLUTION).is_file() else []
    inside = folder / FOLDER
    if inside.is_dir():
        paths += sorted(path for path in inside.iterdir() if not path.name.startswith("."))
    return of_paths(paths)


def of_paths(paths: Iterable[Path]) -> list[Submission]:
    """Return files as submissions; of a folder, the files in it. Ids are unique."""
    found: list[Submission] = []
    taken: set[str] = set()
    for path in _files(paths):
        wanted = safe(path.stem)
        identifier, number = wanted, 2
        while identifier.casefold() in taken:
            identifier, number = f"{wanted}-{number}", number + 1
        taken.add(identifier.casefold())
        found.append(Submission(identifier, path, path.name))
    return found


def safe(name: str) -> str:
    """Return a name that is safe as a file name on every system.

    Letters of every script stay, with their marks; what is reserved on Windows gets a line.
    """
    plain = unicodedata.normalize("NFC", name)
    kept = re.sub(r"-+", "-", "".join(c if _harmless(c) else "-" for c in plain)).strip("-.")
    short = kept.encode()[:LONGEST_ID].decode(errors="ignore").strip("-.")
    if short.split(".")[0].upper() in RESERVED:
        short = f"_{short}"
    return short or "submission"


def _harmless(character: str) -> bool:
    return character in "_.-" or unicodedata.category(character)[0] in "LMN"


def _files(paths: Iterable[Path]) -> Iterable[Path]:
    for path in paths:
        if not path.is_dir():
            yield path
            continue
        inside = sorted(p for p in path.iterdir() if p.is_file() and not p.name.startswith("."))
        programs = [p for p in inside if p.suffix.lower() in SUFFIXES]
        yield from programs or inside
