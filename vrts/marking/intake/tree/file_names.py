"""What names of files tell: which are no hand-ins, which are copies, and which are unsafe."""

import re
import unicodedata
from collections.abc import Sequence
from pathlib import PurePosixPath

PROGRAM_SUFFIXES = (".v2", ".val", ".pg", ".as")
NOTES = frozenset({"readme", "license", "notes", "liesmich", "lisezmoi", "leeme"})  # stems
JUNK = frozenset({"thumbs.db", "desktop.ini", "ehthumbs.db", "icon\r", "$recycle.bin"})
JUNK_FOLDERS = frozenset({"__macosx", "__pycache__", "$recycle.bin", "node_modules"})

_COPY = re.compile(r"^(?P<stem>.*?) ?\((?P<number>[1-9]\d{0,3})\)$")
_CANVAS_COPY = re.compile(r"^(?P<stem>.+)-(?P<number>[1-9]\d?)$")
_CANVAS_PREFIX = re.compile(r".*?_\d+_\d+_|.*?anon_\w+?_\d+_")  # whose it is, and its number
_DRIVE = re.compile(r"^[A-Za-z]:")


def is_junk(name: str) -> bool:
    """Return whether a file is there because of an operating system or an editor."""
    parts = PurePosixPath(name).parts
    return any(_junk_folder(part) for part in parts[:-1]) or _junk_file(parts[-1] if parts else "")


def _junk_folder(part: str) -> bool:
    return part.casefold() in JUNK_FOLDERS or (part.startswith(".") and part not in (".", ".."))


def _junk_file(part: str) -> bool:
    hidden = part.startswith((".", "~$", "._")) and part not in (".", "..")
    return hidden or part.casefold() in JUNK or part.endswith("~")


def flaw_of(name: str) -> str:
    """Return why a name in an archive is not to be trusted, or ""."""
    if name.startswith("/") or _DRIVE.match(name):
        return "leads to a place of its own on the disk"
    if ".." in name.split("/"):
        return "leads out of the archive"
    if any(unicodedata.category(character) == "Cc" for character in name):
        return "has control characters in its name"
    return ""


def stem_of(name: str) -> str:
    """Return the name of a file without folder and endings: "pick" of `a/pick.v2.txt`."""
    base = PurePosixPath(name).name
    stem = PurePosixPath(base).stem
    while PurePosixPath(stem).suffix.lower() in (*PROGRAM_SUFFIXES, ".txt"):
        stem = PurePosixPath(stem).stem
    return stem or base


def is_program_name(name: str) -> bool:
    """Return whether a name ends as those of programs do: `.v2`, also `.v2.txt`, `.v2 (1)`."""
    base = PurePosixPath(name).name.casefold()
    endings = [_COPY.sub(r"\g<stem>", piece) for piece in base.split(".")[1:]]
    return any(f".{ending}" in PROGRAM_SUFFIXES for ending in endings[-2:])


def is_note(name: str) -> bool:
    """Return whether a file is named as what accompanies programs."""
    return stem_of(name).casefold() in NOTES and not is_program_name(name)


def copy_of(name: str, *, canvas: bool = False) -> tuple[str, int]:
    """Return the name without the number of a copy, and the number: 0 for the original.

    Systems write `pick (1).v2` or `pick(1).v2`; Canvas writes `pick-1.v2`.
    """
    path = PurePosixPath(name)
    if canvas:
        path = path.with_name(_CANVAS_PREFIX.sub("", path.name, count=1) or path.name)
    for pattern in (_COPY, _CANVAS_COPY) if canvas else (_COPY,):
        stem, dot, endings = path.name.partition(".")
        found = pattern.match(stem)
        if found is not None:
            return str(path.with_name(found["stem"] + dot + endings)), int(found["number"])
    return str(path), 0


def same_name(name: str) -> str:
    """Return what two names share that some system takes for one."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFC", name).casefold())


def clashes(names: Sequence[str]) -> tuple[str, str] | None:
    """Return two names that some system takes for one, or None."""
    seen: dict[str, str] = {}
    for name in names:
        key = same_name(name)
        if key in seen:
            return seen[key], name
        seen[key] = name
    return None
