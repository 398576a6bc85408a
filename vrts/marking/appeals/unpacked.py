"""The task in evidence as files again, in a folder of our own."""

from collections.abc import Mapping
from pathlib import Path

from vrts.marking.appeals.evidence import OVER, TASK
from vrts.marking.submission.setting import Place


def unpacked_place(inside: Place, files: Mapping[str, bytes], folder: Path) -> Place:
    """Write the task, and what is laid over it, and return where it is.

    Args:
        inside: Names of files in the evidence.
        files: Of the evidence, their names checked.
        folder: Empty.
    """
    for name, data in files.items():
        if name == TASK or name.startswith(f"{OVER}/"):
            place = folder / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(data)

    def path(name: str | None) -> str | None:
        return None if name is None else str(folder / name)

    return Place(
        str(folder / TASK),
        path(inside.scene),
        path(inside.scenario),
        path(inside.lab),
        variant=inside.variant,
    )
