"""Folders of sessions that are over: nothing of them stays but what tells of faults.

A folder that cannot be emptied stays, and holds up nothing: that is logged.
"""

import logging
import shutil
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Final

from vrts.live.session.growing.folder import empty

LEFT: Final = 4  # folders of a room's earlier sessions that stay
FAULTS: Final = 32  # folders of closed rooms that stay
BEFORE: Final = "before.jsonl"  # in a session's folder: what was done before it ended
_SAID: Final = "stderr.txt"
_log = logging.getLogger("vrts.live")


def empty_earlier(own: Path, room: str) -> None:
    """Remove files of the earlier sessions of a room: another one goes on, or has begun.

    Only the last of the folders stay, with what their sessions said on stderr.
    """
    earlier = [folder for folder in _of(own.parent, room) if folder != own]
    for folder in earlier:
        _empty(folder)
    for folder in earlier[:-LEFT]:
        shutil.rmtree(folder, ignore_errors=True)


def remove_closed(sessions: Path, room: str) -> None:
    """Remove the folders of a room that is closed, but the last ones that tell of faults."""
    told = [folder for folder in _of(sessions, room) if _tells(folder)]
    for folder in told[:-LEFT]:
        shutil.rmtree(folder, ignore_errors=True)


def remove_all_closed(sessions: Path, rooms: Iterable[str]) -> None:
    """Remove the folders of all rooms but some, before any session begins."""
    kept = frozenset(rooms)
    folders = [folder for folder in sessions.glob("*-*") if _room(folder) not in kept]
    told = [folder for folder in folders if _is_own(folder) and _tells(folder)]
    told.sort(key=_written)
    for folder in told[:-FAULTS]:
        shutil.rmtree(folder, ignore_errors=True)


def _of(sessions: Path, room: str) -> list[Path]:
    """Return the folders of a room, the earliest first."""
    return sorted(
        (folder for folder in sessions.glob(f"{room}-*") if _is_own(folder)),
        key=lambda folder: int(folder.name.rpartition("-")[2]),
    )


def _tells(folder: Path) -> bool:
    """Empty a folder, and remove it where nothing is left; return whether it tells of faults."""
    if not _empty(folder):
        return False
    said = folder / _SAID
    with suppress(OSError):  # somebody else removes it
        if said.is_file() and said.stat().st_size:
            return True
    shutil.rmtree(folder, ignore_errors=True)
    return False


def _empty(folder: Path) -> bool:
    """Empty a folder, if that can be done and nobody else does it; return whether it was."""
    try:
        empty(folder)
        (folder / BEFORE).unlink(missing_ok=True)
    except OSError as problem:
        _log.warning(f"a session's folder could not be emptied: {problem}")
        return False
    return True


def _written(folder: Path) -> float:
    """Return when a session said something last; 0: its folder is gone."""
    try:
        return (folder / _SAID).stat().st_mtime
    except OSError:
        return 0.0


def _room(folder: Path) -> str:
    return folder.name.rpartition("-")[0]


def _is_own(folder: Path) -> bool:
    """Return whether it is a folder that a server has made."""
    number = folder.name.rpartition("-")[2]
    return number.isdecimal() and folder.is_dir() and not folder.is_symlink()
