"""Which files can hold tests with a marker: only those are read in a run that asks for the marker.

To read all takes every worker ten seconds. What a file has to say of itself is a word in its text;
whoever marks a test in a file without it is told so by the usual run.
"""

from pathlib import Path

import pytest

from tests.laws import ALL

# by marker, words of which one stands in every file that has such tests; laws with all their
# examples are thorough
SIGNS = {"thorough": ("thorough", "laws", "hypothesis"), "live": ("mark.live",)}


def may_hold(expression: str, path: Path) -> bool:
    """Return whether a file may hold tests of an expression of markers, such as `-m live`."""
    signs = SIGNS.get(expression.partition(" ")[0])
    if signs is None or not path.name.startswith("test_"):
        return True
    text = path.read_text(encoding="utf-8", errors="replace")
    return any(sign in text for sign in signs)


def is_law(item: pytest.Item) -> bool:
    """Return whether a test is a law, which is tried with examples."""
    return getattr(getattr(item, "obj", None), "is_hypothesis_test", False)


def mark_laws(items: list[pytest.Item]) -> None:
    """Mark laws as thorough, where they are tried with all their examples.

    Raises:
        pytest.UsageError: A test has a marker of which its file says no word.
    """
    known: dict[tuple[str, Path], bool] = {}
    for item in items:
        if is_law(item):
            names = ["thorough"]
            if ALL:
                item.add_marker("thorough")
        else:
            names = [mark.name for mark in item.iter_markers() if mark.name in SIGNS]
        for name in names:
            key = name, item.path
            if key not in known:
                known[key] = may_hold(name, item.path)
            if not known[key]:
                raise pytest.UsageError(
                    f"{item.path}: {item.name} is {name}; say so: {SIGNS[name]}"
                )
