"""Plans for marking on other machines: they hold names, and no word of when they were made."""

import stat
from pathlib import Path

KEY, SHARDS = "key.json", "shards"  # as `marking.remote.plan` writes them
_BEGINNING = 400  # bytes in which a key says what it is
_SAYS = b'"schema": "vrts.plan/'


def holds_plan(folder: Path) -> bool:
    """Return whether a folder holds the key of a plan, and no link to one."""
    place = folder / KEY
    try:
        if folder.is_symlink() or not stat.S_ISREG(place.lstat().st_mode):
            return False
        with place.open("rb") as file:
            return _SAYS in file.read(_BEGINNING)
    except OSError:
        return False
