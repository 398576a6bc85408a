"""What `vrts serve` does to a folder's ways in from the command line, and ends."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from vrts.cli.shared.console import WRONG, fail, out, say
from vrts.live.lasting.clock import wall

if TYPE_CHECKING:
    from vrts.live.store.database import Connection


class Change(NamedTuple):
    """What is wanted; nothing: a list."""

    renew: bool
    end: str  # id; empty: none
    away: bool
    link: bool  # a supervisor's


def change_ways_in(folder: Path, change: Change) -> None:
    """Do all that is wanted or nothing of it, or list the ways in.

    Raises:
        CannotRead: The database is of no use, or does not take it.
    """
    from vrts.live.settings import DATABASE
    from vrts.live.store.database import opened
    from vrts.live.store.unusable import in_one_sentence, require_ours, require_whole

    path = folder / DATABASE
    if not path.is_file():
        fail(f"there is no server's database in `{folder}`")
    with in_one_sentence(path):
        require_ours(path)
        require_whole(path)
        connection = opened(path)
        try:
            if change.end or change.renew or change.link:
                _change(folder, connection, change)
            else:
                _list(folder, connection)
        finally:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            connection.close()


def _change(folder: Path, connection: "Connection", change: Change) -> None:
    """Do what is wanted in one transaction, and tell of it when it is done."""
    from vrts.live.entrance.by_hand import code_or_as_before

    with code_or_as_before(folder):
        connection.execute("BEGIN IMMEDIATE")
        told = list(_changed(folder, connection, change))
        connection.execute("COMMIT")
    if change.end:
        say(f"`{change.end}` lets nobody in any more")
    for line in told:
        out(line)


def _changed(folder: Path, connection: "Connection", change: Change) -> Iterator[str]:
    """Do what is wanted, and yield what to tell of it."""
    from vrts.live.entrance import by_hand
    from vrts.live.tokens import grouped

    now = wall()
    if change.end and not by_hand.end(folder, connection, change.end, now, away=change.away):
        fail(f"there is no way in called `{change.end}`", ("`--ways-in` lists them",), WRONG)
    if change.renew:
        code = by_hand.fresh_code(folder, connection, now, away=change.away)
        yield f"class code: {grouped(code)}"
    if change.link:
        token = by_hand.supervisor_link(connection, now)
        yield f"supervisor, once, after the server's address: /#enter={token}"


def _list(folder: Path, connection: "Connection") -> None:
    from vrts.live.entrance import by_hand
    from vrts.live.entrance.class_code import kept_code
    from vrts.live.store.links import links
    from vrts.live.store.rooms import open_rooms
    from vrts.live.tokens import grouped

    rooms = {room.id: room.name for room in open_rooms(connection)}
    code = grouped(kept_code(folder))
    for found in links(connection, wall()):
        out(by_hand.words(found, code, rooms))
