"""What a controller lists, read: programs, locations, numbers and strings."""

import re
from typing import NamedTuple

from vrts.dispatch.steps import Steps, header_of
from vrts.dispatch.transfer.problems import LISTING_UNREADABLE, stop, visible
from vrts.pipeline.refused import Refused

_STEP = re.compile(r"\s*(?P<number>\d{1,6})\.?(?:\s+(?P<text>\S.*))?")
_NUMBER = r"-?\d*\.?\d+(?:E[+-]?\d+)?"
_LOCATION = re.compile(r"(?P<name>#?[A-Za-z][\w.]*(?:\[[\d,]+\])?)\s+(?P<values>.+)", re.ASCII)
_VALUES = re.compile(rf"{_NUMBER}(?:\s+{_NUMBER}){{5}}", re.ASCII | re.IGNORECASE)
_SECTION = re.compile(r"\.(LOCATIONS|TRANS|JOINTS|END)\b", re.IGNORECASE)
_HEADINGS = frozenset({"X/JT1", "JT1", "X"})
_VALUE = re.compile(r"(?P<name>\$?[A-Za-z][\w.]*(?:\[[\d,]+\])?)\s*=?\s+(?P<value>\S.*)", re.ASCII)


class Place(NamedTuple):
    """A location as it is listed: name with subscripts, six numbers in mm and degrees."""

    name: str
    values: tuple[str, ...]

    @property
    def is_joints(self) -> bool:
        """Whether it is a precision point."""
        return self.name.startswith("#")


def programs(text: str) -> tuple[Steps, ...]:
    """Return the programs that are listed.

    Raises:
        Refused: A row is none of a listing, or steps are missing.
    """
    found: list[Steps] = []
    inside: list[str] | None = None
    name = formals = ""
    for row in text.split("\n"):
        if row.lstrip().upper().startswith(".PROGRAM") and inside is None:
            name, formals = header_of(row.strip())
            inside = []
            if not name:
                raise _unreadable("the name of a program", row)
        elif row.strip().upper() == ".END" and inside is not None:
            found.append(Steps(name, formals, tuple(inside)))
            inside = None
        elif inside is not None:
            inside.append(_step(row, len(inside) + 1))
        elif row.strip():
            raise _unreadable("`.PROGRAM`", row)
    if inside is not None:
        raise _unreadable("`.END`", "")
    return tuple(found)


def places(text: str) -> tuple[Place, ...]:
    """Return the locations that are listed, rows of headings left out.

    Raises:
        Refused: A row is none of a listing.
    """
    found: list[Place] = []
    for row in text.split("\n"):
        words = row.split()
        if not words or words[0].upper() in _HEADINGS or _SECTION.match(words[0]):
            continue
        match = _LOCATION.fullmatch(row.strip())
        if match is None or _VALUES.fullmatch(match["values"].strip()) is None:
            raise _unreadable("a name and six numbers", row)
        found.append(Place(match["name"].lower(), tuple(match["values"].split())))
    return tuple(found)


def six_numbers(text: str) -> tuple[str, ...] | None:
    """Return the last row of six numbers in an answer; None where there is none."""
    rows = [row for row in text.split("\n") if _VALUES.fullmatch(row.strip())]
    return tuple(rows[-1].split()) if rows else None


def value(text: str, name: str) -> str:
    """Return the value of a number or a string that is listed by its name.

    Raises:
        Refused: It is not there.
    """
    for row in text.split("\n"):
        match = _VALUE.fullmatch(row.strip())
        if match is not None and match["name"].lower() == name:
            return match["value"]
    raise _unreadable(f"`{name}` and its value", text)


def _step(row: str, number: int) -> str:
    match = _STEP.fullmatch(row.rstrip())
    if match is None or int(match["number"]) != number:
        raise _unreadable(f"step {number}", row)
    text = match["text"] or ""
    label, _, rest = text.partition(" ")
    return f"{label} {rest.strip()}" if re.fullmatch(r"\d{1,5}", label) and rest else text


def _unreadable(expected: str, came: str) -> Refused:
    return stop(
        LISTING_UNREADABLE,
        "what the controller lists cannot be read",
        f"expected: {expected}",
        f"came: {visible(came)}",
        remedy="try again; if it happens again, the layout of this controller is unknown to vrts",
    )
