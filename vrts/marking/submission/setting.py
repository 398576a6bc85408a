"""Which task to mark by: where its files are, and how they become a setting."""

from pathlib import Path

from vrts.assignments.packed import is_packed, load_zip
from vrts.marking.result import Record
from vrts.pipeline.controllers import under
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task


class Place(Record, frozen=True):
    """Where a task is, and what is laid over it; paths as text."""

    task: str  # task.toml, or a zip of `vrts task pack`
    scene: str | None = None  # another than the task's: its marks do not count
    scenario: str | None = None
    lab: str | None = None
    controller: str | None = None  # model of then, to mark again what was marked before
    variant: str | None = None  # tag of the variant that the task is; None: it has none


def load(place: Place, *, staff: bool) -> Setting:
    """Return the setting of a task, with or without its hidden part.

    Raises:
        CannotRead: A file is not there.
        Refused: Task, scene or scenario have errors.
    """
    path = Path(place.task)
    read = load_zip if is_packed(path) else load_task
    setting = read(
        path,
        scene=place.scene,
        scenario=None if place.scenario is None else Path(place.scenario),
        staff=staff,
        lab=None if place.lab is None else Path(place.lab),
    )
    return setting if place.controller is None else under(setting, place.controller)
