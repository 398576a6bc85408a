"""What a session reads before it begins: scene and task, and how they are drawn."""

from typing import NamedTuple

from vrts.live.session.channel.messages import Json, Start
from vrts.live.session.marks.checker import warm_up
from vrts.live.session.setting import setting_of
from vrts.pipeline.setting import Setting
from vrts.report.page.viewer_data import scene_data


class Known(NamedTuple):
    """Of one scene and task."""

    setting: Setting
    drawn: Json  # what the viewer draws


def read(start: Start) -> Known:
    """Read it, and prepare what checks of contacts need.

    Raises:
        CannotRead: A file is not there.
        Refused: A file has errors.
    """
    setting = setting_of(start)
    drawn = scene_data(setting.scene, setting.task)
    warm_up(setting)
    return Known(setting, drawn)
