"""The set of scenes of a server: scenes and tasks, as they are named on the command line."""

from collections.abc import Sequence
from pathlib import Path

from vrts.base.safe_names import safe
from vrts.live.session.setting import has_variants
from vrts.live.settings import Place
from vrts.pipeline.files import SCENE_FILE, TASK_FILE, CannotRead, asked_scene, find_example


def places_of(names: Sequence[str], lab: Path | None = None) -> tuple[Place, ...]:
    """Return the set of scenes; a name is a scene, a task file, or a folder with a task.

    Args:
        names: As they are named on the command line.
        lab: File of a lab that is laid over all of them.

    Raises:
        CannotRead: There is no such scene, task or lab, or two have the same name.
    """
    if lab is not None and not lab.is_file():
        raise CannotRead(f"there is no lab `{lab}`", ("`vrts new lab NAME` writes one",))
    places: dict[str, Place] = {}
    for name in names:
        place = _place(name)
        if place.id in places:
            raise CannotRead(f"there are two scenes `{place.id}`", ("rename one",))
        places[place.id] = place._replace(lab=str(lab.resolve()) if lab is not None else "")
    return tuple(places.values())


def with_variants(places: Sequence[Place]) -> tuple[str, ...]:
    """Return what scenes of the set are called whose tasks have `[variants]`.

    Raises:
        CannotRead: A task cannot be read.
    """
    return tuple(place.id for place in places if place.task and has_variants(Path(place.task)))


def _place(name: str) -> Place:
    task = _task(name)
    if task is not None:
        return Place(safe(task.resolve().parent.name)[:64], "", str(task.resolve()))
    scene = asked_scene(name).resolve()
    id_ = scene.parent.name if scene.name == SCENE_FILE else scene.stem
    return Place(safe(id_)[:64], str(scene), "")


def _task(name: str) -> Path | None:
    if Path(name).name == TASK_FILE and Path(name).is_file():
        return Path(name)
    folder = find_example(name)
    return folder / TASK_FILE if folder is not None and (folder / TASK_FILE).is_file() else None
