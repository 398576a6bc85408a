"""The ways in as they are changed from the command line, while a server runs or not.

A server that runs takes over what was changed within a second or so.
"""

import contextlib
import time
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from vrts.live.entrance.class_code import FILE, keep_code, kept_code
from vrts.live.entrance.guessing import length_after
from vrts.live.store import links
from vrts.live.store.accounts import ONCE_S, add_link
from vrts.live.store.database import Connection
from vrts.live.store.links import KeptLink
from vrts.live.tokens import digest, new_code, new_token


def working_code(folder: Path, connection: Connection, now: float, *, wanted: bool) -> str:
    """Return the class code that lets in: the one of before, or else a new one; empty: none."""
    kept = kept_code(folder) if wanted else ""
    long_enough = length_after(links.wrong_guesses(connection)) <= len(kept)
    if kept and long_enough and links.code_now(connection) == digest(kept):
        return kept
    return fresh_code(folder, connection, now) if wanted else no_code(folder, connection, now)


def fresh_code(folder: Path, connection: Connection, now: float, *, away: bool = False) -> str:
    """Have another class code, and return it; the one of before ends."""
    text = new_code(length_after(links.wrong_guesses(connection)))
    keep_code(folder, text)
    links.replace_code(connection, text, now, away=away)
    return text


@contextmanager
def code_or_as_before(folder: Path) -> Generator[None]:
    """Put the file with the class code back when what is done to the database meanwhile fails."""
    path = folder / FILE
    before = path.read_bytes() if path.is_file() else b""
    try:
        yield
    except BaseException:
        now = path.read_bytes() if path.is_file() else b""
        if now != before:
            with contextlib.suppress(OSError):
                keep_code(folder, before.decode("utf-8", "replace").strip())
        raise


def no_code(folder: Path, connection: Connection, now: float, *, away: bool = False) -> str:
    """Have no class code; the one of before ends."""
    keep_code(folder, "")
    links.replace_code(connection, "", now, away=away)
    return ""


def supervisor_link(connection: Connection, now: float) -> str:
    """Return the token of a link that lets a supervisor in, once."""
    token = new_token()
    add_link(connection, token, now + ONCE_S, supervisor=True, name="supervisor", made=now)
    return token


def end(folder: Path, connection: Connection, id_: str, now: float, *, away: bool) -> bool:
    """End a link, or the class code; return whether there was one of that name."""
    found = links.link(connection, id_, now)
    if found is None:
        return False
    if found.code:
        no_code(folder, connection, now, away=away)
    else:
        links.end_link(connection, id_, now, away=away)
    return True


def words(found: KeptLink, code: str, rooms: dict[str, str]) -> str:
    """Return a line about a way in.

    Args:
        found: The link, or the class code.
        code: The class code as it is shown.
        rooms: Names of rooms.
    """
    if found.code:
        what = f"class code {code}"
    elif found.supervisor:
        what = "supervisor, once"
    else:
        what = f"link into {rooms.get(found.room or '', 'a room')}"
    made = time.strftime("%Y-%m-%d %H:%M", time.localtime(found.made)) if found.made else "before"
    return f"{found.id}  {what}, made {made}, entries: {found.used}, still there: {found.inside}"
