"""The set of scenes of a server: scenes and tasks, as they are named on the command line."""

from collections.abc import Sequence
from pathlib import Path

from vrts.base.safe_names import safe
from vrts.live.settings import Place
from vrts.pipeline.files import SCENE_FILE, CannotRead, find_example, find_scene
from vrts.pipeline.settings import TASK_FILE


def places_of(names: Sequence[str]) -> tuple[Place, ...]:
    """Return the set of scenes; a name is a scene, a task file, or a folder with a task.

    Raises:
        CannotRead: There is no such scene or task, or two have the same name.
    """
    places: dict[str, Place] = {}
    for name in names:
        place = _place(name)
        if place.id in places:
            raise CannotRead(f"there are two scenes `{place.id}`", ("rename one",))
        places[place.id] = place
    return tuple(places.values())


def _place(name: str) -> Place:
    task = _task(name)
    if task is not None:
        return Place(safe(task.resolve().parent.name)[:64], "", str(task.resolve()))
    scene = find_scene(name).resolve()
    id_ = scene.parent.name if scene.name == SCENE_FILE else scene.stem
    return Place(safe(id_)[:64], str(scene), "")


def _task(name: str) -> Path | None:
    if Path(name).name == TASK_FILE and Path(name).is_file():
        return Path(name)
    folder = find_example(name)
    return folder / TASK_FILE if folder is not None and (folder / TASK_FILE).is_file() else None
