"""One server in a folder: a lock that ends with its process, however that ends."""

import errno
import fcntl
import os
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from vrts.pipeline.files import CannotRead

FILE: Final = "live.lock"  # in the server's folder; holds the number of the process
_TAKEN: Final = (errno.EWOULDBLOCK, errno.EAGAIN, errno.EACCES)
_NO_LOCKS: Final = (errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOSYS, errno.EINVAL)


@contextmanager
def held(folder: Path) -> Generator[None]:
    """Keep other servers out of a folder while something is done.

    A file that a dead server has left is no obstacle: the system let go of its lock.

    Raises:
        CannotRead: Another server has it, or the file system knows no locks.
        OSError: The file cannot be written.
    """
    descriptor = os.open(folder / FILE, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as problem:
            raise _refused(folder, descriptor, problem) from problem
        os.ftruncate(descriptor, 0)
        os.pwrite(descriptor, f"{os.getpid()}\n".encode(), 0)
        yield
        os.ftruncate(descriptor, 0)
    finally:
        os.close(descriptor)


def holder(folder: Path) -> int | None:
    """Return the process that serves from a folder; None: there is none, or it is not known."""
    try:
        descriptor = os.open(folder / FILE, os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return None
    except OSError:
        return _number(descriptor)
    finally:
        os.close(descriptor)


def _refused(folder: Path, descriptor: int, problem: OSError) -> Exception:
    if problem.errno in _TAKEN:
        number = _number(descriptor)
        who = "another server" if number is None else f"another server (process {number})"
        hint = "end that one first, or give this one a folder of its own with `--folder`"
        return CannotRead(f"{who} works in the folder `{folder}` already", (hint,))
    if problem.errno in _NO_LOCKS:
        text = f"the file system of `{folder}` knows no locks, so a second server could not be"
        hint = "choose a folder on a disk of this machine with `--folder`"
        return CannotRead(f"{text} kept out of it and would spoil what is kept", (hint,))
    return problem


def _number(descriptor: int) -> int | None:
    text = os.pread(descriptor, 20, 0).strip()
    return int(text) if text.isdigit() else None
