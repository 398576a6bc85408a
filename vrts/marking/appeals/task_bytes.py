"""The task of a marking as a zip, with what was laid over it beside."""

from pathlib import Path

from vrts import __version__
from vrts.assignments.pack import staff_zip
from vrts.assignments.packed import is_packed
from vrts.assignments.task_folder import read_folder, with_shapes
from vrts.base.diagnostic import Rule, error
from vrts.marking.appeals.evidence import OVER, TASK
from vrts.marking.appeals.evidence_zip import known_name
from vrts.marking.result import Result
from vrts.marking.submission.setting import Place, load
from vrts.pipeline.files import STAFF, TASK_FILE, asked_scene, read_bytes
from vrts.pipeline.refused import Refused

OTHER_TASK = Rule("V763", "task-changed-since")


def task_files(place: Place, result: Result) -> tuple[Place, dict[str, bytes]]:
    """Return where the task is in evidence, and the bytes of everything it needs.

    Args:
        place: Of the task now.
        result: What was marked by it.

    Raises:
        CannotRead: A file is not there.
        Refused: The task has errors, or cannot be packed.
    """
    path = Path(place.task)
    files = {TASK: read_bytes(path) if is_packed(path) else _packed(path, place, result)}
    beside = path.parent
    inside = {
        "scene": _over(files, "scene", place.scene and asked_scene(place.scene, beside)),
        "scenario": _over(files, "scenario", place.scenario and Path(place.scenario)),
        "lab": _over(files, "lab", place.lab and Path(place.lab)),
    }
    for name in files:
        if not known_name(name):
            headline = f"`{name.split('/')[-1]}` cannot be packed under this name"
            remedy = "rename the file to letters, digits, `_`, `-` and `.`, and mark again"
            raise Refused((error(OTHER_TASK, headline, help=(remedy,)),))
    return Place(TASK, **inside, variant=place.variant), files


def _packed(path: Path, place: Place, result: Result) -> bytes:
    """Return the folder of a task as a zip, without anything in `staff` that marks do not need."""
    folder = path if path.is_dir() else path.parent
    if path.is_file() and path.name != TASK_FILE:
        headline = f"the task is called `{path.name}`, and cannot be packed"
        raise Refused((error(OTHER_TASK, headline, help=(f"call it `{TASK_FILE}`",)),))
    files = read_folder(folder)
    needed = (f"{STAFF}/{TASK_FILE}", f"{STAFF}/scenes/")
    staff = {
        name: data
        for name, data in files.staff.items()
        if name.startswith(needed) or name == files.environment
    }
    hidden = load(place, staff=True).hidden
    versions = tuple(dict.fromkeys((result.versions.vrts, __version__)))
    return staff_zip(files._replace(staff=staff), hidden, versions)


def _over(files: dict[str, bytes], part: str, path: "Path | str | None") -> str | None:
    """Add a file that is laid over the task, and what stands beside it; return its name."""
    if not isinstance(path, Path):
        return None
    name = f"{OVER}/{part}/{path.name}"
    if part == "scenario":
        files[name] = read_bytes(path)
    else:
        with_shapes(path, name, files)
    return name
