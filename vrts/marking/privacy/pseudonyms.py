"""Marking without names: ids that only the holder of a key can tell from others.

A pseudonym is the keyed digest of an identifier, so a student has the same one in every marking
with the same key, and nobody without the key can try out names. Names stand in `staff/names.csv`
only; what students write into their programs is theirs, and stays.
"""

import hmac
import os
import re
import secrets
from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from pathlib import Path, PurePosixPath

import msgspec

from vrts.base.diagnostic import Rule, error
from vrts.marking.about import About
from vrts.marking.intake.candidate import data_of
from vrts.marking.intake.row import Attempt, Kind, Problem, Row, Student
from vrts.marking.intake.tables.intake_table import COLUMNS, write_rows
from vrts.marking.intake.tables.table_text import Cell, read_text, table, table_bytes
from vrts.marking.intake.tree.opening import Tree
from vrts.marking.layout import STUDENTS, Layout
from vrts.marking.remote.names import KEPT_ENDINGS
from vrts.marking.row import Class
from vrts.marking.row import Student as Named
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused

BAD_KEY = Rule("V772", "pseudonym-key")
MIXED = Rule("V773", "names-and-pseudonyms")

KEY, NAMES = "pseudonyms.key", "names.csv"  # in `staff`
COLUMN = "pseudonym"
PRIVATE = 0o600
LETTERS = "bcdfghjklmnpqrstvwxz"  # no digits, which spreadsheets change; no vowels, so no words
LENGTH, GROUP = 12, 4  # letters: 52 bits

SENTENCES = {  # in place of ours, which name files
    Kind.MISSING: "nothing was handed in",
    Kind.EMPTY: "the file is empty",
    Kind.AMBIGUOUS: "several files could be the program, and nothing says which",
    Kind.NOT_TEXT: "the file is not plain text",
    Kind.TOO_LARGE: "the file is too large for a program",
    Kind.ARCHIVE: "the archive cannot be opened safely",
    Kind.UNREADABLE: "the file cannot be read",
    Kind.EXCUSED: "excused by the teacher",
}


def key_for(layout: Layout) -> bytes:
    """Return the key of a marking; where there is none it is drawn, and written for its owner only.

    Raises:
        Refused: The file is none of ours, or the folder has results with names.
    """
    path = layout.staff / KEY
    if not os.path.lexists(path):
        if layout.results.exists() or (layout.root / STUDENTS).exists():  # also of an early end
            raise _mixed(f"`{layout.root}` has results with names in it")
        layout.staff.mkdir(parents=True, exist_ok=True)
        write_private(path, f"{secrets.token_hex(32)}\n".encode())
    found = re.fullmatch(rb"([0-9a-f]{64})\n?", b"" if path.is_symlink() else read_bytes(path))
    if found is None:
        headline = f"`{path}` is no key that vrts has written"
        remedy = "put the file back as it was: with another key every student has another id"
        raise Refused((error(BAD_KEY, headline, help=(remedy,)),))
    return bytes.fromhex(found[1].decode())


def require_names(layout: Layout) -> None:
    """Refuse to mark with names where pseudonyms are.

    Raises:
        Refused: The folder has results with pseudonyms.
    """
    if os.path.lexists(layout.staff / KEY):
        raise _mixed(f"`{layout.root}` has results with pseudonyms in it")


def pseudonym(identifier: str, key: bytes) -> str:
    """Return what an identifier is called."""
    number = int.from_bytes(hmac.digest(key, identifier.encode(), sha256))
    letters = ""
    for _ in range(LENGTH):
        number, letter = divmod(number, len(LETTERS))
        letters += LETTERS[letter]
    return "-".join(letters[k : k + GROUP] for k in range(0, LENGTH, GROUP))


def pseudonymised(tree: Tree, rows: Sequence[Row], key: bytes) -> tuple[Tree, tuple[Row, ...]]:
    """Return a download and its rows without names: of persons, files and groups.

    Args:
        tree: The download; it has to stay open.
        rows: As they are to be marked, with the attempts that count.
        key: Of the marking.
    """
    nameless = tuple(_nameless(row, key) for row in rows)
    pairs = zip(nameless, rows, strict=True)
    files = {to.file: row.file for to, row in pairs if to.file is not None and row.file is not None}
    return Tree("submissions", _Renamed(tree, files), list(files), (), {}), nameless


