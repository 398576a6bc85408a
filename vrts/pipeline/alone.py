"""The setting of a robot alone; no file is needed for it."""

from vrts.pipeline.setting import Setting
from vrts.scene.default import robot_alone as scene_of_robot


def robot_alone() -> Setting:
    """Return the scene of a robot by itself."""
    return Setting(scene_of_robot(), None, ())
