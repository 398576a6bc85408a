"""Foreign text made safe to show: one visible character for each character that has no shape.

Programs and names come from anybody. Control characters would steer a terminal, and direction
marks make text read differently from what the compiler sees; both are replaced by stand-ins.
Build services read the output of what they run and obey `##[...]` anywhere in a line and `::...::`
at its start; there one sign is replaced by another that looks like it.
"""

import re
import unicodedata
from typing import NamedTuple

TAB = 4  # columns between tab stops in excerpts
STAND_IN = "�"
SHARP, RATIO = "♯", "∶"  # look like number sign and colon, and mean nothing to a build service

# the second sign, where GitHub, Azure and TeamCity would read a command
SERVICE_COMMAND = re.compile(r"(?<=#)#(?=(?:vso|teamcity)?\[)", re.IGNORECASE)


class Shown(NamedTuple):
    """A line as it appears, and where each of its characters went."""

    text: str
    columns: tuple[int, ...]  # display column of every character, and of the end of the line


def visible(text: str) -> str:
    """Return the text with every control and format character replaced; line ends stay."""
    if text.isprintable():  # nearly always, and pictures are long
        return _disarmed(text)
    seen = (character if character == "\n" else _visible(character) for character in text)
    return _disarmed("".join(seen))


def one_line(text: str) -> str:
    """Return the text on one line: line ends and tabs become blanks, the rest is made visible."""
    return visible(" ".join(text.split()))


def line_start(line: str) -> str:
    """Return a visible line that begins with foreign text so that it begins no command."""
    text = line.lstrip(" ")
    if not text.startswith("::"):
        return line
    return line[: len(line) - len(text)] + RATIO + text[1:]


def plain_text(text: str) -> str:
    """Return lines of words and names, all visible, in which no line begins a command."""
    return "\n".join(line_start(line) for line in visible(text).split("\n"))


def capital(text: str) -> str:
    """Return a sentence with its first letter in upper case, the rest as it is."""
    return text[:1].upper() + text[1:]


def yes_no(affirmative: bool) -> str:
    """Return the word for an answer."""
    return "yes" if affirmative else "no"


def bare_name(name: str) -> str:
    """Return the name of a file without its folders, which are nobody's business."""
    return name.replace("\\", "/").rstrip("/").rsplit("/", 1)[-1] or name


def width(text: str) -> int:
    """Return how many columns a visible text takes on a terminal."""
    return sum(_width(character) for character in text)


def shown(line: str) -> Shown:
    """Return a source line as it appears: tabs expanded, characters without shape replaced."""
    if line.isascii() and line.isprintable():  # nearly always
        return Shown(_disarmed(line), tuple(range(len(line) + 1)))
    parts: list[str] = []
    columns: list[int] = []
    at = 0
    for character in _disarmed(line):
        columns.append(at)
        stand_in = " " * (TAB - at % TAB) if character == "\t" else _visible(character)
        parts.append(stand_in)
        at += width(stand_in)
    return Shown("".join(parts), (*columns, at))


def _disarmed(text: str) -> str:
    """Return the text, as long as before, without commands that stand anywhere in a line."""
    return SERVICE_COMMAND.sub(SHARP, text) if "##" in text else text


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
