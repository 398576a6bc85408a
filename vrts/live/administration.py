"""What is done to a server's folder from the command line, while it runs or not."""

import contextlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from vrts.live.lasting.clock import wall
from vrts.live.lasting.folder_lock import held
from vrts.live.personal.purging import Forgotten, purge
from vrts.live.settings import DATABASE
from vrts.live.store import accepting, verifying
from vrts.live.store.database import backup
from vrts.live.store.verifying import Finding
from vrts.pipeline.files import CannotRead

LAST_BACKUP: Final = "last-backup.json"  # in the folder: when, and how large


def save_backup(folder: Path, target: Path) -> None:
    """Copy the database; the server may run meanwhile.

    Raises:
        CannotRead: The copy would take the place of the database.
    """
    if target.resolve() == (folder / DATABASE).resolve():
        raise CannotRead(f"`{target}` is the database itself", ("name another file",))
    backup(folder / DATABASE, target)
    note = {"at": wall(), "bytes": target.stat().st_size}
    with contextlib.suppress(PermissionError):  # who may only read the folder may copy it too
        (folder / LAST_BACKUP).write_text(json.dumps(note), "ascii")


def last_backup(folder: Path) -> tuple[float, int]:
    """Return when a folder's database was last copied, and how large that is; zeros: never."""
    try:
        note = json.loads((folder / LAST_BACKUP).read_text("ascii"))
        return float(note["at"]), int(note["bytes"])
    except (OSError, ValueError, TypeError, KeyError):
        return 0.0, 0  # none was made, or somebody changed the note: it says nothing then


def purge_user(
    folder: Path, name: str, key: Path | None = None, *, mentions: bool = False
) -> Forgotten:
    """Forget all accounts of a name and what they wrote, everywhere; a server may run meanwhile.

    Raises:
        CannotRead: There is no key of the logs that fits.
    """
    return purge(folder, name, key, mentions=mentions)


def verify_logs(folder: Path, key: Path | None = None) -> Iterator[Finding]:
    """Yield what is to be said of every room's log, and what is wrong with all of them.

    Raises:
        CannotRead: There is no key of the logs that fits.
    """
    return verifying.findings(folder / DATABASE, key)


def accept_logs(folder: Path, key: Path | None = None) -> list[str]:
    """Sign the logs as they are; return what did not fit.

    Raises:
        CannotRead: There is no key, and none can be made; or a server works in the folder.
    """
    with held(folder):
        return accepting.accept(folder / DATABASE, key, wall())
