"""Names of what a program is verified in, as they are given: nothing is read yet."""

from pathlib import Path
from typing import NamedTuple


class Where(NamedTuple):
    """Scene, task, scenario, lab and controller by their names; None: nobody named one."""

    scene: str | None = None  # a path, or a name of the library
    task: Path | None = None
    scenario: Path | None = None
    lab: Path | None = None
    controller: str | None = None  # name of a controller model


ANYWHERE = Where()
