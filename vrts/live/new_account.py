"""A local account, added from the command line while a server runs or not."""

from pathlib import Path

from vrts.live.lasting.clock import wall
from vrts.live.passwords import hashed
from vrts.live.settings import DATABASE
from vrts.live.store.accounts import add_account
from vrts.live.store.database import opened


def add_user(folder: Path, name: str, password: str, *, supervisor: bool) -> str:
    """Add a local account; return the name it has.

    Raises:
        ValueError: The name cannot be shown, or is taken.
    """
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    kept = hashed(password)
    connection = opened(folder / DATABASE)
    try:
        return add_account(connection, name, wall(), password=kept, supervisor=supervisor).name
    finally:
        connection.close()
