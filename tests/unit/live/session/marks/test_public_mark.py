"""The public mark of a session while it goes on."""

import re
import shutil
from contextlib import closing
from pathlib import Path

import msgspec
import pytest

from tests.unit.live.session.marks.answering import answered
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import AskSnapshot, Checked, Marked, Snapshot, Status
from vrts.live.session.marks.checker import Checker
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.settings import load_task
from vrts.report.page.viewer_data import scene_data
from vrts.report.plain import capital
from vrts.report.quantities import lost

EXAMPLE = Path("examples/01-cans-on-bases")
HIDDEN = """\
[[limit]]
joint_percent = 1
"""
RUNS = "The program still runs: what is not reached yet counts as lost"
SECRETS = """\
[[zone]]
name = "passwort"
from_mm = [987.25, -900, -900]
to_mm = [990, 900, 900]

[[via]]
name = "geheim"
at_mm = [987.25, 0, 0]
"""


def until(driven: Driven, checker: Checker, mark: float | None) -> None:
    """Let time pass until the session shows a mark of what has come to rest."""
    for _ in range(1500):
        driven.run(0.5, beat_s=0.1)
        checker.beat()
        marked = driven.session.showing.marked
        goes_on = marked is not None and any(row.text == RUNS for row in marked.lost)
        if driven.session.showing.mark == mark and driven.session.at_rest and not goes_on:
            driven.run(0.1)
            return
        answered(checker)
    raise AssertionError(f"the mark is {driven.session.showing.mark}, not {mark}")


@pytest.mark.thorough
@pytest.mark.parametrize("forks", [True, False])
def test_it_follows_what_is_done_and_begins_anew_with_a_reset(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, forks: bool
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.REST", 0.0)
    monkeypatch.setattr("vrts.live.session.marks.public_mark.REST", 0.0)
    driven = Driven(tmp_path, "", task=str(EXAMPLE / "task.toml"))
    with closing(Checker(driven.session, forks=forks)) as checker:
        until(driven, checker, 0.0)
        solution = (EXAMPLE / "solution.v2").read_text()
        driven.act(do.Upload("solution.v2", solution))
        driven.typed("EXECUTE main", seconds=0.1)
        until(driven, checker, 10.0)
        assert driven.said(Status)[-1].mark == 10.0
        marks = [news.mark for news in driven.said(Checked)]
        assert marks[0] == 0.0
        assert 10.0 in marks
        driven.act(do.Reset())
        driven.run(0.1)
        until(driven, checker, 0.0)


def test_hidden_checks_do_not_appear(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE, tmp_path / "task")
    (tmp_path / "task/staff").mkdir()
    (tmp_path / "task/staff/task.toml").write_text(HIDDEN)
    (tmp_path / "session").mkdir()
    whole = load_task(tmp_path / "task/task.toml", staff=True).task
    assert whole is not None
    assert whole.demands
    driven = Driven(tmp_path / "session", "", task=str(tmp_path / "task/task.toml"))
    assert driven.session.setting.task is not None
    assert not driven.session.setting.task.demands
    with closing(Checker(driven.session, forks=False)) as checker:
        driven.act(do.Upload("solution.v2", (EXAMPLE / "solution.v2").read_text()))
        driven.typed("EXECUTE main", seconds=0.1)
        until(driven, checker, 10.0)


def test_without_a_task_or_with_a_part_forgotten_there_is_none(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    with closing(Checker(driven.session, forks=False)) as checker:
        driven.typed("DO READY", seconds=3.0)
        checker.beat()
        assert driven.session.showing.mark is None
    (tmp_path / "other").mkdir()
    driven = Driven(tmp_path / "other", "", task=str(EXAMPLE / "task.toml"))
    with closing(Checker(driven.session, forks=False)) as checker:
        until(driven, checker, 0.0)
        driven.session.growing.known_from_s = 0.5
        driven.run(2.0)
        checker.beat()
        assert driven.session.showing.mark is None


@pytest.mark.thorough
def test_every_lost_point_is_told_in_the_words_of_the_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.REST", 0.0)
    monkeypatch.setattr("vrts.live.session.marks.public_mark.REST", 0.0)
    program = EXAMPLE / "submissions/hits-base.v2"
    driven = Driven(tmp_path, "", task=str(EXAMPLE / "task.toml"))
    with closing(Checker(driven.session)) as checker:
        driven.act(do.Upload("hits.v2", program.read_text()))
        driven.run(0.1)
        started_s = driven.session.growing.time_s
        driven.typed("EXECUTE main", seconds=0.1)
        until(driven, checker, 7.0)
    found = assess(request_for(program)).grade
    assert found is not None
    told = driven.said(Marked)[-1]
    assert (told.mark, told.total) == (7.0, 10.0)
    assert [row.points for row in told.lost] == [lost(loss.points) for loss in found.losses]
    for row, loss in zip(told.lost, found.losses, strict=True):
        assert shifted(row.text) == shifted(capital(loss.sentence)), "but for the time"
        if loss.moment is not None:
            assert row.at_s == pytest.approx(started_s + loss.moment.time_s, abs=0.1)
    assert [(p.title, p.points, p.answer) for p in told.parts][:3] == [
        ("can1 on base2", "4.25", "holds"),
        ("can2 on base1", "4.25", "holds"),
        ("no contact", "−1.5", "violated"),
    ]
    while_it_ran = [news for news in driven.said(Marked) if news.lost[0].text == RUNS]
    assert while_it_ran
    assert any(row.kind == "contact" for news in while_it_ran for row in news.lost)
    driven.session.take(AskSnapshot(99))
    assert driven.said(Snapshot)[-1].marked == told, "who comes later is told the same"


def shifted(sentence: str) -> str:
    """Return a sentence without its time: sessions do not begin with EXECUTE."""
    return re.sub(r"\d+\.\d s", "T s", sentence)


def test_nothing_hidden_is_in_what_leaves_the_session(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.public_mark.REST", 0.0)
    shutil.copytree(EXAMPLE, tmp_path / "task")
    (tmp_path / "task/staff").mkdir()
    (tmp_path / "task/staff/task.toml").write_text(SECRETS)
    (tmp_path / "session").mkdir()
    driven = Driven(tmp_path / "session", "", task=str(tmp_path / "task/task.toml"))
    with closing(Checker(driven.session, forks=False)) as checker:
        driven.act(do.Upload("hits.v2", (EXAMPLE / "submissions/hits-base.v2").read_text()))
        driven.typed("EXECUTE main", seconds=0.1)
        until(driven, checker, 7.0)
    driven.session.take(AskSnapshot(99))
    setting = driven.session.setting
    drawn = msgspec.json.encode(scene_data(setting.scene, setting.task))
    sent = drawn + b"".join(msgspec.json.encode(news) for news in driven.news)
    assert driven.said(Snapshot)[-1].task is not None
    assert b"can1 on base2" in sent
    for secret in (b"passwort", b"987.25", b"0.98725", b"geheim"):
        assert secret not in sent
