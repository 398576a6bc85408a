"""Files that change on disk while buffers are open: looked at now and then, whatever the client."""

import asyncio
import os
from collections.abc import Callable, Iterable
from typing import TypeAlias

from vrts.lsp.documents.documents import file_stamps
from vrts.lsp.documents.setting_files import Stamp, setting_stamp

EVERY_S = 1.0

_Seen: TypeAlias = tuple[Stamp, Stamp]


class Watch:
    """What the files beside open buffers were like when they were looked at last."""

    def __init__(self) -> None:
        self._seen: dict[str, _Seen] = {}

    def changed(self, folders: Iterable[str]) -> list[str]:
        """Return the folders in which something has changed since the last look."""
        before, self._seen = self._seen, {folder: _look(folder) for folder in folders}
        return [f for f, seen in self._seen.items() if before.get(f, seen) != seen]


async def watch(folders: Callable[[], set[str]], changed: Callable[[str], None]) -> None:
    """Tell for ever which folders have changed.

    Args:
        folders: Return what is to be looked at.
        changed: Called with a folder.
    """
    seen = Watch()
    while True:
        wanted = folders()
        for folder in await asyncio.to_thread(seen.changed, wanted):
            changed(folder)
        await asyncio.sleep(EVERY_S)


def _look(folder: str) -> _Seen:
    """Return the program files of a folder and the files of its setting, as they are now."""
    return file_stamps(folder), setting_stamp(os.path.join(folder, "any"))
