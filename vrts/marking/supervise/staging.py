"""Folders for what processes are writing: each has a lock that ends with whoever uses it.

Beside a folder `NAME` stands the file `NAME.lock`; names begin with the machine, since on a share a
lock may tell nothing of others. The system lets go of the lock however a process
ends, so the next marking can tell what nobody uses any more, and removes it. Processes that were
forked have the lock, too: a folder is in use as long as one of them lives.
"""

import hashlib
import os
import platform
import secrets
import shutil
import sys
from collections.abc import Generator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

import psutil

LOCK = ".lock"
_MACHINE = Path("/etc/machine-id")


@contextmanager
def staging_folder(home: Path) -> Generator[Path]:
    """Make a folder of our own in a home of such folders, and remove it in the end.

    Raises:
        OSError: It cannot be written.
    """
    home = home.resolve()
    home.mkdir(parents=True, exist_ok=True)
    held, lock = _new_lock(home)
    folder = lock.with_suffix("")
    try:
        folder.mkdir()
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        if sys.platform == "win32":  # there nobody can remove what is open, not even we
            os.close(held)
            lock.unlink(missing_ok=True)
        else:
            lock.unlink(missing_ok=True)
            os.close(held)


def remove_unused(home: Path) -> None:
    """Remove the folders in a home that nobody uses: what was killed here has left them."""
    if not home.is_dir():
        return
    for lock in home.glob(f"{machine()}-*{LOCK}"):
        # whoever used it has just removed it, or it is another user's, who may use it
        with suppress(FileNotFoundError, PermissionError):
            _remove(lock)
    for folder in home.iterdir():  # an earlier vrts called them by its process, without a lock
        if folder.name.isdecimal() and not psutil.pid_exists(int(folder.name)):
            shutil.rmtree(folder, ignore_errors=True)


@cache
def machine() -> str:
    """Return what tells this machine from others that write into the same share."""
    number = ""
    with suppress(OSError):  # only Linux has one
        number = _MACHINE.read_text("utf-8", "replace")
    return hashlib.sha256(f"{platform.node()}\n{number}".encode()).hexdigest()[:12]


def _new_lock(home: Path) -> tuple[int, Path]:
    """Return a file that is new, locked where the file system knows locks."""
    while True:
        lock = home / f"{machine()}-{os.getpid()}-{secrets.token_hex(4)}{LOCK}"
        held = os.open(lock, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
        taken = locked(held)
        if taken is not False and _same(held, lock):
            return held, lock
        os.close(held)  # another marking takes it for a left one, and removes it


def _remove(lock: Path) -> None:
    folder = lock.with_suffix("")
    if sys.platform == "win32":
        with suppress(PermissionError):  # it is open: somebody uses it
            lock.unlink()
            shutil.rmtree(folder, ignore_errors=True)
        return
    found = os.open(lock, os.O_RDWR)
    try:
        if locked(found) and _same(found, lock):
            shutil.rmtree(folder, ignore_errors=True)
            lock.unlink(missing_ok=True)
    finally:
        os.close(found)


def locked(descriptor: int) -> bool | None:
    """Lock a file; return False where somebody else has, and None where there are no locks."""
    if sys.platform == "win32":
        return True
    import fcntl  # Windows has none

    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return None
    return True


def _same(descriptor: int, path: Path) -> bool:
    """Return whether a file still has its name."""
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False
