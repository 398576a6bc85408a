"""Whether the arm reaches a location, in the scene of the task beside a program."""

import os
from pathlib import Path
from threading import Lock
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.pipeline.files import CannotRead
from vrts.pipeline.settings import TASK_FILE, Refused, Setting, setting_for


class _Known(NamedTuple):
    modified_ns: int
    setting: Setting | None


_settings: dict[str, _Known] = {}
_lock = Lock()


def reach_text(path: str, X_WT: Pose) -> str:
    """Return whether and how the tool gets to a pose; nothing where no task says in which scene.

    Args:
        path: Of the program.
        X_WT: Pose of the tool in the world; translation in m.
    """
    setting = _setting(path)
    if setting is None:
        return ""
    from vrts.report.scene_text import point_text
    from vrts.scene.reach import reach

    found = point_text(setting.scene, X_WT, reach(setting.scene, X_WT))
    return found.split("\n\n")[0].partition("\n")[2]  # without the pose, and without other ways


def _setting(path: str) -> Setting | None:
    """Return the setting of a program, read again when its task has changed."""
    task = os.path.join(os.path.dirname(path), TASK_FILE)
    try:
        modified_ns = os.stat(task).st_mtime_ns
    except OSError:
        return None  # there is no task
    with _lock:
        known = _settings.get(task)
        if known is None or known.modified_ns != modified_ns:
            try:
                setting = setting_for(Path(path), scene=None, task=Path(task))
            except (CannotRead, Refused):
                setting = None  # `vrts verify` says what is wrong with the task
            known = _settings[task] = _Known(modified_ns, setting)
    return known.setting
