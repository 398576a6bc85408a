"""Commands as pages show them, to be typed: in fences of the shell, in tables, and in sentences."""

import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

_FENCE = re.compile(r"^```(?:sh|text)\n(.*?)^```$", re.M | re.S)
_ANY_FENCE = re.compile(r"^```.*?^```$", re.M | re.S)
_SPAN = re.compile(r"`((?:\.venv/bin/)?vrts(?: [^`]*)?)`")
_FOLDER = re.compile(r"^<!-- folder: (\S+) -->$", re.M)
_HEADING = re.compile(r"^## (.*)$", re.M)


class Typed(NamedTuple):
    """A command of a page."""

    page: str
    line: int  # from 1
    folder: str  # what the page says of where it is typed: the number of a lesson, or ""
    heading: str
    in_table: bool
    words: tuple[str, ...]  # those behind `vrts`

    @property
    def text(self) -> str:
        """What is typed."""
        return shlex.join(("vrts", *self.words))


def commands(page: Path, root: Path) -> list[Typed]:
    """Return every command of vrts that a page shows, in its order."""
    text = page.read_text("utf-8")
    found = [
        (start, Typed(str(page.relative_to(root)), line, folder, heading, row, words))
        for start, line, folder, heading, row, words in _found(text)
    ]
    return [typed for _, typed in sorted(found, key=lambda one: one[0])]


def _found(text: str) -> Iterator[tuple[int, int, str, str, bool, tuple[str, ...]]]:
    fences = [
        (fence.start(), fence.end()) for fence in re.finditer(r"^```.*?^```$", text, re.M | re.S)
    ]
    shown = [
        (fence.start(1) + offset, part)
        for fence in _FENCE.finditer(text)
        for offset, part in _parts(fence[1])
    ]
    shown += [
        (span.start(1), " ".join(span[1].split()))
        for span in _SPAN.finditer(text)
        if not any(start <= span.start() < end for start, end in fences)
    ]
    for start, command in shown:
        words = shlex.split(command, comments=True)
        line = text.count("\n", 0, start) + 1
        row = text[text.rfind("\n", 0, start) + 1 : start].startswith("|")
        folder = _last(_FOLDER, text, start)
        yield start, line, folder, _last(_HEADING, text, start), row, tuple(words[1:])


def _parts(fence: str) -> Iterator[tuple[int, str]]:
    """Return the commands of vrts in a fence of the shell, with their offsets."""
    offset = 0
    for line in fence.splitlines(keepends=True):
        for part in line.split("&&"):
            plain = part.strip().removeprefix("$ ").removeprefix(".venv/bin/")
            if plain.split(" ")[0] == "vrts":
                yield offset, plain
        offset += len(line)


def _last(pattern: re.Pattern[str], text: str, before: int) -> str:
    found = [match[1] for match in pattern.finditer(text) if match.start() < before]
    return found[-1] if found else ""
