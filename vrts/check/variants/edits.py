"""The texts of a task's files with other values in them, and with whole tables left out.

A value is replaced where it stands, so comments and everything else stay. What is named must be in
the file already: a teacher sees there what a student may get.
"""

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.base.toml.places import Place, Range, places

AXES = ("x", "y", "z", "o", "a", "t")  # of the first numbers of a list
PRESENT = {"true": True, "false": False}

_INDEX = re.compile(r"[1-9]\d{0,3}")


class NoPath(Exception):  # noqa: N818 -- names the situation
    """A path names nothing in a file."""

    def __init__(self, why: str, near: str = "") -> None:
        """Say why; `near` is what may be meant instead of the part that is not there."""
        super().__init__(why)
        self.why = why
        self.near = near


class Edit(NamedTuple):
    """What one value of a file becomes."""

    path: tuple[str, ...]  # without the word for the file: ("objects", "can1", "at_mm", "x")
    text: str  # TOML; "true" and "false" say of a table whether it is there


def edited(source: SourceFile, edits: Iterable[Edit], drop: Iterable[tuple[str, ...]] = ()) -> str:
    """Return a text with values set, and some tables and keys left out.

    Args:
        source: The text, which is TOML.
        edits: What becomes of values.
        drop: Paths of tables and keys that are left out; what is not there is no fault.

    Raises:
        NoPath: An edit names nothing.
    """
    text = source.text
    root = places(text).root
    headers = sorted(_headers(root, text))
    gone: list[Range] = []
    changes: list[tuple[Range, str]] = []
    for edit in edits:
        place = find(root, edit.path)
        if _is_value(place, text):
            changes.append((place.value, edit.text))
        elif edit.text not in PRESENT:
            raise NoPath("it is a whole table, which is there (true) or not (false)")
        elif not PRESENT[edit.text]:
            gone += _tables(place, headers, text)
    for path in drop:
        try:
            place = find(root, path)
        except NoPath:
            continue
        tables = tuple(_tables(place, headers, text))
        gone += tables or (_lines(place, text),)
    changes = [(at, new) for at, new in changes if not any(a <= at[0] < b for a, b in gone)]
    changes += [(at, "") for at in _joined(gone)]
    for (start, end), new in sorted(changes, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def find(root: Place, path: tuple[str, ...]) -> Place:
    """Return the place of a value.

    Raises:
        NoPath: There is none.
    """
    place = root
    for number, part in enumerate(path):
        before = ".".join(path[:number]) or "the file"
        if place.fields is not None:
            following = place.fields.get(part)
            if following is None:
                near = get_close_matches(part, place.fields, 1, 0.6)
                raise NoPath(f"there is no `{part}` in {before}", near[0] if near else "")
        else:
            following = _element(place, part, before)
        place = following
    return place


def exact(root: Place, path: tuple[str, ...]) -> tuple[str, ...]:
    """Return a path that names something, with numbers in place of the letters of axes."""
    found: list[str] = []
    for number, part in enumerate(path):
        listed = find(root, path[:number]).fields is None
        found.append(str(AXES.index(part) + 1) if listed and part in AXES else part)
    return tuple(found)


def _is_value(place: Place, text: str) -> bool:
    """Return whether a place has a value, and not a table of its own.

    Raises:
        NoPath: It is neither one value nor one table.
    """
    first = text[place.value[0] : place.value[0] + 1]
    if place.fields is not None:
        if first not in ("[", "{"):
            raise NoPath("it is written as keys with dots: name one of these")
        return first == "{"
    if any(item.fields is not None and text[item.value[0]] == "[" for item in place.items or ()):
        raise NoPath("there are several such tables: add the number of one, from 1 on")
    return True


def _element(place: Place, part: str, before: str) -> Place:
    items = place.items
    if items is None:
        raise NoPath(f"{before} is a single value: there is no `{part}` in it")
    if part in AXES:
        index = AXES.index(part)
    elif _INDEX.fullmatch(part):
        index = int(part) - 1
    else:
        raise NoPath(f"{before} is a list: write a number from 1 on, or x, y, z")
    if index >= len(items):
        raise NoPath(f"{before} has {len(items)}: there is no `{part}` in it")
    return items[index]


def _headers(place: Place, text: str) -> Iterator[int]:
    """Yield where headers of tables begin."""
    for inner in (*(place.fields or {}).values(), *(place.items or ())):
        if inner.fields is not None and text.startswith("[", inner.value[0]):
            yield inner.value[0]
        yield from _headers(inner, text)


def _tables(place: Place, headers: list[int], text: str) -> Iterator[Range]:
    """Yield the ranges of a table, or of tables of one name, with all tables in them."""
    own = set(_headers(place, text))
    if place.fields is not None and text.startswith("[", place.value[0]):
        own.add(place.value[0])
    for start in sorted(own):
        following = next((at for at in headers if at > start), len(text))
        end = following if following == len(text) else _before(following, text)
        yield _before(start, text), end


def _before(at: int, text: str) -> int:
    """Return where a header begins with the comments directly above it."""
    start = text.rfind("\n", 0, at) + 1
    while start:
        above = text.rfind("\n", 0, start - 1) + 1
        if not text[above:start].lstrip().startswith("#"):
            break
        start = above
    return start


def _lines(place: Place, text: str) -> Range:
    """Return the lines of a key and its value."""
    start = text.rfind("\n", 0, place.key[0]) + 1
    end = text.find("\n", place.value[1])
    return start, len(text) if end < 0 else end + 1


def _joined(ranges: Iterable[Range]) -> Iterator[Range]:
    """Yield ranges in order, those that overlap as one."""
    last: Range | None = None
    for start, end in sorted(ranges):
        if last is not None and start <= last[1]:
            last = last[0], max(last[1], end)
            continue
        if last is not None:
            yield last
        last = start, end
    if last is not None:
        yield last
