"""Private rooms stay private, also when their owner is purged."""

from pathlib import Path

from vrts.live.store import log
from vrts.live.store.accounts import add_account
from vrts.live.store.branches import Branch, branch_of, keep_branch
from vrts.live.store.database import opened


def test_a_private_room_stays_private_when_its_owner_is_purged(tmp_path: Path) -> None:
    connection = opened(tmp_path / "live.sqlite")
    owner = add_account(connection, "Anna", 0.0).id
    keep_branch(connection, Branch("room", owner, "origin", 12.4))
    assert branch_of(connection, "room") == Branch("room", owner, "origin", 12.4)
    assert branch_of(connection, "origin") is None
    log.purge(connection, owner)
    assert branch_of(connection, "room") == Branch("room", None, "origin", 12.4)
    connection.close()
