"""Lines of a text before and after it was changed: which did, and where the others are now."""

from collections.abc import Mapping, Sequence
from difflib import SequenceMatcher

MOST_COMPARED = 20_000  # lines of both texts; more are taken as all changed


def line_after(before: str, after: str, line: int) -> int:
    """Return where a line is in a changed text, or what stands in its place; from 1."""
    count = max(after.count("\n") + 1, 1)
    for _, i1, i2, j1, j2 in _opcodes(before.splitlines(), after.splitlines()):
        if i1 < line <= i2:
            return min(max(j1 + line - i1, 1), max(j2, j1 + 1), count)
    return min(line, count)


def changed_lines(before: Mapping[str, str], after: Mapping[str, str]) -> str:
    """Return in words which lines of which texts are others."""
    found: list[int] = []
    for name, text in after.items():
        for tag, i1, i2, j1, j2 in _opcodes(before.get(name, "").splitlines(), text.splitlines()):
            if tag != "equal":
                found += range(j1 + 1, max(j2, j1 + 1, j1 + (i2 > i1)) + 1)
    if not found:
        return "text changed"
    first, last = found[0], found[-1]
    if first == last:
        return f"line {first} changed"
    return f"{len(found)} lines from {first} to {last} changed"


def _opcodes(
    before: Sequence[str], after: Sequence[str]
) -> Sequence[tuple[str, int, int, int, int]]:
    if len(before) + len(after) > MOST_COMPARED:
        return [("replace", 0, len(before), 0, len(after))]
    return SequenceMatcher(None, before, after, autojunk=False).get_opcodes()
