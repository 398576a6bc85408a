"""What `vrts serve` does to a folder's ways in from the command line, and ends."""

from pathlib import Path
from typing import NamedTuple

from vrts.cli.shared.console import WRONG, fail, out, say
from vrts.live.lasting.clock import wall


class Change(NamedTuple):
    """What is wanted; nothing: a list."""

    renew: bool
    end: str  # id; empty: none
    away: bool
    link: bool  # a supervisor's


def change_ways_in(folder: Path, change: Change) -> None:
    """Do what is wanted, or list the ways in."""
    from vrts.live.entrance import by_hand
    from vrts.live.entrance.class_code import kept_code
    from vrts.live.settings import DATABASE
    from vrts.live.store.database import opened
    from vrts.live.store.links import links
    from vrts.live.store.rooms import open_rooms
    from vrts.live.tokens import grouped

    if not (folder / DATABASE).is_file():
        fail(f"there is no server's database in `{folder}`")
    connection, now = opened(folder / DATABASE), wall()
    try:
        if change.end and not by_hand.end(folder, connection, change.end, now, away=change.away):
            fail(f"there is no way in called `{change.end}`", ("`--ways-in` lists them",), WRONG)
        if change.end:
            say(f"`{change.end}` lets nobody in any more")
        if change.renew:
            code = by_hand.fresh_code(folder, connection, now, away=change.away)
            out(f"class code: {grouped(code)}")
        if change.link:
            token = by_hand.supervisor_link(connection, now)
            out(f"supervisor, once, after the server's address: /#enter={token}")
        if not (change.end or change.renew or change.link):
            rooms = {room.id: room.name for room in open_rooms(connection)}
            code = grouped(kept_code(folder))
            for found in links(connection, now):
                out(by_hand.words(found, code, rooms))
    finally:
        connection.close()
