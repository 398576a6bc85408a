"""What a built site was made of, so that nothing is built again as long as that is the same."""

import hashlib
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path

NOTE = "made-of.txt"  # beside the built pages, written when all else is there
MAN = "man"  # a folder within `built`
FIRST = "index.html"
_FOLDERS = ("vrts", "examples", "tests/spec")
_SUFFIXES = {".py", ".pyi", ".md", ".css", ".js", ".toml", ".lark", ".png", ".svg", ".json"}
_OURS = {"built", "man", "vendor", "__pycache__"}  # folders that are not looked into
TOOLS = ("sphinx", "furo", "myst-parser", "pygments", "docutils", "click", "lark", "msgspec")


def made_of(root: Path) -> str:
    """Return a digest of every text and every tool that the manual is built from."""
    digest = hashlib.sha256()
    for tool in TOOLS:
        digest.update(f"{tool} {version(tool)}\n".encode())
    for path in _inputs(root):
        digest.update(f"{path.relative_to(root).as_posix()}\n".encode())
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def is_made_of(built: Path, digest: str) -> bool:
    """Return whether a folder holds all of what was built from these texts."""
    note = built / NOTE
    whole = note.is_file() and (built / FIRST).is_file() and (built / MAN).is_dir()
    return whole and note.read_text("utf-8").partition("\n")[0] == digest


def faults_of(built: Path) -> str:
    """Return what Sphinx had against the pages, a line each."""
    return (built / NOTE).read_text("utf-8").partition("\n")[2]


def note_down(built: Path, digest: str, faults: str) -> None:
    """Write down what a site was made of, and its faults."""
    (built / NOTE).write_text(f"{digest}\n{faults}", "utf-8")


def _inputs(root: Path) -> Iterator[Path]:
    for folder in _FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in _SUFFIXES and not _OURS & set(path.relative_to(root).parts):
                yield path
