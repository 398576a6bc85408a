"""The program that students are given to begin with: who hands it in beside a program means that.

Many hand in the whole folder, with `start.v2` in it as they got it.
"""

import re
from pathlib import Path

from vrts.assignments.pack import read_zip
from vrts.assignments.packed import is_packed
from vrts.base.diagnostic import Diagnostic
from vrts.lang.reading.decoding import decode
from vrts.pipeline.files import member_bytes, read_bytes

START = "start.v2"
_PLACES = re.compile(r"^[ \t]*\.(?:LOCATIONS|TRANS)\b.*", re.MULTILINE | re.IGNORECASE | re.DOTALL)
_COMMENT = re.compile(r";[^\n]*")


def given_to_all(task: Path) -> frozenset[str]:
    """Return what `start.v2` of a task does, as `essence` tells; nothing where there is none.

    Args:
        task: `task.toml`, its folder, or a packed task.

    Raises:
        CannotRead: The task cannot be read.
        Refused: It is packed, and damaged.
    """
    if is_packed(task):
        data = read_zip(read_bytes(task)).files.get(START)
    else:
        path = (task if task.is_dir() else task.parent) / START
        data = member_bytes(path) if path.is_file() else None
    text = None if data is None else decode(data, START)
    if text is None or isinstance(text, Diagnostic):
        return frozenset()
    return frozenset({essence(text.text)})


def essence(text: str) -> str:
    """Return what a program does, without comments and given places: these differ in variants."""
    return " ".join(_COMMENT.sub("", _PLACES.sub("", text)).split()).casefold()
