"""Whether a marking goes on in a folder: a lock that ends with the process that marks."""

import os
from pathlib import Path

from vrts.marking.layout import AGAIN_LOCK, Layout
from vrts.marking.supervise.staging import LOCK as STAGING_LOCK
from vrts.marking.supervise.staging import locked


def taken_for_marking(folder: Path) -> int | None:
    """Return a file that is locked as long as it, or a copy of it in a process, is open.

    None: somebody marks already, a desk or `vrts grade`.

    Raises:
        OSError: The folder cannot be written.
    """
    staff = Layout(folder).staff
    descriptor = os.open(staff / AGAIN_LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    if locked(descriptor) is not False and not _staging(folder):
        return descriptor
    os.close(descriptor)
    return None


def goes_on(folder: Path) -> bool:
    """Return whether a marking goes on: of a desk, or of `vrts grade`."""
    return _held(Layout(folder).staff / AGAIN_LOCK) or _staging(folder)


def _staging(folder: Path) -> bool:
    """Return whether a marking holds one of its folders of drafts."""
    staging = Layout(folder).staging
    return staging.is_dir() and any(_held(lock) for lock in staging.glob(f"*{STAGING_LOCK}"))


def _held(lock: Path) -> bool:
    try:
        descriptor = os.open(lock, os.O_RDWR | os.O_CLOEXEC)
    except OSError:
        return False
    try:
        return locked(descriptor) is False  # without locks nobody can tell
    finally:
        os.close(descriptor)
