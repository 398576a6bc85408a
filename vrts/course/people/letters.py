"""Personal links from the command line, and who is who there, while a server runs or not."""

import time
from collections.abc import Iterable
from pathlib import Path
from typing import Final, NamedTuple

from vrts.course.people.following import follow
from vrts.course.people.sources import Read
from vrts.live.lasting.clock import wall
from vrts.live.settings import DATABASE
from vrts.live.store.course.letters import end_letter, has_letter, has_password, new_letter
from vrts.live.store.course.people import Person, people
from vrts.live.store.database import opened, read_only
from vrts.live.store.rooms import open_rooms
from vrts.report.formats.csv_field import text_field

ADDRESS: Final = "address.txt"  # in the server's folder: where browsers found it last


class NoSuchPerson(Exception):  # noqa: N818 -- names the situation
    """Nobody of the course is called so."""


class Letter(NamedTuple):
    """A link for somebody."""

    name: str
    email: str
    token: str


def keep_address(server: Path, address: str) -> None:
    """Keep where browsers find a server, for links that are made while it does not run."""
    (server / ADDRESS).write_text(f"{address}\n", "utf-8")


def kept_address(server: Path) -> str:
    """Return where browsers found a server last; empty: that is not known."""
    try:
        return (server / ADDRESS).read_text("utf-8").strip()
    except FileNotFoundError:
        return ""


def letters(read: Read, server: Path, again: Iterable[str] = ()) -> list[Letter]:
    """Make links for who has none and no password, or anew for those who are named.

    Args:
        read: What the files of the course say, without faults.
        server: Folder of the server; a database is made where there is none.
        again: Names or e-mail addresses; empty: everybody who has not come in.

    Raises:
        NoSuchPerson: One of them is not in the course.
    """
    server.mkdir(mode=0o700, parents=True, exist_ok=True)
    now, named = wall(), tuple(again)
    connection = opened(server / DATABASE)
    try:
        connection.execute("BEGIN IMMEDIATE")
        rooms: dict[str, tuple[str, ...]] = {}
        for room in open_rooms(connection):
            rooms[room.name] = (*rooms.get(room.name, ()), room.id)
        follow(connection, read.people, rooms, now)
        listed = [one for one in people(connection) if one.listed]
        if named:
            wanted = [_named(listed, name) for name in named]
        else:
            wanted = [
                one
                for one in listed
                if one.subject is None
                and not has_password(connection, one.account)
                and not has_letter(connection, one.account, now)
            ]
        made = [
            Letter(one.name, one.email, new_letter(connection, one.account, now)) for one in wanted
        ]
        connection.execute("COMMIT")
        return made
    finally:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        connection.close()


def take_back(server: Path, made: Iterable[Letter]) -> None:
    """End links that could not be handed out."""
    connection = opened(server / DATABASE)
    try:
        for one in made:
            end_letter(connection, one.token)
    finally:
        connection.close()


def table_of(made: Iterable[Letter], address: str) -> bytes:
    """Return the table with links, as spreadsheets and mail merges read it."""
    lines = ["name,email,link"]
    for one in made:
        link = f"{address}/course/first#{one.token}"
        lines.append(f"{text_field(one.name)},{text_field(one.email)},{link}")
    return ("\n".join(lines) + "\n").encode()


def standing(server: Path) -> list[tuple[str, ...]]:
    """Return who is in a course as the server knows them; empty: it has not started yet."""
    if not (server / DATABASE).is_file():
        return []
    with read_only(server / DATABASE) as connection:
        seen = dict(connection.execute("SELECT id, seen FROM account").fetchall())
        found = people(connection)
    return [_row(one, float(seen.get(one.account, 0.0))) for one in found]


def _row(one: Person, seen: float) -> tuple[str, ...]:
    last = time.strftime("%Y-%m-%d %H:%M", time.localtime(seen)) if seen else "never"
    rooms = ", ".join(one.rooms) or "all" if one.rank == "assistant" else ""
    added = "added in the page" if one.origin == "page" else ""
    more = added if one.listed else "on no list any more"
    return one.name, one.email, one.rank, rooms, one.team, last, more


def _named(listed: list[Person], name: str) -> Person:
    plain = " ".join(name.split()).casefold()
    for person in listed:
        if plain in (person.name.casefold(), person.email):
            return person
    raise NoSuchPerson(f"nobody in the course is called `{name}`")
