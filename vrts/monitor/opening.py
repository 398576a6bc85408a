"""A dialogue ready to begin: scene, controller, monitor, and files loaded."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.engine.controller import Controller
from vrts.ir.module import Module
from vrts.lang.dialect import DIALECTS
from vrts.lang.reading.decoding import decode
from vrts.monitor.desk import Desk
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.folder import WorkingFolder
from vrts.monitor.monitor import Monitor
from vrts.pipeline.files import read_bytes, shown
from vrts.pipeline.refused import Refused
from vrts.pipeline.scenes import free_setting
from vrts.pipeline.setting import scenario_of
from vrts.pipeline.where import Where
from vrts.scene.model import Limits

DAY = 86_400.0  # [s]
LIMITS = Limits(
    time_s=30 * DAY, statements=1_000_000_000, motions=10_000_000
)  # operators stay long


def opened(
    files: Sequence[str],
    where: Where,
    dialect: str,
    *,
    asks: bool,
    replace: bool = False,
    overwrite: bool = False,
) -> tuple[Dialogue, str]:
    """Return a dialogue, and what loading the files had to say.

    Args:
        files: Read first, from anywhere: the user named them.
        where: Scene, lab and scenario; without a scene the robot alone.
        dialect: Name of the dialect.
        asks: Whether the monitor asks before what cannot be undone.
        replace: Whether LOAD replaces programs.
        overwrite: Whether STORE replaces files unasked.

    Raises:
        CannotRead: A file, the scene, the lab or the scenario is not there.
        Refused: Scene or scenario have errors, or a file is no text.
    """
    beside = Path(files[0]).parent if files else None
    setting = free_setting(where, beside)
    desk = Desk(
        WorkingFolder(Path.cwd()),
        DIALECTS[dialect],
        asks=asks,
        overwrite=overwrite,
        replace=replace,
    )
    controller = Controller(
        Module({}, ()), setting.scene, dataclasses.replace(scenario_of(setting), limits=LIMITS)
    )
    dialogue = Dialogue(controller, Monitor(desk))
    said: list[str] = []
    for name in files:
        path = Path(name)
        source = decode(read_bytes(path), shown(path))
        if isinstance(source, Diagnostic):
            raise Refused((source,))
        said.append(dialogue.load(source))
    return dialogue, "".join(said)
