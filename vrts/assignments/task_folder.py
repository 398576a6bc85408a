"""The folder of a task: which of its files students get, and which only the staff.

Students get what is on the list and nothing else, so a file that was forgotten stays at home.
"""

import re
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from vrts.assignments.handed.readme import NAME as README
from vrts.base.safe_names import safe
from vrts.check.task.task import Task
from vrts.check.task.task_places import lab_name, scene_name
from vrts.pipeline.environments import environment_file
from vrts.pipeline.files import (
    MAX_TOML,
    SCENARIO_FILE,
    SCENE_FILE,
    STAFF,
    TASK_FILE,
    CannotRead,
    find_scene,
    member_bytes,
    named_place,
    read_toml_source,
)
from vrts.pipeline.pieces.named import pieces_files
from vrts.pipeline.refused import Refused
from vrts.pipeline.settings import load_task
from vrts.scene.reading.files import PIECES

PUBLIC = (TASK_FILE, SCENARIO_FILE, README, "start.v2")  # names in the folder itself
PUBLIC_FOLDERS = ("pictures", "handout")
SOLUTION = "solution.v2"  # the reference, in `staff`, or beside the task where it is no secret
LARGEST = 4_000_000  # bytes of a file


class TaskFiles(NamedTuple):
    """The files of a task, by the name they have in its folder."""

    name: str
    scene: str  # which of the public files is the scene's
    public: dict[str, bytes]
    staff: dict[str, bytes]
    lab: str = ""  # which of the public files is that of the lab; "" without one
    environment: str = ""  # which of all files is that of the environment; "" without one


def read_folder(folder: Path) -> TaskFiles:
    """Return the files of a task's folder, with the scene also where it comes with vrts.

    Raises:
        CannotRead: There is no task, or a file is too large.
        Refused: Task or scene have errors.
    """
    task = load_task(folder / TASK_FILE, staff=True).task  # everything must be right
    assert task is not None
    public = {name: _bytes(folder / name) for name in PUBLIC if (folder / name).is_file()}
    for part in PUBLIC_FOLDERS:
        public.update(_inside(folder, part))
    name = safe(folder.resolve().name)
    scene, lab = _add_scene(folder, public), _add_lab(folder, public)
    staff = dict(_inside(folder, STAFF))
    environment = _add_environment(folder, task, public, staff)
    return TaskFiles(name, scene, public, staff, lab, environment)


def reference_of(folder: Path) -> Path | None:
    """Return the reference solution of a task: in `staff`, else beside the task; or None."""
    places = (folder / STAFF / SOLUTION, folder / SOLUTION)
    return next((place for place in places if place.is_file()), None)


def _add_scene(folder: Path, public: dict[str, bytes]) -> str:
    """Add the scene and the files beside it; return the name it gets."""
    named, found = scene_name(read_toml_source(folder / TASK_FILE))
    if named is None:
        raise Refused(found)
    place = find_scene(named, folder)
    if place.resolve().is_relative_to(folder.resolve()):
        name = PurePosixPath(place.resolve().relative_to(folder.resolve())).as_posix()
        if name.startswith(f"{STAFF}/"):
            raise CannotRead(f"the scene of the task is in `{STAFF}`, which students do not get")
    elif re.fullmatch(r"[\w.-]+", named):
        name = f"{named}/{SCENE_FILE}"
    else:
        raise CannotRead(
            f"the scene `{named}` is outside the task's folder",
            ("copy it into the folder, and name it from there",),
        )
    with_shapes(place, name, public)
    return name


def _add_lab(folder: Path, public: dict[str, bytes]) -> str:
    """Add the lab and the files beside it; return the name it has, "" where there is none."""
    named = lab_name(read_toml_source(folder / TASK_FILE))
    if named is None:
        return ""
    place = named_place(folder, named)
    if not place.resolve().is_relative_to(folder.resolve()):
        raise CannotRead(
            f"the lab `{named}` is outside the task's folder",
            ("copy it into the folder, and name it from there",),
        )
    name = PurePosixPath(place.resolve().relative_to(folder.resolve())).as_posix()
    if name.startswith(f"{STAFF}/"):
        raise CannotRead(f"the lab of the task is in `{STAFF}`, which students do not get")
    with_shapes(place, name, public)
    return name


def _add_environment(
    folder: Path, task: Task, public: dict[str, bytes], staff: dict[str, bytes]
) -> str:
    """Add the environment of the task where it belongs; return the name it has, "" without one.

    What is hidden stays with the staff, wherever it lies.
    """
    place = environment_file(task, folder)
    if place is None or task.proof is None:
        return ""
    name = PurePosixPath(place.resolve().relative_to(folder.resolve())).as_posix()
    in_staff = name.startswith(f"{STAFF}/")
    if task.proof.hidden:
        public.pop(name, None)
        staff[name] = _bytes(place)
    elif in_staff:
        raise CannotRead(
            f"the environment of the task is in `{STAFF}`, which students do not get",
            ("write `hidden = true` in `[prove]`, or move the file",),
        )
    else:
        public[name] = _bytes(place)
    return name


def with_shapes(place: Path, name: str, public: dict[str, bytes]) -> None:
    """Add a file, the descriptions of robots and meshes beside it, and pieces that it names.

    A mesh that is too large is left out: of parts in a scene, runs need the pieces alone.
    """
    public[name] = _bytes(place)
    beside = str(PurePosixPath(name).parent)
    for other in sorted(place.parent.iterdir()):
        if other.suffix.lower() not in (".urdf", ".stl", ".obj", ".dae") or not other.is_file():
            continue
        pieces = other.with_name(other.name + PIECES)
        if not (pieces.is_file() and other.stat().st_size > LARGEST):
            inside = other.name if beside == "." else f"{beside}/{other.name}"
            public[inside] = _bytes(other)
    for other, data in pieces_files(read_toml_source(place), place.parent).items():
        public[other if beside == "." else f"{beside}/{other}"] = data


def _inside(folder: Path, part: str) -> Iterator[tuple[str, bytes]]:
    root = folder / part
    if not root.is_dir():
        return
    for path in sorted(root.rglob("*")):
        inside = path.relative_to(folder)
        hidden = any(name.startswith((".", "__")) for name in inside.parts)
        if path.is_file() and not hidden and path.resolve().is_relative_to(folder.resolve()):
            yield inside.as_posix(), _bytes(path)


def _bytes(path: Path) -> bytes:
    most = MAX_TOML if path.suffix == ".toml" else LARGEST
    if path.stat().st_size > most:
        raise CannotRead(f"`{path.name}` is too large: more than {most:,} bytes")
    return member_bytes(path)
