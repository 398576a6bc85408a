"""What is older than ten minutes: gone back to from the file, exactly, and with an end."""

from pathlib import Path
from typing import Any

import pytest

from tests.support_saved import answers, plain, state_answers
from tests.unit.live.session.growing.test_growing_run import COMMANDS, SCENE
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Happened
from vrts.live.session.growing.folder import FILE, OFF
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.growing.past import FULL, Past
from vrts.live.session.views.program import as_program
from vrts.scene.model import Scenario

LOOP = """\
.PROGRAM busy()
10 DRIVE 1,20,100
   SIGNAL 3
   n = n + 1
   TYPE n
   DRIVE 1,-20,100
   SIGNAL -3
   GOTO 10
.END
"""


@pytest.fixture(autouse=True)
def _sooner(monkeypatch: pytest.MonkeyPatch) -> None:  # pyright: ignore[reportUnusedFunction]
    """Have what is older than 20 s leave memory, to states 12 s apart."""
    for name, seconds in (("REACH", 20.0), ("FORGETTING", 5.0), ("CHECKPOINT", 3.0)):
        monkeypatch.setattr(f"vrts.live.session.growing.growing_run.{name}", seconds)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.RECENT", 20.0)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.SPARSE", 12.0)


def grown(growing: GrowingRun, until_s: float) -> GrowingRun:
    waiting = [entry for entry in COMMANDS if entry[0] >= growing.time_s]
    while growing.time_s < until_s:
        following = min(growing.time_s + 0.05, until_s)
        while waiting and waiting[0][0] <= following:
            growing.advance(waiting[0][0])
            growing.issue(waiting.pop(0)[1])
        growing.advance(following)
    return growing


def kept(folder: Path, quota: int = 64_000_000) -> GrowingRun:
    return GrowingRun(SCENE, Scenario(), Past(folder, quota))


def same(growing: GrowingRun, whole: GrowingRun, time_s: float) -> None:
    """Compare everything that can be asked of one instant; programs may be other copies."""
    first, second = (state_answers(each.run.at(time_s)) for each in (growing, whole))
    assert second["output"].endswith(first["output"])  # type: ignore[attr-defined]
    assert {**first, "output": ""} == {**second, "output": ""}


@pytest.mark.thorough
def test_any_time_is_had_again_from_the_file(tmp_path: Path) -> None:
    whole = grown(GrowingRun(SCENE, Scenario(), forgets=False), 150.0)
    growing = grown(kept(tmp_path), 150.0)
    assert growing.known_from_s >= 120.0
    assert growing.reaches_s == 0.0
    for time_s in (118.3, 96.9, 95.35, 60.0, 33.3, 11.999, 0.05, 0.0):
        growing.rewind(time_s)
        whole.rewind(time_s)
        same(growing, whole, time_s)
        assert growing.known_from_s <= time_s
    grown(growing, 150.0)
    grown(whole, 150.0)
    for k in range(40):
        time_s = growing.known_from_s + (150.0 - growing.known_from_s) * k / 39
        same(growing, whole, time_s)
    growing.rewind(40.0)
    whole.rewind(40.0)
    same(growing, whole, 40.0)
    assert growing.said == []
    assert (tmp_path / FILE).stat().st_mode & 0o777 == 0o600


def test_what_loops_are_looked_for_with_is_not_kept(tmp_path: Path) -> None:
    past = Past(tmp_path)
    growing = grown(GrowingRun(SCENE, Scenario(), past), 150.0)
    assert growing.machine.watcher.kept is not None  # there is something to be left out
    _, machine, _ = past.state_before(100.0)
    assert machine.watcher.kept is None
    assert machine.watcher.idle is None


def test_the_whole_is_had_again_for_its_mark(tmp_path: Path) -> None:
    whole = grown(GrowingRun(SCENE, Scenario(), forgets=False), 130.0).run
    again = grown(kept(tmp_path), 130.0).run_since(0.0)
    assert again is not None
    assert answers(again) == answers(whole)
    assert state_answers(again.at(130.0)) == state_answers(whole.at(130.0))


def worked(driven: Driven, seconds: float) -> Driven:
    """Do a bit of everything by hand for a while."""
    end_s = driven.session.now_s + seconds
    k = 0
    while driven.session.now_s < end_s:
        k += 1
        driven.act(do.Step("joint", k % 3, 1 if k % 2 else -1, 0.1))
        driven.run(1.7)
        driven.act(do.Hand(open=bool(k % 2)))
        driven.run(1.1)
        if k % 4 == 0:
            driven.act(do.Jog("joint", 5, 1, 1.0))
            driven.run(0.1)
            driven.act(do.LetGo())
            driven.typed("SPEED 80", "SIGNAL 4", "SIGNAL -4", "DO a = 1")
    return driven


