"""What is certified of a session in pieces is what is certified of it as a whole."""

import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from tests.unit.live.session.marks.answering import answered
from tests.unit.live.session.support import Driven
from tests.unit.live.session.test_live_session import DOWN, grasp
from vrts.check.collision.collision import check_collisions
from vrts.live import actions as do
from vrts.live.session.channel.messages import Checked, Json
from vrts.live.session.marks.checker import Checker


def carry_into_things(driven: Driven, checker: Checker) -> None:
    """Carry a can through its neighbourhood and onto the table, checked on the way."""

    def wait(seconds: float) -> None:
        for _ in range(round(seconds / 0.1)):
            driven.run(0.1)
            checker.beat()

    grasp(driven)
    for position in ((0.8, -0.45, -0.1), (0.95, -0.13, -0.22), (0.95, 0.1, -0.2)):
        assert driven.done(driven.act(do.Go(position, DOWN))).accepted
        wait(3.0)
    driven.act(do.Hand(open=True))
    wait(1.0)
    driven.act(do.Go((0.75, 0.0, 0.1), DOWN))
    wait(3.0)


@pytest.mark.parametrize("forks", [True, False])
def test_pieces_tell_what_the_whole_tells(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, forks: bool
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.REST", 0.0)
    driven = Driven(tmp_path)
    with closing(Checker(driven.session, forks=forks)) as checker:
        carry_into_things(driven, checker)
        finish(driven, checker)
    report = check_collisions(driven.session.setting.scene, driven.session.run)
    assert report.contacts
    rows = driven.session.showing.contacts
    whole = sorted((f"{c.first} {c.second}", c.start_s, c.end_s) for c in report.contacts)
    assert [row[0] for row in ends(rows)] == [row[0] for row in whole]
    for row, event in zip(ends(rows), whole, strict=True):
        assert row[1:] == pytest.approx(event[1:], abs=2e-3)
    told = {(r["first"], r["second"]) for c in driven.said(Checked) for r in c.contacts}
    assert told == {(r["first"], r["second"]) for r in rows}


def ends(rows: list[Json]) -> list[tuple[str, float, float]]:
    """Return who touched whom, from when to when."""
    return sorted(
        (f"{r['first']} {r['second']}", _seconds(r["start"]), _seconds(r["end"])) for r in rows
    )


def _seconds(time_s: object) -> float:
    assert isinstance(time_s, float | int)
    return time_s


def finish(driven: Driven, checker: Checker) -> None:
    """Wait for what is being checked."""
    for _ in range(400):
        driven.run(0.1)
        checker.beat()
        if driven.session.showing.checked_s > driven.session.growing.time_s - 1.5:
            driven.run(0.1)  # what was found is told with the next beat
            return
        answered(checker)
    raise AssertionError("the check does not come to an end")


WARM = """\
import sys, tempfile
from pathlib import Path
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.marks.checker import checked, warm_up
driven = Driven(Path(tempfile.mkdtemp()))
driven.act(do.Go((0.75, -0.15, -0.36), (0.0, 1.5707963267948966, 0.0)))
driven.run(3.0)
warm_up(driven.session.setting)
before = set(sys.modules)
assert checked(driven.session.run, 0.0, None).contacts
print(sorted(set(sys.modules) - before))
"""


def test_no_check_has_to_load_anything_after_the_first() -> None:
    words = [sys.executable, "-c", WARM]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60.0, check=True)
    assert done.stdout == "[]\n"


@pytest.mark.parametrize(("rest", "again"), [(0.0, True), (1e6, False)])
def test_checks_rest_the_longer_the_longer_they_take(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, rest: float, *, again: bool
) -> None:
    monkeypatch.setattr("vrts.live.session.marks.checker.REST", rest)
    driven = Driven(tmp_path)
    with closing(Checker(driven.session)) as checker:
        driven.act(do.Go((0.75, -0.15, 0.0), DOWN))
        first_s = checked_after(1.1, driven, checker)
        assert first_s == pytest.approx(1.1)
        assert (checked_after(1.1, driven, checker) > first_s) is again


def checked_after(seconds: float, driven: Driven, checker: Checker) -> float:
    """Let session time pass; return until when is checked, if anything is to be checked by now."""
    driven.run(seconds)
    checker.beat()
    answered(checker)
    checker.beat()
    return driven.session.showing.checked_s
