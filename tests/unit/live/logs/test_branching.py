"""A private room stands exactly where the session stood that it goes on from, and goes on alone."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from tests.unit.live.session.again.test_carrying_on import carried, told
from tests.unit.live.session.again.test_replay import eventful
from tests.unit.live.session.support import Driven
from vrts.engine.run import Run
from vrts.live import actions as do
from vrts.live.logs.branching import begin_branch
from vrts.live.logs.logged_sessions import LogFault
from vrts.live.logs.unfinished import Unfinished, unfinished
from vrts.live.session.again.carrying_on import How
from vrts.live.session.channel.messages import Act
from vrts.live.session.live_session import Session
from vrts.live.store import log
from vrts.live.store.accounts import add_account
from vrts.live.store.branches import Branch, branch_of
from vrts.live.store.database import opened
from vrts.live.store.rooms import KeptRoom, keep_room, open_rooms

SCENE = "cans-on-bases"
ORIGIN = KeptRoom("origin", "Class", SCENE, 1, True, 0.0, 120.0)
OWN = KeptRoom("own", "Anna", SCENE, 2, True, 0.0, 120.0)


@pytest.fixture
def connection(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    found = opened(tmp_path / "live.sqlite")
    keep_room(found, ORIGIN)
    yield found
    found.close()


def put(connection: sqlite3.Connection, driven: Driven) -> int:
    """Log what a session did, in a room of its own; return the account that did it."""
    account = add_account(connection, "Anna", 0.0).id
    begun = msgspec.json.encode({"scene": SCENE}).decode()
    log.append(connection, log.Entry("origin", 7, 0.0, 1.0, "begin", True, None, "", begun))
    for entry in told(driven):
        order = entry.order
        action = order.action if isinstance(order, Act) else {"type": "panic"}
        kind = str(order.action.__struct_config__.tag) if isinstance(order, Act) else "panic"
        text = msgspec.json.encode({"action": action, "result": entry.done}).decode()
        accepted = entry.done is not None and entry.done.accepted
        row = log.Entry("origin", 7, entry.at_s, 2.0, kind, accepted, account, "Anna", text)
        log.append(connection, row)
    log.append(connection, log.Entry("origin", 7, 0.0, 3.0, "control", True, account, "Anna", "{}"))
    return account


def gone_on(
    connection: sqlite3.Connection, driven: Driven, folder: Path, at_s: float
) -> tuple[Session, Unfinished]:
    """Return the session of a private room that goes on from a moment."""
    account = put(connection, driven)
    begin_branch(connection, OWN, Branch("own", account, "origin", at_s), 99)
    assert log.verify(connection, "own") == ""
    before = unfinished(connection, "own", SCENE)
    assert before is not None
    assert before.until_s == at_s
    assert before.session.exact
    entries, until_s = before.session.entries, before.until_s
    return carried(driven, folder, entries, until_s, how=How.EXACT), before


def same(a: Run, b: Run, at_s: float) -> None:
    """Compare everything that is known of a moment, bit by bit."""
    first, second = a.at(at_s), b.at(at_s)
    for name in ("configuration", "velocity", "hand_opening", "poses", "variables", "signals"):
        assert repr(getattr(first, name)) == repr(getattr(second, name)), name
    for name in ("held", "X_WT", "base", "monitor_speed", "cause", "robot", "output"):
        assert repr(getattr(first, name)) == repr(getattr(second, name)), name


@pytest.mark.parametrize("share", [0.2, 0.437, 0.61, 0.83, 1.0])
def test_a_private_room_stands_where_the_session_stood(
    connection: sqlite3.Connection, tmp_path: Path, share: float
) -> None:
    (tmp_path / "first").mkdir()
    driven = Driven(tmp_path / "first")
    eventful(driven)
    at_s = share * driven.session.growing.time_s
    run = driven.session.run
    session, _ = gone_on(connection, driven, tmp_path / "own", at_s)
    assert session.growing.time_s == at_s
    same(session.run, run, at_s)
    same(session.run, run, 0.5 * at_s)
    assert [room.id for room in open_rooms(connection)] == ["origin", "own"]
    branch = branch_of(connection, "own")
    assert branch is not None
    assert (branch.origin, branch.at_s) == ("origin", at_s)

    before = driven.session.run.until_s
    session.go_on(at_s + 3.0)  # what is done in it changes nothing in the other
    assert session.at_rest
    assert driven.session.run.until_s == before


def test_a_moment_before_the_last_rewind_is_gone_back_to(
    connection: sqlite3.Connection, tmp_path: Path
) -> None:
    (tmp_path / "first").mkdir()
    driven = Driven(tmp_path / "first")
    eventful(driven)
    driven.act(do.Rewind(driven.session.now_s - 7.3))
    driven.run(0.5)
    driven.typed("DO DRIVE 1,-40,100", seconds=1.0)
    run = driven.session.run
    session, before = gone_on(connection, driven, tmp_path / "own", 9.25)
    last = before.session.entries[-1].order
    assert isinstance(last, Act)
    assert last.action == do.Rewind(9.25)
    same(session.run, run, 9.25)


def test_after_a_reset_only_what_came_then_is_gone_on_from(
    connection: sqlite3.Connection, tmp_path: Path
) -> None:
    (tmp_path / "first").mkdir()
    driven = Driven(tmp_path / "first")
    driven.typed("DO a = 5", "DO DRIVE 1,40,100", seconds=2.0)
    driven.act(do.Reset())
    driven.typed("DO DRIVE 2,20,100", "DO a = 6", seconds=2.0)
    run = driven.session.run
    session, before = gone_on(connection, driven, tmp_path / "own", 1.0)
    assert len(before.session.entries) == 4, "the last line came later"
    same(session.run, run, 1.0)
    assert session.run.at(1.0).variables == {"a": 5.0}


def test_who_was_purged_is_in_no_private_room(
    connection: sqlite3.Connection, tmp_path: Path
) -> None:
    (tmp_path / "first").mkdir()
    driven = Driven(tmp_path / "first")
    driven.run(0.5)
    driven.typed("DO a = 5", seconds=1.0)
    log.purge(connection, put(connection, driven))
    owner = add_account(connection, "Ben", 0.0).id
    with pytest.raises(LogFault, match="record 2 was purged"):
        begin_branch(connection, OWN, Branch("own", owner, "origin", 0.9), 99)
    begin_branch(connection, OWN, Branch("own", owner, "origin", 0.4), 99)


def test_where_no_session_is_there_is_nothing_to_go_on_from(
    connection: sqlite3.Connection,
) -> None:
    owner = add_account(connection, "Ben", 0.0).id
    with pytest.raises(LogFault, match="there is no session"):
        begin_branch(connection, OWN, Branch("own", owner, "origin", 1.0), 99)
    begun = log.Entry("origin", 7, 0.0, 1.0, "begin", True, None, "", '{"scene":"another"}')
    log.append(connection, begun)
    with pytest.raises(LogFault, match="another scene"):
        begin_branch(connection, OWN, Branch("own", owner, "origin", 1.0), 99)
