"""What one worker runs after another; libraries that start threads are loaded by a worker alone.

A process with threads is not forked: what loads such a library is read by the worker that runs it.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

THREADED = "rerun"
LOADS_IT = re.compile(  # a line of a file that is read late
    r"^(?:from|import) (?:rerun|vrts\.report\.recording|vrts\.validate\.reports\.comparison_rec)",
    re.MULTILINE,
)


class Group(NamedTuple):
    """Tests that a worker runs one after another."""

    name: str
    items: tuple[pytest.Item, ...] = ()
    late: tuple[str, ...] = ()  # in place of tests: what is to be read


def is_late(path: Path) -> bool:
    """Return whether a file of tests loads a library that starts threads."""
    if path.suffix != ".py" or not path.name.startswith("test_") or not path.is_file():
        return False
    return LOADS_IT.search(path.read_text(encoding="utf-8", errors="replace")) is not None


def apart(words: Sequence[str], folder: Path) -> tuple[list[str], list[str]]:
    """Return which of the named tests are read at once, and which are read late."""
    late = [word for word in words if is_late(folder / word.split("::")[0])]
    return [word for word in words if word not in late], late


def groups(
    items: Iterable[pytest.Item], late: Sequence[str], name_of: Callable[[str], str]
) -> list[Group]:
    """Return the groups in the order of their tests; those that are read late begin."""
    files: dict[str, list[str]] = {}
    for word in late:
        files.setdefault(word.split("::")[0], []).append(word)
    by_name: dict[str, list[pytest.Item]] = {}
    for item in items:
        by_name.setdefault(name_of(item.nodeid), []).append(item)
    return [
        *(Group(name, late=tuple(words)) for name, words in files.items()),
        *(Group(name, tuple(found)) for name, found in by_name.items()),
    ]
