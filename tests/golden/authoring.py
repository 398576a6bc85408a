"""Write the outputs shown in the walk-through for authors anew: `python -m tests.golden.authoring`.

It begins in an empty folder.
"""

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TypeVar

from tests.golden.tutorial import rewritten
from tests.places import ROOT

WALK = ROOT / "examples" / "07-own-assignment" / "README.md"

Answer = TypeVar("Answer")


def in_an_empty_folder(ask: Callable[[str, Path], Answer]) -> Answer:
    """Return what `ask` makes of the text of the walk-through and an empty folder."""
    with TemporaryDirectory() as temporary:
        folder = Path(temporary) / "empty"
        folder.mkdir()
        return ask(WALK.read_text(encoding="utf-8"), folder)


def main() -> None:
    """Write the file."""
    WALK.write_text(in_an_empty_folder(rewritten), encoding="utf-8")


if __name__ == "__main__":
    main()
