"""Forgets a person in a course: the files first, and then what the server keeps.

In this order whatever interrupts it is made up for by doing it again: while the server's rows are
there, files are found by them.
"""

from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.course.course import HANDED_IN
from vrts.course.handing.deposit import PENDING, HandIn
from vrts.course.handing.published import PUBLISHED
from vrts.course.personal.files import Whose, files_of, whose
from vrts.live.personal.purging import Forgotten, purge
from vrts.live.settings import DATABASE
from vrts.live.store.database import read_only
from vrts.pipeline.files import CannotRead


class ForgottenHere(NamedTuple):
    """What became of it."""

    server: Forgotten
    files: int  # of the course
    listed: bool  # whether the class list named them, who would get a new account by it


def forget(
    course: Path, server: Path, name: str, key: Path | None = None, *, mentions: bool = False
) -> ForgottenHere:
    """Forget all accounts of a name, their hand-ins and what was published for them.

    What a team handed in stays with the others of the team.

    Args:
        course: Folder of the course.
        server: Folder of the server, which may run meanwhile.
        name: Of the person.
        key: File with the key of the logs, if not the usual one.
        mentions: As for `vrts.live.personal.purging.purge`.

    Raises:
        CannotRead: The database cannot be read, or no key of the logs fits.
        OSError: A file cannot be removed; to do it again goes on from there.
    """
    try:
        with read_only(server / DATABASE) as connection:
            who = whose(connection, name)
    except ValueError as problem:
        raise CannotRead(f"cannot read the database: {problem}") from problem
    count = 0
    for file in list(files_of(course, server, who)):
        if file.path.parent.name == PENDING:
            _leave(file.path, who)
        else:
            file.path.unlink(missing_ok=True)
        count += 1
    for folder in who.folders:
        for home, depth in ((HANDED_IN, "*"), (PUBLISHED, "*/*")):
            for own in (course / home).glob(f"{depth}/{folder}"):
                _remove_empty(own)
    return ForgottenHere(purge(server, name, key, mentions=mentions), count, who.listed)


def _leave(path: Path, who: Whose) -> None:
    """Take somebody out of a hand-in that waits to be put in its place."""
    hand_in = msgspec.json.decode(path.read_bytes(), type=HandIn)
    others = tuple(one for one in hand_in.people if one[0] not in who.accounts)
    if not others:
        path.unlink()
        return
    by = others[0][0] if hand_in.by in who.accounts else hand_in.by
    left = msgspec.structs.replace(hand_in, people=others, by=by)
    part = path.with_suffix(".part")
    part.write_bytes(msgspec.json.encode(left))
    part.replace(path)


def _remove_empty(own: Path) -> None:
    if own.is_symlink() or not own.is_dir():
        return
    for folder in sorted((p for p in own.rglob("*") if p.is_dir()), reverse=True):
        folder.rmdir()
    own.rmdir()
