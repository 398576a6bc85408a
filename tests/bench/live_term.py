"""A term of live teaching in hours: what happens in each, and what is looked at after it.

The server's clock is set on by an hour before each hour, so all that time brings about happens:
turns end, who is away loses the place, private rooms close, help for editors ends. What people do
in an hour is then done without the waiting between. Sessions live by their own clocks, so for
them the waiting is left out.
"""

import os
import sqlite3
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NamedTuple

import psutil

from tests.bench.live_hours import VARIABLE, Ahead
from tests.bench.live_term_people import Class, HourlyServer, Stay, sessions_of
from vrts.live import administration
from vrts.live.logs.log_file import read_log
from vrts.live.new_account import add_user
from vrts.live.settings import DATABASE
from vrts.live.watching.health import DYING

HOUR: Final = 3600.0  # [s]
SCENES: Final = ("cans-on-bases", "examples/02-dish-on-stand", "examples/03-around-obstacles")
PASSWORD: Final = "a long one for a term"
OLDER: Final = "this is an older state of the database"  # which every copy is, a moment later
ENDS_S: Final = 10.0  # within which a process ends that nobody needs
AT_ONCE: Final = 5  # sessions that die together
# what may wait for the disk, two that compare passwords, the database's and the server's own
THREADS: Final = min(32, (os.cpu_count() or 1) + 4) + 2 + 2


class Plan(NamedTuple):
    """How much happens."""

    hours: int = 24
    rooms: int = 6
    joins: int = 2000
    deaths: int = 300  # of sessions
    servers: tuple[int, ...] = (2, 5)  # hours in which the whole server is killed
    steps: tuple[tuple[int, int], ...] = ((4, -1), (9, 24), (16, -1))  # hour, by how many hours
    helped: int = 40  # every so many people ask the editor's help


@dataclass(frozen=True, slots=True)
class Look:
    """What the server takes, at the end of an hour when only the operators are there."""

    hour: int
    server_mb: float
    sessions_mb: float
    files: int
    sockets: int
    threads: int
    processes: int
    database_mb: float


