"""The public mark of a session while it goes on."""

import shutil
from pathlib import Path

import pytest

from tests.unit.live.session.marks.answering import answered
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.channel.messages import Checked, Status
from vrts.live.session.marks.checker import Checker
from vrts.pipeline.settings import load_task

EXAMPLE = Path("examples/01-cans-on-bases")
HIDDEN = """\
[[limit]]
joint_percent = 1
"""


def until(driven: Driven, checker: Checker, mark: float | None) -> None:
    """Let time pass until the session shows a mark."""
    for _ in range(1500):
        driven.run(0.5, beat_s=0.1)
        checker.beat()
        if driven.session.showing.mark == mark and driven.session.at_rest:
            driven.run(0.1)
            return
        answered(checker)
    raise AssertionError(f"the mark is {driven.session.showing.mark}, not {mark}")


@pytest.mark.parametrize("forks", [True, False])
def test_it_follows_what_is_done_and_begins_anew_with_a_reset(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, forks: bool
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.FORKS", forks)
    monkeypatch.setattr("vrts.live.session.marks.checker.REST", 0.0)
    monkeypatch.setattr("vrts.live.session.marks.public_mark.REST", 0.0)
    driven = Driven(tmp_path, "", task=str(EXAMPLE / "task.toml"))
    with Checker(driven.session) as checker:
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


def test_hidden_checks_do_not_appear(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.FORKS", False)
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
    with Checker(driven.session) as checker:
        driven.act(do.Upload("solution.v2", (EXAMPLE / "solution.v2").read_text()))
        driven.typed("EXECUTE main", seconds=0.1)
        until(driven, checker, 10.0)


def test_without_a_task_or_with_a_part_forgotten_there_is_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.FORKS", False)
    driven = Driven(tmp_path)
    with Checker(driven.session) as checker:
        driven.typed("DO READY", seconds=3.0)
        checker.beat()
        assert driven.session.showing.mark is None
    (tmp_path / "other").mkdir()
    driven = Driven(tmp_path / "other", "", task=str(EXAMPLE / "task.toml"))
    with Checker(driven.session) as checker:
        until(driven, checker, 0.0)
        driven.session.growing.known_from_s = 0.5
        driven.run(2.0)
        checker.beat()
        assert driven.session.showing.mark is None