def _nameless(row: Row, key: bytes) -> Row:
    identifier = pseudonym(row.identifier, key)
    file = None
    if row.file is not None:
        ending = PurePosixPath(row.file).suffix.lower()
        file = identifier + (ending if ending in KEPT_ENDINGS else "")
    return replace(
        row,
        identifier=identifier,
        student=Student(""),
        file=file,
        why="",
        attempts=tuple(Attempt(file or "", attempt.received) for attempt in row.attempts),
        others=(),
        tried=tuple(attempt._replace(file=file or "") for attempt in row.tried),
        group=pseudonym(f"group {row.group}", key) if row.group else "",
        problem=row.problem and Problem(row.problem.kind, SENTENCES[row.problem.kind]),
    )


class _Renamed:
    """The files of a download under other names."""

    def __init__(self, tree: Tree, files: Mapping[str, str]) -> None:
        self._tree = tree
        self._files = files

    def size(self, name: str) -> int:
        real = self._files[name]
        return self._tree.store.size(real) if real in self._tree.files else 0  # known when read

    def start(self, name: str, length: int) -> bytes:
        return self.read(name)[:length]

    def read(self, name: str) -> bytes:
        return data_of(self._tree, self._files[name])


# who is who


def names_table(rows: Sequence[Row], key: bytes) -> bytes:
    """Return the table of hand-ins with a column of pseudonyms, for those who may know."""
    lines = [[cell.text for cell in line] for line in _table(write_rows(rows))]
    whole = [[COLUMN, *lines[0]]]
    whole += [
        [pseudonym(row.identifier, key), *line] for row, line in zip(rows, lines[1:], strict=True)
    ]
    return table_bytes(whole)


def write_names(folder: Path, names: bytes) -> None:
    """Write who is who into a folder, for the owner only."""
    path = folder / NAMES
    draft = path.with_name(f"{NAMES}.part")
    write_private(draft, names)
    draft.replace(path)


def read_names(layout: Layout) -> dict[str, dict[str, str]]:
    """Return the lines of `names.csv` by pseudonym and column; none where it is not there."""
    path = layout.staff / NAMES
    if not path.is_file():
        return {}
    head, *lines = _table(read_bytes(path)) or [[]]
    columns = [cell.text.strip().casefold() for cell in head]
    found = [dict(zip(columns, (c.text for c in line), strict=False)) for line in lines]
    return {line[COLUMN]: line for line in found if line.get(COLUMN)}


def with_names(rows: Class, layout: Layout) -> Class:
    """Return the rows of a class with the students of `names.csv`; ids stay pseudonyms.

    For exports to the platforms, which know no pseudonyms. Rows that have names keep them.
    """
    names = read_names(layout)
    return msgspec.structs.replace(
        rows,
        rows=tuple(
            msgspec.structs.replace(row, student=_student(names[row.id]))
            if row.id in names
            else row
            for row in rows.rows
        ),
    )


def nameless_about(about: About) -> About:
    """Return what a marking was without names of files that were handed in one by one."""
    named = {text for text in about.submissions if not (Path(text).is_dir() or _is_zip(text))}
    return msgspec.structs.replace(
        about,
        submissions=tuple(text for text in about.submissions if text not in named),
        command=tuple(word for word in about.command if word not in named),
    )


def write_private(path: Path, data: bytes) -> None:
    """Write a new file that its owner alone may read; a draft of an earlier try is replaced."""
    path.unlink(missing_ok=True)
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0)
    with open(os.open(path, flags | getattr(os, "O_BINARY", 0), PRIVATE), "wb") as file:
        file.write(data)


def _table(data: bytes) -> list[list[Cell]]:
    return table(read_text(data, NAMES), (*COLUMNS, COLUMN))


def _student(line: Mapping[str, str]) -> Named:
    parts = [part.strip().partition(" ") for part in line.get("ids", "").split(";")]
    ids = {platform: value.strip() for platform, _, value in parts if value.strip()}
    return Named(line.get("name", ""), line.get("email", ""), line.get("login", ""), ids)


def _is_zip(text: str) -> bool:
    return Path(text).suffix.lower() == ".zip"


def _mixed(headline: str) -> Refused:
    remedy = "mark into another folder, or in the way of before"
    return Refused((error(MIXED, headline, help=(remedy,)),))
