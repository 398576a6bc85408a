"""The folder of a session: what it keeps there, and what is left of it when it has ended."""

import shutil
from pathlib import Path
from typing import Final

FILE: Final = "history.bin"  # what is older than it remembers
ASLEEP: Final = "asleep.bin"  # the state of a room that is asleep
SHOWN: Final = "shown.json"  # beside it: what is shown of it meanwhile
OFF: Final = "history.off"  # beside it: nothing may be kept, because somebody was purged


def empty(folder: Path) -> None:
    """Remove what is left of a session that did not go on or goes on elsewhere, but its errors."""
    (folder / FILE).unlink(missing_ok=True)
    (folder / FILE).with_suffix(".part").unlink(missing_ok=True)
    for name in (ASLEEP, SHOWN):
        (folder / name).unlink(missing_ok=True)
    for place in folder.iterdir():
        if place.is_dir() and not place.is_symlink():
            shutil.rmtree(place, ignore_errors=True)  # its process may be about to end only
