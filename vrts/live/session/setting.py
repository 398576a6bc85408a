"""Scene and task of a session."""

import hashlib
from dataclasses import replace
from pathlib import Path

import msgspec

from vrts.base.diagnostic import error
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.variants.files import cut
from vrts.check.variants.section import SECTION, VALUES
from vrts.controllers.models import MODELS
from vrts.live.session.channel.messages import Start
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.controllers import under
from vrts.pipeline.files import read_toml_source
from vrts.pipeline.refused import Refused
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.report.page.viewer_data import scene_data
from vrts.scene.handling.withheld import withholding

UNTOLD = "the task has errors: `vrts task check` tells which"  # and nothing of its variants


def setting_of(start: Start) -> Setting:
    """Return what a session is about, read and found right.

    Raises:
        CannotRead: A file is not there.
        Refused: A file has errors.
    """
    found = _setting_of(start)
    known = start.controller in MODELS  # else whoever carries it on notices by the hash
    return under(found, start.controller) if known else found


def scene_sha256(setting: Setting) -> str:
    """Return the digest of a scene and task, as `Ready.scene` has them."""
    drawn = scene_data(setting.scene, setting.task)
    return hashlib.sha256(msgspec.json.encode(drawn)).hexdigest()


def has_variants(task: Path) -> bool:
    """Return whether a task, whatever else is wrong with it, has `[variants]`.

    Raises:
        CannotRead: It is not there.
    """
    source = read_toml_source(task)
    top, _ = read_toml(source)
    return SECTION in source.text if top is None else SECTION in top


def as_written(setting: Setting) -> Setting:
    """Return a task with `[variants]` as those have it who get it as it is written.

    Nothing of the variants is left in it, and what students are to find is withheld.
    """
    task = setting.task
    if task is None or task.variants is None:
        return setting
    sources, own = setting.sources, setting.sources.task
    if own is not None:
        sources = sources._replace(task=SourceFile(own.name, cut(own)))
    scene = withholding(setting.scene, task.variants.staff_names)
    return replace(setting, scene=scene, task=replace(task, variants=None), sources=sources)


def _setting_of(start: Start) -> Setting:
    lab = Path(start.lab) if start.lab else None
    if start.task:
        task = Path(start.task)
        try:
            return as_written(load_task(task, start.scene or None, lab=lab))
        except Refused as refused:
            if not has_variants(task):
                raise
            raise Refused((error(VALUES, UNTOLD),)) from refused  # words are shown in the room
    if start.scene:
        return load_scene(start.scene, lab=lab)
    return robot_alone()
