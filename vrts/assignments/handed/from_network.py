"""What in the files of an exam needs a network, where students are to work without one."""

import re
from collections.abc import Iterator
from pathlib import Path

from vrts.assignments.handed.readme import NAME
from vrts.base.diagnostic import Diagnostic, Label, Rule, warning
from vrts.base.source import SourceFile, Span
from vrts.check.task.task import Task
from vrts.pipeline.files import member_bytes, shown

NEEDS_NETWORK = Rule("V817", "exam-needs-network")

HANDOUT = "handout"  # the folder of further files for students
TEXTS = (".md", ".txt", ".html", ".htm", ".csv", ".v2", ".toml")
LARGEST = 1_000_000  # bytes of a file that is looked at
MOST = 20  # addresses that are told

_ADDRESS = re.compile(r"\b(?:https?|ftp)://[^\s<>\"')\]]+|\bwww\.[\w-]+\.[^\s<>\"')\]]+", re.I)
_NAMES_ONLY = re.compile(r"https?://www\.w3\.org/")  # of formats: nobody goes there


def network_findings(folder: Path, task: Task) -> tuple[Diagnostic, ...]:
    """Return a warning for each address in the files that students of an offline exam get.

    Args:
        folder: Of the task.
        task: Without its hidden part.
    """
    if not task.offline:
        return ()
    places = [folder / NAME, folder / "start.v2"]
    if (folder / HANDOUT).is_dir():
        places += sorted((folder / HANDOUT).rglob("*"))
    found = [one for place in places for one in _in_file(place)]
    return tuple(found[:MOST])


def _in_file(place: Path) -> Iterator[Diagnostic]:
    if not place.is_file() or place.suffix.lower() not in TEXTS:
        return
    text = member_bytes(place)[:LARGEST].decode(errors="replace").replace("\r\n", "\n")
    source = SourceFile(shown(place), text)
    for address in _ADDRESS.finditer(text):
        if _NAMES_ONLY.match(address[0]):
            continue
        yield warning(
            NEEDS_NETWORK,
            f"the exam is offline, and `{source.name}` names an address in the network",
            Label(Span(source, address.start(), address.end())),
            help=(
                "put what is there into the folder `handout`, or delete the address",
                "write `offline = false` in `[exam]` if students may use the network",
            ),
        )
