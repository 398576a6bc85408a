"""A task in a form that any machine can mark by: its bytes, and not where they are."""

from pathlib import Path

from vrts.assignments.pack import staff_zip
from vrts.assignments.packed import is_packed
from vrts.assignments.task_folder import read_folder, with_shapes
from vrts.marking.result import Record
from vrts.marking.submission.setting import Place
from vrts.pipeline.files import TASK_FILE, CannotRead, asked_scene, read_bytes
from vrts.pipeline.settings import load_task

_TASK = "task.zip"


class Laid(Record, frozen=True):
    """A file that is laid over a task, and those beside it that it may use."""

    name: str  # `folder/file`: a scene is called by its folder
    files: dict[str, bytes]  # by name


class PortableTask(Record, frozen=True):
    """A task as the staff has it, hidden checks included."""

    packed: bytes  # the zip
    scene: Laid | None = None
    scenario: Laid | None = None
    lab: Laid | None = None
    variant: str | None = None  # tag of the variant that the task is


def portable(place: Place) -> PortableTask:
    """Return a task with everything that marking reads.

    Raises:
        CannotRead: A file is not there, or is where it cannot be taken along.
        Refused: The task has errors.
    """
    path = Path(place.task)
    beside = path if path.is_dir() else path.parent
    scene = None if place.scene is None else asked_scene(place.scene, beside)
    return PortableTask(
        read_bytes(path) if is_packed(path) else _packed(path),
        None if scene is None else _laid(scene),
        None if place.scenario is None else _laid(Path(place.scenario)),
        None if place.lab is None else _laid(Path(place.lab)),
        place.variant,
    )


def settle(task: PortableTask, folder: Path) -> Place:
    """Write a task into a folder of our own; return where it is now."""
    place = folder / _TASK
    folder.mkdir(parents=True, exist_ok=True)
    place.write_bytes(task.packed)
    written: dict[str, str | None] = {
        part: None if laid is None else _write(laid, folder / part)
        for part, laid in (("scene", task.scene), ("scenario", task.scenario), ("lab", task.lab))
    }
    scene, scenario, lab = (written[part] for part in ("scene", "scenario", "lab"))
    return Place(str(place), scene, scenario, lab, variant=task.variant)


def _packed(path: Path) -> bytes:
    folder = path if path.is_dir() else path.parent
    if path != folder and path.name != TASK_FILE:
        hints = (f"call it `{TASK_FILE}`, in a folder of its own",)
        raise CannotRead(f"`{path.name}` cannot be marked on other machines", hints)
    return staff_zip(read_folder(folder), load_task(folder, staff=True).hidden)


def _laid(path: Path) -> Laid:
    folder = path.resolve().parent.name or "files"
    files: dict[str, bytes] = {}
    with_shapes(path, f"{folder}/{path.name}", files)
    return Laid(f"{folder}/{path.name}", files)


def _write(laid: Laid, folder: Path) -> str:
    for name, data in laid.files.items():
        place = folder / name
        if not place.resolve().is_relative_to(folder.resolve()):
            raise CannotRead(f"`{name}` is no name of a file beside a task")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(data)
    return str((folder / laid.name).resolve())
