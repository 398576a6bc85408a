"""What is asked about the program of a file."""

from pathlib import Path

from vrts.pipeline.compiling.reading import STRICT, ProgramFile, Reading
from vrts.pipeline.files import CannotRead, read_bytes, scene_names, shown
from vrts.pipeline.request import ALL_CHECKS, Checks, Request
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import ANYWHERE, Where


def request_for(
    path: Path,
    where: Where = ANYWHERE,
    *,
    setting: Setting | None = None,
    reading: Reading = STRICT,
    entry: str | None = None,
    checks: Checks = ALL_CHECKS,
) -> Request:
    """Return what is asked about the program of a file.

    Args:
        path: The file.
        where: Names of scene, task, scenario and lab; without them the task beside the program.
        setting: These already read.
        reading: Dialect, and files compiled together with the program.
        entry: Program to execute; None: the task's, else the main one.
        checks: What is to be found out.

    Raises:
        CannotRead: A file is not there, or nothing says which scene to take.
        Refused: Scene or task have errors.
    """
    program = ProgramFile(read_bytes(path), shown(path))
    if setting is None:
        setting = setting_for(path, where)
    if setting is None:
        raise CannotRead(
            "nothing says in which scene to verify the program",
            (
                "give `--scene NAME`, or put a `task.toml` beside it",
                f"scenes: {', '.join(scene_names())}",
            ),
        )
    return Request(program, setting, reading, entry, checks, path.stem, path.name)
