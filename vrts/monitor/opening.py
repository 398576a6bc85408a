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
from vrts.pipeline.settings import Refused, load_scene, robot_alone, with_scenario
from vrts.scene.model import Limits, Scenario

DAY = 86_400.0  # [s]
LIMITS = Limits(
    time_s=30 * DAY, statements=1_000_000_000, motions=10_000_000
)  # operators stay long


def opened(
    files: Sequence[str],
    scene: str | None,
    dialect: str,
    *,
    asks: bool,
    lab: Path | None = None,
    scenario: Path | None = None,
    replace: bool = False,
    overwrite: bool = False,
) -> tuple[Dialogue, str]:
    """Return a dialogue, and what loading the files had to say.

    Args:
        files: Read first, from anywhere: the user named them.
        scene: Name or path; None: the robot alone.
        dialect: Name of the dialect.
        lab: A file with a lab that is laid over the scene.
        scenario: A file that says how the robot stands at first, and what happens in the cell.
        asks: Whether the monitor asks before what cannot be undone.
        replace: Whether LOAD replaces programs.
        overwrite: Whether STORE replaces files unasked.

    Raises:
        CannotRead: A file, the scene, the lab or the scenario is not there.
        Refused: Scene or scenario have errors, or a file is no text.
    """
    beside = Path(files[0]).parent if files else None
    setting = load_scene(scene, beside, lab=lab) if scene else robot_alone()
    if scenario is not None:
        setting = with_scenario(setting, scenario)
    begins = setting.scenario.scenario if setting.scenario is not None else Scenario()
    desk = Desk(
        WorkingFolder(Path.cwd()),
        DIALECTS[dialect],
        asks=asks,
        overwrite=overwrite,
        replace=replace,
    )
    controller = Controller(
        Module({}, ()), setting.scene, dataclasses.replace(begins, limits=LIMITS)
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
