"""The zip of an autograder for Gradescope: scripts, the whole task, and wheels of vrts."""

import re
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

from vrts import __version__
from vrts.assignments.pack import read_zip, staff_zip
from vrts.assignments.packed import is_packed, load_zip
from vrts.assignments.task_folder import read_folder
from vrts.base.diagnostic import Rule, error
from vrts.base.zips import packed
from vrts.marking.exports.autograders.own_wheel import NAME, own_wheel
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused
from vrts.pipeline.settings import load_task

PUBLIC_TASK = Rule("V750", "task-without-hidden-part")

MODE = 0o755  # of members: two of them are scripts
SCRIPTS = ("setup.sh", "run_autograder", "not-marked.json", "README.md")
BUILD = "build that of vrts with `python -m build --wheel`"
LARGEST_WHEELS = 400_000_000  # bytes in all

_WHEEL = re.compile(r"[\w.]+-[\w.!+]+(-\d\w*)?-[\w.]+-[\w.]+-[\w.]+\.whl")


def autograder_zip(task: bytes, wheels: Mapping[str, bytes]) -> bytes:
    """Return an autograder. The same content gives the same bytes.

    Args:
        task: The zip of the task for the staff.
        wheels: By name: that of vrts, and of what it needs as far as it is there.
    """
    home = files("vrts.marking.exports.autograders.autograder")
    members = {name: home.joinpath(name).read_bytes() for name in SCRIPTS}
    members["task.zip"] = task
    members["version"] = f"{__version__}\n".encode()
    members.update({f"wheels/{name}": wheels[name] for name in sorted(wheels)})
    return packed(members, MODE)


def _require_no_variants(path: Path) -> None:
    task = (load_zip(path) if is_packed(path) else load_task(path)).task
    if task is not None and task.variants is not None:
        hint = "mark a download with `vrts grade` and `--roster`"
        raise CannotRead("an autograder cannot tell whose variant a submission is by", (hint,))


def staff_task(path: Path) -> bytes:
    """Return the zip for the staff of a task: a folder is packed, a zip is taken as it is.

    Raises:
        CannotRead: There is no task.
        Refused: The task has errors, or is the students' where there is a hidden part.
    """
    if not path.exists():
        raise CannotRead(f"there is no task `{path}`")
    _require_no_variants(path)
    if not is_packed(path):
        folder = path if path.is_dir() else path.parent
        return staff_zip(read_folder(folder), load_task(folder, staff=True).hidden)
    data = read_bytes(path)
    manifest = read_zip(data).manifest
    if manifest.hidden and not manifest.staff:
        raise Refused(
            (
                error(
                    PUBLIC_TASK,
                    f"`{path.name}` is what students get: {manifest.hidden} checks are missing",
                    help=("name the zip for the staff, or the folder of the task",),
                ),
            )
        )
    return data


def read_wheels(places: tuple[Path, ...]) -> dict[str, bytes]:
    """Return wheels by name: of files, and of all in folders; without any, that of vrts made here.

    Raises:
        CannotRead: A file is no wheel, there are none, or they are too large.
        Refused: There are none, and that of vrts cannot be made.
    """
    if not places:
        return {NAME: own_wheel()}
    found: dict[str, bytes] = {}
    ours: list[str] = []
    for place in places:
        wheels = sorted(place.glob("*.whl")) if place.is_dir() else [place]
        if not wheels:
            raise CannotRead(f"there is no wheel in `{place}`", (BUILD,))
        for wheel in wheels:
            if not _WHEEL.fullmatch(wheel.name):
                raise CannotRead(f"`{wheel.name}` is not the name of a wheel")
            found[wheel.name] = read_bytes(wheel)
            if wheel.name.lower().startswith("vrts-"):
                ours.append(str(wheel))
    if sum(map(len, found.values())) > LARGEST_WHEELS:
        raise CannotRead(f"the wheels have more than {LARGEST_WHEELS:,} bytes in all")
    if not any(name.startswith(f"vrts-{__version__}-") for name in found):
        raise CannotRead(
            f"the wheel of vrts {__version__} is not among the wheels",
            (BUILD, "or leave the wheels out"),
        )
    if len(ours) > 1:
        raise CannotRead(f"there are {len(ours)} wheels of vrts: {', '.join(ours)}")
    return found
