"""The file of locations that somebody who teaches alone fills, as STORE writes it."""

import os
import re
from pathlib import Path

_ROW = re.compile(r"(?P<name>[^\s\[]+)(?:\[(?P<indices>[\d,]+)\])?\s")

Place = tuple[bool, str, tuple[int, ...]]  # precision points last, then by name and index


class PointsFile:
    """Rows of `.LOCATIONS`; the file is whole after every one."""

    def __init__(self, path: Path) -> None:
        """Say where it is; nothing is written before the first location."""
        self.path = path
        self._rows: dict[Place, str] = {}
        self._written = 0

    def __len__(self) -> int:
        """Return how many locations the file has: fewer than were added where it failed."""
        return self._written

    def add(self, row: str) -> None:
        """Add a location, or replace the one of the same name, and write the file.

        Args:
            row: Name and numbers as STORE writes them, without a line break.

        Raises:
            OSError: The file cannot be written.
        """
        self._rows[_place(row)] = row
        rows = [self._rows[place] for place in sorted(self._rows)]
        text = "\n".join((".LOCATIONS", *rows, ".END", ""))
        whole = self.path.with_name(f".{self.path.name}.part")
        whole.write_text(text, encoding="ascii", newline="\n")
        os.replace(whole, self.path)
        self._written = len(rows)


def _place(row: str) -> Place:
    match = _ROW.match(row)
    assert match is not None, row
    indices = tuple(map(int, match["indices"].split(","))) if match["indices"] else ()
    return (row.startswith("#"), match["name"], indices)
