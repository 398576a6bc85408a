"""Who in a class is which line of a teacher's file: by ids, then address or login, then name."""

import unicodedata
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from vrts.marking.row import Row


class Line(NamedTuple):
    """A student as a file tells."""

    row: int  # of the sheet
    name: str
    ids: Mapping[str, str]  # by platform
    logins: frozenset[str] = frozenset()  # addresses and logins


class Matches(NamedTuple):
    """Lines with their rows of the class."""

    pairs: tuple[tuple[Line, Row], ...]  # in the order of the lines
    by_name: tuple[tuple[Line, Row], ...]  # those of them that only a name tells
    lines: tuple[Line, ...]  # of nobody in the class
    rows: tuple[Row, ...]  # that no line is about


def match(lines: Sequence[Line], rows: Sequence[Row]) -> Matches:
    """Return who is who; what is not unique is left out on both sides."""
    found: dict[int, Row] = {}
    named: list[tuple[Line, Row]] = []
    for of_line, of_row, is_name in (
        (_line_ids, _row_ids, False),
        (_line_logins, _row_logins, False),
        (_line_name, _row_name, True),
    ):
        taken = {row.id for row in found.values()}
        open_lines = [line for line in lines if line.row not in found]
        open_rows = [row for row in rows if row.id not in taken]
        pairs = list(_unique(open_lines, open_rows, of_line, of_row))
        found.update({line.row: row for line, row in pairs})
        if is_name:
            named = pairs
    matched = {row.id for row in found.values()}
    return Matches(
        tuple((line, found[line.row]) for line in lines if line.row in found),
        tuple(named),
        tuple(line for line in lines if line.row not in found),
        tuple(row for row in rows if row.id not in matched),
    )


def _unique(
    lines: Iterable[Line],
    rows: Iterable[Row],
    of_line: Callable[[Line], Iterable[str]],
    of_row: Callable[[Row], Iterable[str]],
) -> Iterator[tuple[Line, Row]]:
    """Yield pairs that share a key which nobody else has, and that nothing contradicts."""
    by_key: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        for key in set(of_row(row)):
            by_key[key].append(row)
    wanted: dict[int, dict[str, Row]] = {}
    users: dict[str, list[Line]] = defaultdict(list)
    for line in lines:
        candidates: dict[str, Row] = {}
        for key in set(of_line(line)):
            candidates.update({row.id: row for row in by_key[key]})
        wanted[line.row] = candidates
        for name in candidates:
            users[name].append(line)
    for line in (line for line in lines if len(wanted[line.row]) == 1):
        (row,) = wanted[line.row].values()
        if len(users[row.id]) == 1 and not _contradicts(line, row):
            yield line, row


def _contradicts(line: Line, row: Row) -> bool:
    """Return whether both have an id of one platform, and not the same."""
    ids = row.student.ids
    return any(platform in ids and ids[platform] != value for platform, value in line.ids.items())


def _line_ids(line: Line) -> Iterator[str]:
    return (f"{platform} {value}" for platform, value in line.ids.items() if value)


def _row_ids(row: Row) -> Iterator[str]:
    return (f"{platform} {value}" for platform, value in row.student.ids.items() if value)


def _line_logins(line: Line) -> Iterator[str]:
    return (login.casefold() for login in line.logins if login)


def _row_logins(row: Row) -> Iterator[str]:
    student = row.student
    return (text.casefold() for text in (student.email, student.login, row.id) if text)


def _line_name(line: Line) -> Iterator[str]:
    return _words(line.name)


def _row_name(row: Row) -> Iterator[str]:
    return _words(row.student.name)


def _words(name: str) -> Iterator[str]:
    """Yield a name as its words, in any order, without marks on letters; nothing for none."""
    plain = unicodedata.normalize("NFKD", name.casefold())
    letters = "".join(c if c.isalnum() else " " for c in plain if not unicodedata.combining(c))
    words = sorted(letters.split())
    if words:
        yield " ".join(words)
