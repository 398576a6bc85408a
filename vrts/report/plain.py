"""Foreign text made safe to show: one visible character for each character that has no shape.

Programs and names come from anybody. Control characters would steer a terminal, and direction
marks make text read differently from what the compiler sees; both are replaced by stand-ins.
"""

import unicodedata
from typing import NamedTuple

TAB = 4  # columns between tab stops in excerpts
STAND_IN = "�"


class Shown(NamedTuple):
    """A line as it appears, and where each of its characters went."""

    text: str
    columns: tuple[int, ...]  # display column of every character, and of the end of the line


def visible(text: str) -> str:
    """Return the text with every control and format character replaced; line ends stay."""
    return "".join(character if character == "\n" else _visible(character) for character in text)


def one_line(text: str) -> str:
    """Return the text on one line: line ends and tabs become blanks, the rest is made visible."""
    return visible(" ".join(text.split()))


def capital(text: str) -> str:
    """Return a sentence with its first letter in upper case, the rest as it is."""
    return text[:1].upper() + text[1:]


def yes_no(affirmative: bool) -> str:
    """Return the word for an answer."""
    return "yes" if affirmative else "no"


def width(text: str) -> int:
    """Return how many columns a visible text takes on a terminal."""
    return sum(_width(character) for character in text)


def shown(line: str) -> Shown:
    """Return a source line as it appears: tabs expanded, characters without shape replaced."""
    parts: list[str] = []
    columns: list[int] = []
    at = 0
    for character in line:
        columns.append(at)
        stand_in = " " * (TAB - at % TAB) if character == "\t" else _visible(character)
        parts.append(stand_in)
        at += width(stand_in)
    return Shown("".join(parts), (*columns, at))


def _visible(character: str) -> str:
    if character.isprintable():
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)  # pictures of control characters
    if code == 0x7F:
        return "␡"
    return " " if unicodedata.category(character) == "Zs" else STAND_IN


def _width(character: str) -> int:
    if character < "\u0300":
        return 1
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1
