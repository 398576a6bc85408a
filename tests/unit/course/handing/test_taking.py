"""What was handed in is whole or not there, wherever a crash comes; and who may hand in when."""

import asyncio
import os
from collections.abc import Callable, Coroutine, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.support_handing import course_folder, enrol
from vrts.course.beside import Beside
from vrts.course.course import Course
from vrts.course.course_file import open_course
from vrts.course.handing.deposit import done
from vrts.course.handing.names import PROGRAM
from vrts.course.handing.standing import Refusal
from vrts.course.handing.taking import Taken, Taking
from vrts.course.variants.own_variants import OwnVariants
from vrts.live.settings import DATABASE
from vrts.live.store.course.attempts import Attempt, add_attempts, all_attempts
from vrts.live.store.database import Database

NOON = 1_795_780_800.0  # 2026-11-27, 13:00 with +01:00
LATE = "[late]\ndue = 2026-11-27T13:00:00+01:00\nper_day = 1\n"
TEAM = (("Cy Dahl", "cy@example.org", "Red"), ("Di Ek", "di@example.org", "Red"))


class Crash(Exception):  # noqa: N818
    """The machine went off."""


class Kept:
    """A course with its database; each `begin` is a server that has just started."""

    def __init__(self, folder: Path, assignment: str = "", task: str = "") -> None:
        self.folder = live = folder / "live"
        self.course: Course = open_course(course_folder(folder / "course", assignment, task))
        self.accounts = enrol(live, TEAM)
        self.database = Database(live / DATABASE)

    def begin(self, work: Callable[[Taking], Coroutine[Any, Any, Any]]) -> Any:
        """Start, mend, and have something done."""

        async def all_of_it() -> Any:
            beside = Beside(self.folder / "beside")  # nothing is asked: the task has no variants
            variants = OwnVariants(self.course, self.database, self.folder, beside)
            taking = Taking(self.course, self.database, variants)
            await taking.mend()
            return await work(taking)

        return asyncio.run(all_of_it())

    def hand_in(
        self, text: str, number: int, at: float = NOON, late: str = "", who: int = 0
    ) -> Any:
        return self.begin(lambda taking: self.take(taking, text, number, at, late, who))

    def take(
        self, taking: Taking, text: str, number: int, at: float, late: str = "", who: int = 0
    ) -> Coroutine[Any, Any, Taken | Refusal]:
        (assignment,) = self.course.assignments
        account = self.accounts[who]
        return taking.take(account, assignment, text.encode(), at, (number, late))

    def rows(self) -> list[Attempt]:
        async def look(_: Taking) -> list[Attempt]:
            return await self.database.do(all_attempts)

        return self.begin(look)

    def files(self) -> list[str]:
        home = self.course.handed_in
        return sorted(str(path.relative_to(home)) for path in home.rglob("*") if path.is_file())


@pytest.fixture
def kept_of(tmp_path: Path) -> Iterator[Callable[..., Kept]]:
    begun: list[Kept] = []

    def begin(assignment: str = "", task: str = "") -> Kept:
        begun.append(Kept(tmp_path, assignment, task))
        return begun[-1]

    yield begin
    for one in begun:
        one.database.close()


def test_a_hand_in_is_a_file_as_marking_takes_it_and_a_row(kept_of: Callable[..., Kept]) -> None:
    kept = kept_of(task=LATE)
    assert kept.hand_in("one", 1) == Taken(1, int(NOON), "", again=False)
    assert kept.hand_in("two", 2, NOON + 3600, "1 h late: 1 point less").number == 2
    assert kept.files() == [
        f"cans/cy@example.org/2026-11-27-13-00-00/{PROGRAM}",
        f"cans/cy@example.org/2026-11-27-14-00-00/{PROGRAM}",
    ]
    assert [(one.number, one.state, one.late) for one in kept.rows()] == [
        (1, "waiting", ""),
        (2, "waiting", "1 h late: 1 point less"),
    ]


def test_the_same_program_again_is_the_same_attempt(kept_of: Callable[..., Kept]) -> None:
    kept = kept_of()
    kept.hand_in("one", 1)
    assert kept.hand_in("one", 2, NOON + 60) == Taken(1, int(NOON), "", again=True)
    assert len(kept.rows()) == 1


def test_what_was_not_agreed_to_is_not_taken(kept_of: Callable[..., Kept]) -> None:
    kept = kept_of("attempts = 1\n", LATE)
    late = kept.hand_in("one", 1, NOON + 60)  # agreed to be on time
    assert late.code == "changed"
    assert "1 min late: 1 point less" in late.text
    assert kept.rows() == []
    kept.hand_in("one", 1)
    assert kept.hand_in("two", 2, NOON).text == "you have used the one attempt at this assignment"


def test_a_team_hands_in_for_all_of_it(kept_of: Callable[..., Kept]) -> None:
    kept = kept_of("team = true\n")
    kept.hand_in("one", 1, who=1)
    assert kept.hand_in("two", 2, NOON, who=0).code == "limit"  # the same second is one folder
    cy, di = kept.accounts
    assert {(one.account, one.by) for one in kept.rows()} == {(cy, di), (di, di)}
    assert len(kept.files()) == 2


@pytest.mark.parametrize("people", [1, 2])
def test_no_crash_tears_a_hand_in(
    kept_of: Callable[..., Kept], monkeypatch: pytest.MonkeyPatch, people: int
) -> None:
    """The machine goes off at every write in turn: afterwards all is there, or nothing."""
    kept = kept_of("team = true\n" if people == 2 else "")
    left, there = 0, 0

    def step(real: Callable[..., Any], *args: Any, **more: Any) -> Any:
        nonlocal left
        left -= 1
        if left < 0:
            raise Crash
        return real(*args, **more)

    for writes in range(40):
        with monkeypatch.context() as patched:
            left, crashed = writes, False
            for name in ("fsync", "replace", "rename"):
                patched.setattr(os, name, _stepped(step, getattr(os, name)))
            for name, real in (("taking.add_attempts", add_attempts), ("deposit.done", done)):
                patched.setattr(f"vrts.course.handing.{name}", _stepped(step, real))
            try:
                number = there // people + 1
                kept.hand_in(f"program {writes}", number, NOON + writes)
            except Crash:
                crashed = True
        rows, files = kept.rows(), kept.files()
        assert len(rows) == len(files), f"torn after {writes} writes"
        assert len(rows) - there in ((0, people) if crashed else (people,))
        there = len(rows)
        if not crashed:
            assert writes > 8
            return
    raise AssertionError("a hand-in never ended")


def _stepped(step: Callable[..., Any], real: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *args, **more: step(real, *args, **more)


def test_files_and_rows_are_made_to_fit(kept_of: Callable[..., Kept]) -> None:
    kept = kept_of(task=LATE)
    kept.hand_in("one", 1)
    home = kept.course.handed_in / "cans" / "cy@example.org"
    other = home / "2026-11-27-12-30-00"
    other.mkdir()
    (other / PROGRAM).write_text("put there by hand")
    (home / "2026-11-27-13-00-00" / PROGRAM).unlink()
    stranger = home.parent / "nobody@example.org" / "2026-11-27-12-30-00"
    stranger.mkdir(parents=True)
    (stranger / PROGRAM).write_text("of somebody who is on no list")
    found = {(one.number, one.state) for one in kept.rows()}
    assert found == {(1, "failed"), (2, "waiting")}
