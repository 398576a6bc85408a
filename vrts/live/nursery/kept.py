"""Scenes and tasks that are read already, as long as their files are what they were."""

import gc
import os
import sys
from collections import OrderedDict
from pathlib import Path
from typing import Any, Final, NamedTuple

from vrts.live.nursery.line import Order
from vrts.live.session.channel.messages import Start
from vrts.live.session.known import Known, read
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

MOST: Final = 8  # that are kept
MOST_READ: Final = 100  # in all: some of what was read stays in memory when it is given up
MOST_FILES: Final = 2_000  # in the folders of one, which are looked at for each session

_Seen = tuple[tuple[str, int, int, int], ...]


class _Kept(NamedTuple):
    known: Known
    folders: frozenset[str]  # of all files that it was read from
    seen: _Seen


class _Opened:
    """Hears which files are opened, while something is read."""

    def __init__(self) -> None:
        self.folders: set[str] | None = None
        sys.addaudithook(self._hear)

    def _hear(self, event: str, about: tuple[Any, ...]) -> None:
        if event == "open" and self.folders is not None and isinstance(about[0], str | Path):
            self.folders.add(os.path.dirname(os.path.abspath(about[0])))


class KeptScenes:
    """Keeps a few."""

    def __init__(self) -> None:
        """Begin with none."""
        self._opened = _Opened()
        self._kept: OrderedDict[tuple[str, ...], _Kept] = OrderedDict()
        self._read = 0

    def keep(self, order: Order) -> None:
        """Read a scene and task that a session has read before, and prepare what it needs."""
        if self._read >= MOST_READ or self.of(order) is not None:
            return
        self._read += 1
        self._opened.folders = set()
        try:
            known = read(
                Start(0, "", order.scene, order.task, order.lab, controller=order.controller)
            )
        except (CannotRead, Refused):  # its files are others since, as sessions will say
            return
        finally:
            folders, self._opened.folders = frozenset(self._opened.folders), None
        seen = _seen(folders)
        if seen is None:
            return
        self._kept[_key(order)] = _Kept(known, folders, seen)
        while len(self._kept) > MOST:
            self._kept.popitem(last=False)
        gc.collect()
        gc.freeze()

    def of(self, order: Order) -> Known | None:
        """Return what is kept; None: nothing, or its files are others since."""
        for key in (_key(order), (*_key(order)[:-1], "")):
            found = self._kept.get(key)
            if found is None:
                continue
            if _seen(found.folders) != found.seen:
                del self._kept[key]
            elif order.controller in ("", found.known.setting.scene.controller.name):
                self._kept.move_to_end(key)
                return found.known
        return None


def _key(order: Order) -> tuple[str, ...]:
    return (order.scene, order.task, order.lab, order.controller)


def _seen(folders: frozenset[str]) -> _Seen | None:
    """Return what tells whether files are others; None: there are too many to look at."""
    found: list[tuple[str, int, int, int]] = []
    try:
        for folder in sorted(folders):
            with os.scandir(folder) as entries:
                for entry in entries:
                    about = entry.stat()
                    changed = max(about.st_mtime_ns, about.st_ctime_ns)
                    found.append((entry.path, about.st_ino, about.st_size, changed))
                    if len(found) > MOST_FILES:
                        return None
    except OSError:  # it is gone, or being written
        return None
    return tuple(sorted(found))