class Term:
    """Goes from hour to hour."""

    def __init__(self, folder: Path, plan: Plan) -> None:
        """Start a server, and let the operators in."""
        self.folder, self.plan, self.key = folder / "live", plan, folder / "key" / "log-key"
        self._copies = folder / "restored"
        self.died = self.killed = self.backups = self.hour = 0
        self.looks: list[Look] = []
        self.seen: set[psutil.Process] = set()  # all below the server: by number and beginning
        add_user(self.folder, "Lehrerin", PASSWORD, supervisor=True)
        add_user(self.folder, "Jürgen", PASSWORD, supervisor=False)
        ahead = Ahead(folder / "ahead")
        known = {VARIABLE: str(ahead.path)}
        self._environment = known
        with _Environment(known):
            self.server = HourlyServer(
                self.folder, "--log-key", str(self.key), scenes=SCENES, measured=True
            )
        self.people = Class(self.server, ahead)
        self.desks: list[Stay] = []
        try:
            self.boss_cookie = self._log_in("Lehrerin")
            self.boss = self.people.stay(self.boss_cookie, "")
            self._make_rooms()
        except BaseException:
            self.server.kill()
            raise

    def _make_rooms(self) -> None:
        wanted = [
            {"name": f"Group {n + 2}", "scene": self._scene(n + 1)}
            for n in range(self.plan.rooms - 1)
        ]
        self.boss.browser.send("make_rooms", rooms=wanted)
        of_all = self.boss.browser.wait("rooms", lambda m: len(m["rooms"]) == self.plan.rooms)
        for room in of_all["rooms"]:
            desk = self.people.stay(self.server.enter(self.people.name()), room["id"])
            desk.lead()
            self.desks.append(desk)

    def _scene(self, number: int) -> str:
        names = ("cans-on-bases", "02-dish-on-stand", "03-around-obstacles")
        return names[number % len(names)]

    def _log_in(self, user: str) -> str:
        answer = self.server.request("POST", "/login", {"user": user, "password": PASSWORD})
        assert answer.status == 200, answer.body
        return answer.cookie

    # --- an hour ----------------------------------------------------------------------------------

    def go_on(self) -> None:
        """Let the next hour happen."""
        self.hour += 1
        plan, hour = self.plan, self.hour
        self._pass_time()
        for at, hours in plan.steps:
            if at == hour:
                self.people.ahead.step(hours * HOUR)
        if hour in plan.servers:
            self._kill_the_server()
        joins = plan.joins * hour // plan.hours
        self._work()
        private = self._private_room()
        while self.people.joined < joins:
            self._come()
            if self.people.joined % 20 == 0:
                self._supervise()
        self._ask_the_entrance()
        left = plan.deaths * hour // plan.hours - self.died
        while left > 0:
            count = min(left, AT_ONCE, len(self.desks) + 1)
            dying = [*self.people.random.sample(self.desks, len(self.desks)), private]
            self._die(dying[-count:])
            left -= count
        private.go_away()
        self._back_up()
        self._look()

    def _pass_time(self) -> None:
        """Let an hour pass in which nobody did anything: who led does not any more."""
        if self.hour == 1:
            return
        boss = self.boss.browser
        boss.send("watch_wall", on=True)
        boss.wait("wall")
        boss.wait("wall")  # so it was seen that nobody is in private rooms
        boss.send("watch_wall", on=False)
        self.people.ahead.set(self.people.ahead.seconds + HOUR)
        for desk in self.desks:
            desk.browser.wait("control", lambda m: m["holder"] == "")
            desk.lead()
        rooms = len(self.desks)
        boss.wait("rooms", lambda m: len(m["rooms"]) == rooms)  # the private one is closed

    def _work(self) -> None:
        """Have the arms of all rooms moved by programs at once."""
        numbered = [(self.hour * 100 + n, desk) for n, desk in enumerate(self.desks)]
        for number, desk in numbered:
            desk.set_value(number)
            desk.begin_program(number)
        for number, desk in numbered:
            desk.await_program(number)
            desk.note(f"hour {self.hour}")
            desk.say(f"{number} is done")
            desk.keep_program(number, "room", "turn")
            desk.browser.send("panic")
            desk.browser.wait("stopped", lambda m: m["at"] > 0.0)

    def _private_room(self) -> Stay:
        """Have somebody go on from an earlier moment in a room of their own."""
        cookie = self.people.somebody()
        origin = self.people.stay(cookie, self.desks[self.hour % len(self.desks)].room)
        origin.browser.send("go_on_from", of=1, at_s=0.5)
        made = origin.browser.wait("branched")["room"]
        origin.go_away()
        own = self.people.stay(cookie, made)
        own.lease = own.hear("control", lambda m: m["lease"] != "")["lease"]
        own.set_value(self.hour)
        return own

    def _come(self) -> None:
        """Have somebody come, do something, and go."""
        people, number = self.people, self.people.joined
        desk = self.desks[number % len(self.desks)]
        visitor = people.join(people.somebody(), desk.room)
        deeds: tuple[Callable[[], object], ...] = (
            lambda: visitor.say(f"line {number}"),
            visitor.raise_hand,
            lambda: visitor.keep_program(number, "own", f"mine {number % 7}"),
            visitor.look_back,
            visitor.ask_program,
            lambda: self._come_back(visitor),
            lambda: self.server.request("POST", "/logout", cookie=visitor.cookie),
        )
        if number % self.plan.helped == 0:
            visitor.edit(number)
        else:
            deeds[number % len(deeds)]()
        if visitor.cookie in people.cookies and number % len(deeds) == len(deeds) - 1:
            people.cookies.remove(visitor.cookie)
        visitor.go_away()

    def _come_back(self, visitor: Stay) -> None:
        welcome = next(m for m in visitor.browser.came if m["type"] == "welcome")
        visitor.go_away()
        again = self.people.join(visitor.cookie, visitor.room, resume=welcome["resume"])
        again.go_away()

    def _supervise(self) -> None:
        """Mute somebody and let them be heard again, send somebody away, announce something."""
        boss, people = self.boss.browser, self.people
        # who is called as somebody who was sent away is kept out as well: a name of their own
        guest = people.server.enter(f"Loud {people.joined}")
        visitor = people.join(guest, self.boss.room)
        me = next(m for m in visitor.browser.came if m["type"] == "welcome")
        boss.send("mute", person=me["you"], on=True)
        visitor.browser.wait("people", lambda m: _is_muted(m["people"], me["you"]))
        visitor.browser.send("say", text="nobody hears this")
        visitor.browser.wait("refused", lambda m: m["code"] == "muted")
        boss.send("unmute", name=me["name"])
        boss.send("broadcast", text=f"after {people.joined} joins")
        told = visitor.browser.wait("announced", lambda m: m["id"] > 0)
        visitor.browser.send("noticed", id=told["id"], closed=True)
        boss.send("end_announcement")
        boss.send("kick", person=me["you"])
        closed = visitor.browser.closed()
        assert closed is not None
        assert closed["code"] == "kicked"
        if people.joined % 40 == 0:
            boss.send("allow", name=me["name"])

    def _ask_the_entrance(self) -> None:
        """Renew the code now and then, guess at it, log in, make a link, look at the pages."""
        server, boss = self.server, self.boss_cookie
        before = server.code
        if self.hour % 6 == 0:
            server.request("POST", "/ways", {"do": "renew"}, cookie=boss)
            server.code = server.request("GET", "/code", cookie=boss).json["code"]
            old = server.request("POST", "/enter", {"code": before, "name": "Late"})
            assert old.json["code"] == "renewed"
        for _ in range(5):
            wrong = "".join(self.people.random.choices("ABCDEFGHJK", k=len(before)))
            assert server.request("POST", "/enter", {"code": wrong, "name": "X"}).status == 403
        self.people.join(self._log_in("Jürgen")).go_away()
        made = server.request("POST", "/link", {"room": self.desks[-1].room}, cookie=boss).json
        by_link = server.enter(self.people.name(), made["url"].partition("#enter=")[2])
        self.people.join(by_link).go_away()
        rows = server.request("GET", "/ways", cookie=boss).json["ways"]
        ends = next(row["id"] for row in rows if row["kind"] == "link")
        server.request("POST", "/ways", {"do": "end", "id": ends}, cookie=boss)
        for page in ("/admin/now", "/me"):
            assert server.request("GET", page, cookie=boss).status == 200, page
        assert DYING not in server.request("GET", "/health").json["problems"]

    # --- deaths -----------------------------------------------------------------------------------

    def _die(self, stays: list[Stay]) -> None:
        """Kill the sessions of rooms while they obey, and look whether anything is lost."""
        processes = sessions_of(self.server)
        self._see()
        for stay in stays:
            self.died += 1
            stay.set_value(10_000 + self.died)
            stay.forget()
            flying = stay.browser.command(stay.lease, "line", line="DO b = 1")
            processes[stay.room].kill()
            stay.browser.answer(flying)  # recorded, or refused
        for stay in stays:
            stay.wait_for_session()
            stay.require_nothing_lost()

    def _kill_the_server(self) -> None:
        """Kill the server and with it all sessions, start it again, and have operators back."""
        port = str(self.server.port)
        self._see()
        self.server.kill()
        self.server.close_browsers()
        self.killed += 1
        with _Environment(self._environment):
            self.server.start(port)
        self.boss = self.people.stay(self.boss_cookie, self.boss.room)
        for number, desk in enumerate(self.desks):
            back = self.people.stay(desk.cookie, desk.room)
            back.last = desk.last
            back.lead()
            back.require_nothing_lost()
            self.desks[number] = back

    # --- what is looked at ------------------------------------------------------------------------

    def _back_up(self) -> None:
        """Copy the database while it is used, restore the copy, and look for all that was done."""
        place = self._copies / str(self.hour)
        place.mkdir(parents=True)
        administration.save_backup(self.folder, place / DATABASE)
        found = list(administration.verify_logs(place, self.key))
        wrong = [one.text for one in found if one.wrong]
        assert all(text.startswith(OLDER) for text in wrong), wrong
        assert sum("unbroken" in one.text for one in found) >= len(self.desks)
        self.require_kept(place / DATABASE)
        self.backups += 1
        for file in place.iterdir():
            file.unlink()

    def require_kept(self, database: Path) -> None:
        """See to it that a database holds everything that was acknowledged so far."""
        ledger = self.people.ledger
        with closing(sqlite3.connect(f"{database.as_uri()}?mode=ro", uri=True)) as connection:
            texts = connection.execute("SELECT room, text FROM log_text").fetchall()
            lines = set(connection.execute("SELECT room, text FROM chat").fetchall())
            rows = connection.execute("SELECT name, number, text FROM program_version").fetchall()
        commands = {(room, text.partition('"line":"')[2].partition('"')[0]) for room, text in texts}
        for room, values in ledger.commands.items():
            assert all((room, f"DO a = {value}") in commands for value in values), room
        assert lines >= set(ledger.lines)
        assert {(room, f'{{"text":"{note}"}}') for room, note in ledger.notes} <= set(texts)
        assert set(ledger.programs) <= set(rows)

    def require_logged(self) -> None:
        """See to it that logs, exported and read, hold all acknowledged commands in order."""
        for room, values in self.people.ledger.commands.items():
            text = self.server.request("GET", f"/log/{room}", cookie=self.boss_cookie).body
            entries = [str(entry.order) for one in read_log(text) for entry in one.entries]
            left = iter(entries)
            for value in values:
                assert any(f"DO a = {value}'" in entry for entry in left), (room, value)

    def _see(self) -> None:
        own = psutil.Process(self.server.process.pid)
        self.seen |= set(own.children(recursive=True))

    def orphans(self) -> list[str]:
        """Return processes of any kind that were once below a server and are below none now."""
        self._see()
        own = psutil.Process(self.server.process.pid)
        left = self.seen - set(own.children(recursive=True))
        until = time.monotonic() + ENDS_S
        while (alive := [one for one in left if _lives(one)]) and time.monotonic() < until:
            time.sleep(0.1)
        return [_words(one) for one in alive]

    def _look(self) -> None:
        here = len(self.desks) + 1
        own = psutil.Process(self.server.process.pid)
        while (
            self.server.request("GET", "/health").json["people"] != here
            or len(own.net_connections()) != here + 1  # and the one that listens
        ):
            time.sleep(0.1)
        rooms = sessions_of(self.server)
        sessions = [rooms[desk.room].memory_info().rss for desk in self.desks]
        kept = sum(file.stat().st_size for file in self.folder.glob(f"{DATABASE}*"))
        self.looks.append(
            Look(
                self.hour,
                own.memory_info().rss / 1e6,
                sum(sessions) / 1e6,
                own.num_fds(),
                len(own.net_connections()),
                own.num_threads(),
                len(own.children(recursive=True)),
                kept / 1e6,
            )
        )
        for stay in (*self.desks, self.boss):
            stay.forget()


class _Environment:
    """Has variables set while a server starts."""

    def __init__(self, known: dict[str, str]) -> None:
        self._known = known

    def __enter__(self) -> None:
        os.environ.update(self._known)

    def __exit__(self, *_: object) -> None:
        for name in self._known:
            del os.environ[name]


def _is_muted(people: list[dict[str, object]], person: str) -> bool:
    return any(one["id"] == person and one["muted"] for one in people)


def _lives(process: psutil.Process) -> bool:
    """Return whether it is still this one, and does not only wait to be buried."""
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.Error:
        return False


def _words(process: psutil.Process) -> str:
    try:
        return f"{process.pid} {' '.join(process.cmdline())}"
    except psutil.Error:
        return f"{process.pid}"
