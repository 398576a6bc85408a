"""A course's term of ten weeks without the waiting between: nothing acknowledged is lost.

By hand: `python -m pytest tests/bench/test_bench_course_term.py -s -p no:xdist`; `STUDENTS=40`
makes it longer. The server's clock is set on by a week before each week, so slots, places of who is
away, robots that nobody needs and deadlines go by as in a term. In each week some students log in,
work with their own robots, and hand in; in some weeks the server is killed in the midst of it. Then
the log of every robot is read, repeated and compared with what was acknowledged.
"""

import hashlib
import os
import random
import shutil
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter
from typing import Final

import pytest

from tests.bench.live_hours import VARIABLE, Ahead
from tests.places import ROOT
from tests.support_handing import PASSWORD, example
from tests.support_live import Json, LiveServer
from vrts.live import administration
from vrts.live.lasting.clock import wall
from vrts.live.passwords import hashed
from vrts.live.settings import DATABASE
from vrts.live.store.accounts import add_account
from vrts.live.store.course.attempts import all_attempts
from vrts.live.store.course.people import Person, keep_person
from vrts.live.store.database import opened, read_only

WEEK: Final = 7 * 86_400.0  # [s]
WEEKS: Final = 10
STUDENTS: Final = int(os.environ.get("STUDENTS", "12"))
AT_WORK: Final = 5  # students in a week
KILLED: Final = (2, 5, 8)  # weeks in which the server is killed
MOVES: Final = 4  # commands of a student in a week
COURSE: Final = """\
[course]
title = "A term"
roster = "roster.csv"
guests = true

[[assignment]]
task = "tasks/cans"
"""


@dataclass(slots=True)
class Ledger:
    """What was acknowledged."""

    commands: dict[str, list[str]] = field(default_factory=dict[str, list[str]])  # lines, by room
    joints: dict[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])
    hand_ins: list[tuple[int, str]] = field(default_factory=list[tuple[int, str]])


class LiveServerAhead(LiveServer):
    """A server whose clock can be set on."""

    module = "tests.bench.live_hours"


class Term:
    """A course, its server, and what people do."""

    def __init__(self, folder: Path) -> None:
        self.ledger = Ledger()
        self.course, self.kept = folder / "course", folder / "kept"
        home = self.course / "tasks" / "cans"
        home.mkdir(parents=True)
        for name in ("task.toml", "README.md", "solution.v2"):
            shutil.copy(ROOT / "examples" / "01-cans-on-bases" / name, home)
        names = [f"Student {k}" for k in range(STUDENTS)]
        rows = "".join(f"{name},s{k}@example.org\n" for k, name in enumerate(names))
        (self.course / "roster.csv").write_text("name,email\n" + rows)
        (self.course / "course.toml").write_text(COURSE)
        self.kept.mkdir(mode=0o700)
        self.accounts: dict[str, int] = {}
        connection, secret = opened(self.kept / DATABASE), hashed(PASSWORD)
        for k, name in enumerate(names):
            email = f"s{k}@example.org"
            account = add_account(connection, name, wall(), password=secret).id
            keep_person(connection, Person(account, name, email, email, {}, "student"))
            self.accounts[name] = account
        connection.close()

    @contextmanager
    def server(self) -> Generator[LiveServer]:
        started = LiveServerAhead(self.kept, scenes=(str(self.course),), measured=True)
        try:
            yield started
        finally:
            started.close_browsers()
            if started.process.poll() is None:
                started.__exit__(None, None, None)

    def works(self, server: LiveServer, name: str, number: int) -> None:
        """Have a student work with the own robot, and hand in."""
        answer = server.request("POST", "/login", {"user": name, "password": PASSWORD})
        assert answer.status == 200, answer.body
        cookie = answer.cookie
        found = server.request("POST", "/course/robots", {"scene": "cans"}, cookie=cookie)
        assert found.status == 200, found.body
        room = str(found.json["room"])
        browser = server.join(cookie, room=room)
        state = browser.wait("snapshot")["state"]
        lease = browser.wait("control", lambda m: bool(m["lease"]))["lease"]
        while state is None:  # it wakes
            state = browser.wait("state")["state"]
        for k in range(MOVES):
            line = f"n = {100 * number + k}" if k % 2 else f"DO DRIVE 1,{1 + number % 3},80"
            done = browser.answer(browser.command(lease, "line", line=line))
            assert done["type"] == "result", done
            assert done["result"]["accepted"], done
            self.ledger.commands.setdefault(room, []).append(line)
        program = f"; week of {name}, {number}\n{example('solution')}"
        self._hand_in(server, cookie, name, program)
        browser.socket.close()

    def _hand_in(self, server: LiveServer, cookie: str, name: str, program: str) -> None:
        mine = server.request("GET", "/course/work/now", cookie=cookie).json["assignments"][0]
        attempt = len(mine.get("attempts", ())) + 1
        body: Json = {"assignment": "cans", "text": program, "attempt": attempt, "late": ""}
        answer = server.request("POST", "/course/work/hand-in", body, cookie=cookie)
        assert answer.status == 200, answer.body
        digest = hashlib.sha256(program.encode()).hexdigest()
        self.ledger.hand_ins.append((self.accounts[name], digest))

    def lost(self) -> list[str]:
        """Return what was acknowledged and is not there."""
        missing: list[str] = []
        with read_only(self.kept / DATABASE) as connection:
            for room, lines in self.ledger.commands.items():
                texts = connection.execute(
                    "SELECT text FROM log JOIN log_text USING (room, seq)"
                    " WHERE room=? AND kind='line' AND accepted ORDER BY seq",
                    (room,),
                ).fetchall()
                there = iter(text for (text,) in texts)
                for line in lines:  # in the same order
                    if not any(f'"{line}"' in text for text in there):
                        missing.append(f"{room}: {line}")
            rows = {(one.account, one.digest) for one in all_attempts(connection)}
        files = {
            hashlib.sha256(path.read_bytes()).hexdigest()
            for path in (self.course / "handed-in").glob("cans/*/*/program.v2")
        }
        missing += [f"row of {one}" for one in self.ledger.hand_ins if one not in rows]
        missing += [f"file of {one}" for one in self.ledger.hand_ins if one[1] not in files]
        return missing


def test_ten_weeks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    ahead, chance = Ahead(tmp_path / "ahead"), random.Random(1)
    monkeypatch.setenv(VARIABLE, str(ahead.path))
    term, names, number, begun = Term(tmp_path), [], 0, perf_counter()
    week = 0
    while week < WEEKS:
        with term.server() as server:
            while week < WEEKS:
                ahead.set(week * WEEK)
                names = chance.sample(sorted(term.accounts), AT_WORK)
                for k, name in enumerate(names):
                    number += 1
                    term.works(server, name, number)
                    if week in KILLED and k == AT_WORK // 2:
                        server.close_browsers()
                        server.kill()
                        break
                week += 1
                if week - 1 in KILLED:
                    break
    lost = term.lost()
    wrong = [found.text for found in administration.verify_logs(term.kept) if found.wrong]
    commands = sum(map(len, term.ledger.commands.values()))
    print()
    print(
        f"{WEEKS} weeks, {STUDENTS} students, {len(KILLED)} kills: {commands} commands and"
        f" {len(term.ledger.hand_ins)} hand-ins acknowledged, {len(lost)} lost;"
        f" {len(wrong)} faults in logs; {perf_counter() - begun:.0f} s"
    )
    assert lost == []
    assert wrong == []
