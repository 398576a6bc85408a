"""Where files about a person lie: what they handed in, what was published for them, reports."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.course.course import HANDED_IN, HANDING
from vrts.course.handing.deposit import PENDING, HandIn
from vrts.course.handing.names import folder_of, page_of
from vrts.course.handing.published import PUBLISHED
from vrts.live.personal.names import Names, accounts_of
from vrts.live.store.course.attempts import Attempt, all_attempts, attempts_of
from vrts.live.store.course.people import person_of
from vrts.live.store.database import Connection


class Whose(NamedTuple):
    """A person, as files name them."""

    accounts: tuple[int, ...]
    folders: tuple[str, ...]  # that their hand-ins lie in
    programs: frozenset[tuple[str, str]]  # assignment, and page about a program of theirs alone
    listed: bool  # whether the list of the class names them


class Kept(NamedTuple):
    """A file about a person."""

    path: Path
    name: str  # in what is handed out


def whose(connection: Connection, name: str) -> Whose:
    """Return what files call a person, from the server's database."""
    accounts = accounts_of(connection, Names(name))
    people = [person for one in accounts if (person := person_of(connection, one)) is not None]
    own = {_page(a) for one in accounts for a in attempts_of(connection, one)}
    others = {_page(a) for a in all_attempts(connection) if a.account not in accounts}
    folders = tuple(dict.fromkeys(folder_of(one.key, one.email) for one in people))
    listed = any(one.listed and one.rank == "student" for one in people)
    return Whose(tuple(accounts), folders, frozenset(own - others), listed)


def files_of(course: Path, server: Path, who: Whose) -> Iterator[Kept]:
    """Yield every file about a person.

    Args:
        course: Folder of the course.
        server: Folder of the server.
        who: The person.
    """
    for folder in who.folders:
        for home in (HANDED_IN, PUBLISHED):
            depth = "*" if home == HANDED_IN else "*/*"
            for own in sorted((course / home).glob(f"{depth}/{folder}")):
                yield from _below(own, f"{home}/{own.parent.relative_to(course / home)}")
    for path in sorted((course / HANDED_IN / PENDING).glob("*.json")):
        if _is_of(path, who):
            yield Kept(path, f"{HANDED_IN}/waiting/{path.name}")
    for assignment, page in sorted(who.programs):
        for path in sorted((server / HANDING).glob(f"*/*/{page}")):
            if path.is_file() and path.parent.name == assignment:
                yield Kept(path, f"reports/{assignment}/{path.name}")


def _page(attempt: Attempt) -> tuple[str, str]:
    return attempt.assignment, page_of(attempt.digest, attempt.variant)


def _below(own: Path, name: str) -> Iterator[Kept]:
    for path in sorted(own.rglob("*")):
        if path.is_file() and not path.is_symlink():
            yield Kept(path, f"{name}/{path.relative_to(own)}")


def _is_of(path: Path, who: Whose) -> bool:
    hand_in = msgspec.json.decode(path.read_bytes(), type=HandIn)
    return hand_in.by in who.accounts or any(one in who.accounts for one, _ in hand_in.people)
