"""From text to commands: those of an option, and those of a command file."""

import re
from collections.abc import Iterable
from typing import NamedTuple

MOST_BYTES = 1_000_000  # of a command file
MOST_COMMANDS = 10_000
LONGEST = 1_000  # characters of a command

_PIECE = re.compile(r'(?:[^;"]|"[^"]*"?)+')


class TooMuch(ValueError):  # noqa: N818 -- names the situation
    """More than a script may have; the text says what."""


class Line(NamedTuple):
    """A command of a script."""

    number: int  # of the line in its file; of the option where it is given with one
    text: str


def commands_of(texts: tuple[str, ...]) -> list[Line]:
    """Return the commands of options: a semicolon parts them, but for one in quotes.

    Raises:
        TooMuch: There are too many, or one is too long.
    """
    return _limited(
        Line(number, piece.group().strip())
        for number, text in enumerate(texts, start=1)
        for piece in _PIECE.finditer(text.replace("\n", ";"))
    )


def commands_in(data: bytes) -> list[Line]:
    """Return the commands of a file: one a line; a line that begins with `#` is a remark.

    Raises:
        TooMuch: The file is too large, or there are too many, or one is too long.
    """
    if len(data) > MOST_BYTES:
        raise TooMuch(f"a command file has at most {MOST_BYTES // 1_000_000} MB")
    text = data.decode("utf-8-sig", "replace")
    return _limited(
        Line(number, line.strip())
        for number, line in enumerate(text.splitlines(), start=1)
        if not line.lstrip().startswith("#")
    )


def _limited(lines: Iterable[Line]) -> list[Line]:
    found = [line for line in lines if line.text]
    if len(found) > MOST_COMMANDS:
        raise TooMuch(f"a script has at most {MOST_COMMANDS:,} commands")
    for line in found:
        if len(line.text) > LONGEST:
            raise TooMuch(f"line {line.number}: a command has at most {LONGEST:,} characters")
    return found
