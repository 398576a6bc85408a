"""One desk adds at a time, so that what it looked at still holds when it has written."""

import errno
import fcntl
import os
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

LOCK: Final = ".desk.lock"  # in the folder of decisions; nothing is in it
_NO_LOCKS: Final = (errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOSYS, errno.EINVAL)


@contextmanager
def one_at_a_time(folder: Path) -> Generator[None]:
    """Hold the folder against other desks of this machine; they take moments.

    The system lets go of it however a process ends. On a file system that knows no locks, two desks
    may decide about one thing within a moment: then that is a conflict, which is shown.

    Raises:
        OSError: The folder cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        except OSError as problem:
            if problem.errno not in _NO_LOCKS:
                raise
        yield
    finally:
        os.close(descriptor)