def test_all_that_was_done_can_be_saved_however_long_ago_it_was(tmp_path: Path) -> None:
    driven = worked(Driven(tmp_path), 90.0)
    assert driven.session.growing.known_from_s >= 60.0
    text = driven.session.program("all")
    run = replay(driven.start, driven.log, driven.session.growing.time_s)
    assert text == as_program(run, "all")
    assert text.count("OPEN") > 10
    assert driven.done(driven.act(do.Save("all"))).accepted


@pytest.mark.thorough
def test_a_session_that_went_far_back_is_repeated_by_its_log(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.act(do.Upload("busy.v2", LOOP))
    driven.run(0.1)
    driven.typed("DO n = 0", "EXECUTE busy,-1")
    driven.run(50.0)
    driven.typed("PANIC")
    worked(driven, 30.0)
    assert driven.session.growing.known_from_s > 50.0
    assert driven.done(driven.act(do.Rewind(31.7))).accepted
    driven.run(25.0)
    driven.typed("PANIC")
    worked(driven, 40.0)
    assert driven.done(driven.act(do.Rewind(5.0))).accepted
    driven.run(40.0)
    run = replay(driven.start, driven.log, driven.session.growing.time_s)
    now_s = driven.session.growing.time_s
    for k in range(20):
        time_s = now_s - k
        first, second = (plain(state_answers(r.at(time_s))) for r in (driven.session.run, run))
        assert isinstance(first, dict)
        assert isinstance(second, dict)
        assert {**first, "output": ""} == {**second, "output": ""}  # pyright: ignore[reportUnknownArgumentType]


@pytest.mark.thorough
def test_a_full_file_loses_what_is_oldest_and_says_so(tmp_path: Path) -> None:
    driven = worked(Driven(tmp_path, history=60_000), 200.0)
    growing = driven.session.growing
    assert 0.0 < growing.reaches_s < growing.known_from_s
    assert (tmp_path / FILE).stat().st_size <= 60_000
    said = [text for text in driven.texts(Happened) if "nobody can go back before" in text]
    assert said
    assert "full" in said[0]
    refused = driven.done(driven.act(do.Rewind(growing.reaches_s - 1.0)))
    assert not refused.accepted
    assert f"from {growing.reaches_s:.0f} to" in refused.text
    saved = driven.done(driven.act(do.Save("all")))
    assert (saved.accepted, saved.code) == (False, "time")
    whole = replay(driven.start, driven.log, growing.time_s)
    at_s = growing.reaches_s + 0.7
    assert driven.done(driven.act(do.Rewind(at_s))).accepted
    assert driven.session.run.at(at_s).configuration == whole.at(at_s).configuration


def test_the_quota_is_reached_before_the_limit_of_the_system(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    longest = 0

    def written(past: Past, record: Any, data: bytes) -> None:
        nonlocal longest
        longest = max(longest, record.at + len(data))
        writes(past, record, data)

    writes = Past._write  # pyright: ignore[reportPrivateUsage]
    monkeypatch.setattr(Past, "_write", written)
    growing = grown(kept(tmp_path, 40_000), 150.0)
    assert 20_000 < longest <= 40_000, "the file is never longer, not even for a moment"
    assert FULL in growing.said[-1]


@pytest.mark.thorough
def test_a_file_that_is_gone_or_changed_ends_no_session(tmp_path: Path) -> None:
    driven = worked(Driven(tmp_path), 60.0)
    path = tmp_path / FILE
    path.write_bytes(path.read_bytes()[::-1])
    assert driven.done(driven.act(do.Rewind(1.0))).code == "time"
    assert driven.session.growing.reaches_s == driven.session.growing.known_from_s > 0.0
    worked(driven, 30.0)
    assert any("history of this session" in text for text in driven.texts(Happened))
    assert not driven.session.growing.knows_all
    driven.act(do.Reset())
    worked(driven, 60.0)
    assert driven.session.growing.reaches_s == 0.0, "after a reset it is kept again"
    path.with_name(OFF).touch()  # by a purge
    worked(driven, 30.0)
    assert not path.exists()
    assert driven.done(driven.act(do.Rewind(driven.session.growing.known_from_s))).accepted
