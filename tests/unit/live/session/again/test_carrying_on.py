"""A session that goes on in another process, from its log."""

from collections.abc import Sequence
from pathlib import Path

import msgspec
import pytest

from tests.unit.live.session.again.test_replay import eventful
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.again.carrying_on import (
    STOPPED,
    CannotCarryOn,
    How,
    Interrupted,
    Voice,
    carry_on,
    read_entries,
)
from vrts.live.session.channel.entries import Entry, write_entries
from vrts.live.session.channel.messages import Done
from vrts.live.session.live_session import Session


def told(driven: Driven) -> list[Entry]:
    """Return the log with what was answered, as the server keeps it."""
    answers = [done for done in driven.said(Done) if done.counts]
    return [entry._replace(done=d) for entry, d in zip(driven.log, answers, strict=True)]


def carried(
    driven: Driven,
    folder: Path,
    entries: Sequence[Entry],
    until_s: float,
    *,
    how: How = How.STOPPED,
) -> Session:
    """Carry the session on in another folder; time goes on from 5000 s of another clock."""
    voice = Voice()
    start = msgspec.structs.replace(driven.start, folder=str(folder))
    folder.mkdir()
    session = Session(start, driven.session.setting, voice, lambda: 5000.0)
    carry_on(session, voice, entries, until_s, how=how)
    return session


def lines(session: Session) -> dict[str, tuple[str, ...]]:
    """Return the programs in memory."""
    return {p.name: p.lines for p in session.conversation.monitor.desk.programs.values()}


def test_everything_is_where_it_was_after_reset_and_rewind_too(tmp_path: Path) -> None:
    (tmp_path / "first").mkdir()
    driven = Driven(tmp_path / "first")
    eventful(driven)
    driven.act(do.Rewind(driven.session.now_s - 7.3))
    driven.act(do.Save("lesson"))
    driven.run(0.5)
    driven.act(do.Reset())
    driven.typed("DO SPEED 30 ALWAYS", "DO DRIVE 1,-40,100", seconds=0.3)
    entries = told(driven)
    write_entries(tmp_path / "before.jsonl", entries)
    assert read_entries(tmp_path / "before.jsonl") == entries
    assert not (tmp_path / "before.jsonl").exists()

    before = driven.session
    session = carried(driven, tmp_path / "second", entries, before.growing.time_s)
    assert session.growing.time_s == before.growing.time_s
    assert session.growing.configuration == before.growing.configuration
    assert session.growing.moving
    state, was = session.run.at(session.growing.time_s), before.run.at(before.growing.time_s)
    assert state.variables == was.variables
    assert state.poses == was.poses
    assert lines(session) == lines(before)
    assert list(lines(session)) == ["wave", "lesson"]
    assert (tmp_path / "second/ada/lesson.v2").read_bytes() == (
        tmp_path / "first/ada/lesson.v2"
    ).read_bytes()
    assert session.now_s == before.growing.time_s, "the clock goes on from there"
    assert session.showing.snapshot(0).events[-1].text == STOPPED
    session.go_on(session.growing.time_s + 1.0)
    assert not session.growing.moving
    assert not session.growing.executing


def test_it_goes_on_to_the_time_that_was_reached(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.typed("DO DRIVE 1,-40,20", seconds=2.0)
    session = carried(driven, tmp_path / "second", told(driven), 1.25)
    assert session.growing.time_s == 1.25
    assert session.growing.configuration == driven.session.run.at(1.25).configuration


def test_other_answers_are_noticed(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.typed("DO a = 1", "LISTR a", seconds=0.5)
    entries = told(driven)
    other = [
        entries[0]._replace(order=msgspec.structs.replace(entries[0].order, action=do.Typed("")))
    ]
    with pytest.raises(CannotCarryOn, match="other results"):
        carried(driven, tmp_path / "second", [*other, *entries[1:]], 2.0)
    with pytest.raises(CannotCarryOn, match="does not fit"):
        carried(driven, tmp_path / "third", driven.log[::-1], 2.0)


def test_it_ends_when_nobody_waits_or_it_takes_too_long(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    driven = Driven(tmp_path)
    session = Session(driven.start, driven.session.setting, voice := Voice(), lambda: 0.0)
    with pytest.raises(Interrupted):
        carry_on(session, voice, (), 100.0, wanted=lambda: False)
    monkeypatch.setattr("vrts.live.session.again.carrying_on.LONGEST", -1.0)
    with pytest.raises(CannotCarryOn, match="too long"):
        carry_on(session, voice, (), 100.0)


def test_a_log_that_cannot_be_read_is_said_to_be_none(tmp_path: Path) -> None:
    (tmp_path / "before.jsonl").write_text("[1.0,{}]\n")
    with pytest.raises(CannotCarryOn, match="cannot be read"):
        read_entries(tmp_path / "before.jsonl")
