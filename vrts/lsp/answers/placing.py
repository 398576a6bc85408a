"""A location given another place by hand: the edits of its line of data, and its new pose."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.base.units import mm
from vrts.ir.module import Datum
from vrts.lang.reading.sections.lines import comment_start
from vrts.lsp.documents.documents import Document

MOST_MM = 100_000.0  # either way: far beyond every arm
_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?![\w.])", re.ASCII)
_NAME = re.compile(r"\s*[A-Za-z][\w.]*\s*(?:\[[^\]]*\])?\s*=?", re.ASCII)
_BLANKS = " "
_MATRIX = 12
_FEWEST = 1  # decimals: 0.1 mm


class CannotMove(Exception):  # noqa: N818 -- names the situation
    """The numbers of a location cannot be changed; the text says why."""


class Change(NamedTuple):
    """A range of a text and what stands there from now on."""

    start: int
    end: int
    text: str


class Moved(NamedTuple):
    """A location at another place."""

    changes: tuple[Change, ...]  # of its line, from left to right; none: it stands there already
    numbers: tuple[str, str, str]  # X Y Z as they are written then [mm]
    line: int


def pose_at(datum: Datum, point_mm: Vector) -> Pose:
    """Return the pose of a location with its position elsewhere [mm].

    Raises:
        CannotMove: It has no position.
    """
    if not isinstance(datum.value, Pose):
        raise CannotMove(f"`{datum.name}` has no X, Y and Z")
    x, y, z = point_mm
    return Pose(datum.value.rotation, (x / 1e3, y / 1e3, z / 1e3))


def datum_of(document: Document, name: str, subscripts: Sequence[int]) -> Datum:
    """Return the line of data that gives a location its value.

    Raises:
        CannotMove: There is none in this text.
    """
    found = document.data.get((name, tuple(subscripts)))
    if found is None:
        raise CannotMove(f"no line of `{document.source.name}` gives `{name}` a value any more")
    return found


def moved(datum: Datum, point_mm: Vector) -> Moved:
    """Return the edits that put a location at a point, with as many decimals as its line has.

    Only numbers that change are written, with 0.1 mm at least. Where blanks stand before a number
    and leave room, it ends in the same column as before.

    Args:
        datum: The line.
        point_mm: X, Y, Z as the line has them.

    Raises:
        CannotMove: The line is not written in plain numbers, or the point is out of all bounds.
    """
    after = pose_at(datum, point_mm)
    assert isinstance(datum.value, Pose)
    if not all(abs(x) <= MOST_MM for x in point_mm):
        raise CannotMove("that is too far away for any arm")
    source = datum.span.source
    text = source.text[datum.span.start : datum.span.end]
    spots = _spots(text)
    if spots is None:
        raise CannotMove(f"line {datum.span.line} is not written in plain numbers")
    decimals = max(_FEWEST, *(len(m[0].partition(".")[2]) for m in spots))
    changes: list[Change] = []
    written: list[str] = []
    for spot, old, new in zip(spots, datum.value.translation, after.translation, strict=True):
        number = f"{round(mm(new), decimals) + 0.0:.{decimals}f}"
        if abs(mm(old) - float(number)) < 0.5 * 10.0**-decimals:
            written.append(spot[0])
            continue
        written.append(number)
        start, end = spot.span()
        room = start - len(text[:start].rstrip(_BLANKS))
        start -= min(max(len(number) - (end - start), 0), max(room - 1, 0))
        padded = number.rjust(end - start) if room > 1 else number
        changes.append(Change(datum.span.start + start, datum.span.start + end, padded))
    x, y, z = written
    return Moved(tuple(changes), (x, y, z), datum.span.line)


def _spots(text: str) -> list[re.Match[str]] | None:
    """Return where X, Y and Z stand in a line of data; None where that is not plain to see."""
    name = _NAME.match(text)
    if name is None:
        return None
    cut = comment_start(text.partition("\n")[0])
    plain = text if cut < 0 or "\n" in text else text[:cut]
    found = list(_NUMBER.finditer(plain, name.end()))
    rest = _NUMBER.sub("", plain[name.end() :])
    if rest.strip(" \t,\n\r") or len(found) not in (3, 6, _MATRIX):
        return None
    return found[9:12] if len(found) == _MATRIX else found[:3]
