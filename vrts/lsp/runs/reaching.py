"""Whether the arm reaches a location, in the scene of the task beside a program.

`python -m vrts.lsp.runs.reaching` answers questions, one a line, with a line of JSON each, so that
the server itself reads no scene and knows no arm. It ends where stdin ends.
"""

import json
import os
import sys
from pathlib import Path
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.lsp.channel.reach import reach_of
from vrts.lsp.documents.setting_files import Stamp, setting_stamp
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import setting_for
from vrts.report.screen.scene_text import point_text
from vrts.scene.reach import reach


class _Known(NamedTuple):
    stamp: Stamp
    setting: Setting | None


_settings: dict[str, _Known] = {}


def reach_text(path: str, X_WT: Pose) -> str:
    """Return whether and how the tool gets to a pose; nothing where no task says in which scene.

    Args:
        path: Of the program.
        X_WT: Pose of the tool in the world; translation in m.
    """
    setting = _setting(path)
    if setting is None:
        return ""
    found = point_text(setting.scene, X_WT, reach(setting.scene, X_WT))
    return found.split("\n\n")[0].partition("\n")[2]  # without the pose, and without other ways


def _setting(path: str) -> Setting | None:
    """Return the setting of a program, read again when one of its files has changed."""
    stamp = setting_stamp(path)
    folder = os.path.dirname(path)
    if not stamp:
        return None  # there is no task
    known = _settings.get(folder)
    if known is None or known.stamp != stamp:
        try:
            setting = setting_for(Path(path))
        except (CannotRead, Refused):
            setting = None  # the verification says what is wrong with the task
        known = _settings[folder] = _Known(stamp, setting)
    return known.setting


def main() -> None:
    """Answer one question after another."""
    outgoing, sys.stdout = sys.stdout.buffer, sys.stderr
    for line in sys.stdin.buffer:
        outgoing.write(json.dumps(reach_text(*reach_of(line))).encode() + b"\n")
        outgoing.flush()


if __name__ == "__main__":
    main()
