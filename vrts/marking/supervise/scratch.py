"""Folders for a while, where nobody has named one; what the dead have left is removed.

They stand in one folder of the user in the system's place for temporary files, each with its lock.
"""

import os
import tempfile
from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from vrts.marking.supervise.staging import remove_unused, staging_folder


@contextmanager
def scratch_folder() -> Generator[Path]:
    """Make a folder that is ours alone, and remove it in the end, with what dead processes left.

    Raises:
        OSError: It cannot be written.
    """
    home = _home()
    if home is None:  # somebody else has taken the name
        with tempfile.TemporaryDirectory(prefix="vrts-") as folder:
            yield Path(folder)
        return
    remove_unused(home)
    with staging_folder(home) as folder:
        yield folder


def _home() -> Path | None:
    """Return the folder of the user; None where it is not ours, or others may write into it."""
    own = f"vrts-of-{os.getuid()}" if hasattr(os, "getuid") else "vrts-of-user"
    home = Path(tempfile.gettempdir()) / own
    with suppress(FileExistsError):  # a file, or a link to nowhere: told below
        home.mkdir(mode=0o700, exist_ok=True)
    if not hasattr(os, "getuid"):
        return home
    found = home.lstat()
    private = found.st_uid == os.getuid() and found.st_mode & 0o077 == 0
    return home if private and home.is_dir() and not home.is_symlink() else None
