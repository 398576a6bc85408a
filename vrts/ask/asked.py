"""What people type who want a page: the files of `questions`, by writers who saw no search.

A row `[do/wait-a-time]` names a page as `vrts manual` does; each row below it is one question.
"""

from collections.abc import Mapping
from functools import cache
from importlib.resources import files


@cache
def asked_for() -> Mapping[str, tuple[str, ...]]:
    """Return the questions that each page answers, by its name."""
    found: dict[str, list[str]] = {}
    for file in files("vrts").joinpath("ask", "questions").iterdir():
        rows: list[str] = []
        for line in file.read_text("utf-8").splitlines():
            if line.startswith("["):
                rows = found.setdefault(line[1:-1], [])
            elif line:
                rows.append(line.strip())
    return {name: tuple(rows) for name, rows in found.items()}
