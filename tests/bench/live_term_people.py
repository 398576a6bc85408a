"""People of a term of live teaching, and what they do in a room: whatever a page can ask for.

What the server acknowledged is written into a `Ledger`, to be looked for afterwards.
"""

import os
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final
from urllib.parse import quote

import psutil
from websockets.exceptions import ConnectionClosed

from tests.bench.live_hours import Ahead
from tests.support_live import Browser, Json, LiveServer, session_processes
from tests.unit.live.editing.support import Editor, link

GIVEN: Final = (
    *("Anna", "Łukasz", "Σοφία", "Дмитрий", "美咲", "김서연", "अनन्या", "นภา", "محمد", "נועה"),
    *("Nguyễn Thị Hà", "ጌታቸው", "გიორგი", "Արմեն", "தமிழ்", "李雷", "さくら", "ಅನಿತಾ", "Zoë", "Ngũgĩ"),
)
ERROR = 1  # severity of a finding, as the protocol counts
PROGRAM: Final = """\
.PROGRAM turn()
    DRIVE 1,{angle},60
    BREAK
    n = {number}
    TYPE "turned {number}"
.END
"""


def program(number: int) -> str:
    """Return a program that turns the arm, there in one hour and back in the next one."""
    return PROGRAM.format(angle=10 if number // 100 % 2 else -10, number=number)


@dataclass(slots=True)
class Ledger:
    """What was acknowledged."""

    commands: dict[str, list[int]] = field(default_factory=dict[str, list[int]])  # by room
    lines: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])  # room, text
    notes: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])  # room, text
    programs: list[tuple[str, int, str]] = field(default_factory=list[tuple[str, int, str]])


class HourlyServer(LiveServer):
    """A server whose clock can be set on."""

    module = "tests.bench.live_hours"

    def open(self, cookie: str, **headers: str) -> Browser:
        """Open a WebSocket; what comes by it may come late, where others use the machine."""
        browser = super().open(cookie, **headers)
        browser.patience = 300.0
        return browser


@dataclass(slots=True)
class Stay:
    """Somebody in a room."""

    server: LiveServer
    ledger: Ledger
    cookie: str
    browser: Browser
    room: str
    session: int = 0
    alive: bool = False
    lease: str = ""
    last: int = 0  # value of the last acknowledged command

    def forget(self) -> None:
        """Forget what came so far."""
        self.browser.came.clear()
        self.browser.frames.clear()

    def hear(self, type_: str, fits: Callable[[Json], bool]) -> Json:
        """Return a message that came since `forget`, or comes yet."""
        came = (m for m in self.browser.came if m["type"] == type_ and fits(m))
        return next(came, None) or self.browser.wait(type_, fits)

    # --- what anybody does ------------------------------------------------------------------------

    def say(self, text: str) -> None:
        """Say something in the room."""
        self.browser.send("say", text=text)
        self.browser.wait("chat", lambda m: m["text"] == text)
        self.ledger.lines.append((self.room, text))

    def raise_hand(self) -> None:
        """Raise a hand, and wait until it is seen."""
        self.browser.send("raise_hand", up=True)
        self.browser.wait("people", lambda m: any(one["hand"] for one in m["people"]))

    def keep_program(self, number: int, shelf: str, name: str) -> None:
        """Keep a program as a new version, after the newest one."""
        text = program(number)
        where = f"/programs/versions?room={self.room}&shelf={shelf}&name={quote(name)}"
        versions: Any = self.server.request("GET", where, cookie=self.cookie).json
        seen = versions[0]["number"] if versions else 0
        body: Json = {"room": self.room, "shelf": shelf, "name": name, "text": text}
        body["seen"] = seen
        answer = self.server.request("POST", "/programs/keep", body, cookie=self.cookie)
        assert answer.status == 200, answer.body
        assert answer.json["saved"]
        self.ledger.programs.append((name, answer.json["version"]["number"], text))

    def look_back(self) -> None:
        """Ask for the first minute of the session."""
        where = f"/past/{self.room}/{self.session}/0"
        answer = self.server.request("GET", where, cookie=self.cookie)
        known = (200, 404, 503)  # the session may have died since
        assert answer.status in known, answer.body

    def ask_program(self) -> None:
        """Ask for what was done as a program."""
        self.browser.number += 1
        of = self.browser.number
        self.browser.send("program", of=of, name="done")
        self.browser.wait("program_text", lambda m: m["of"] == of)

    def edit(self, number: int) -> None:
        """Open the editor, and let its help find a mistake and complete a word."""
        with link(self.server, self.cookie) as socket:
            editor = Editor(socket, ".PROGRAM a\n  MOVEE part\n.END\n")
            assert editor.findings()
            editor.change(PROGRAM.format(angle=5, number=number))
            wrong = [found for found in editor.findings() if found["severity"] == ERROR]
            assert not wrong, wrong
            editor.at("hover", 1, 6)

    def go_away(self) -> None:
        """Drop the connection."""
        self.browser.socket.close()

    # --- what the operator does -------------------------------------------------------------------

    def lead(self) -> None:
        """Take the control right, unless it came with entering."""
        self.lease = self.browser.take_control()

    def type(self, line: str) -> str:
        """Type a line of the monitor; return what is answered once it is recorded."""
        answer = self.browser.answer(self.browser.command(self.lease, "line", line=line))
        assert answer["type"] == "result", answer
        assert answer["result"]["accepted"], answer
        return str(answer["result"]["text"])

    def set_value(self, value: int) -> None:
        """Give a command by whose number it can be found again."""
        self.type(f"DO a = {value}")
        self.last = value
        self.ledger.commands.setdefault(self.room, []).append(value)

    def begin_program(self, number: int) -> None:
        """Load a program and have the arm move by it; it says so at its end."""
        text = program(number)
        self.browser.answer(self.browser.command(self.lease, "upload", name="turn.v2", text=text))
        self.forget()
        self.type("EXECUTE turn")

    def await_program(self, number: int) -> None:
        """Wait until the arm has moved."""
        self.hear("event", lambda m: f"turned {number}" in str(m["event"]))

    def note(self, text: str) -> None:
        """Put a note at this moment."""
        self.browser.send("note", text=text)
        self.browser.wait("noted", lambda m: m["text"] == text)
        self.ledger.notes.append((self.room, text))

    def wait_for_session(self) -> None:
        """Wait until the session of the room is there again, since `forget`."""
        message = self.hear("state", lambda m: m["state"] is not None)
        self.session = message["session"]

    def value(self, name: str) -> float:
        """Return what a variable holds; -1 where it was never set."""
        told = self.type(f"LISTR {name}").split()
        return float(told[-1]) if told and told[-1].replace(".", "").isdigit() else -1.0

    def require_nothing_lost(self) -> None:
        """See to it that the session knows the last acknowledged command."""
        assert self.value("a") == self.last


class Class:
    """A server, and who comes."""

    def __init__(self, server: HourlyServer, ahead: Ahead, seed: int = 22) -> None:
        """Let nobody in yet."""
        self.server, self.ahead = server, ahead
        self.ledger = Ledger()
        self.random = random.Random(seed)
        self.cookies: list[str] = []  # of guests who may come again
        self.joined = 0

    def name(self) -> str:
        """Return a name that somebody may have, in any script; some have the same."""
        given = self.random.choice(GIVEN)
        return given if self.random.random() < 0.1 else f"{given} {self.random.randint(1, 400)}"

    def somebody(self) -> str:
        """Return the cookie of a guest: two in three were here before."""
        if len(self.cookies) > 20 and self.random.random() < 0.67:
            return self.random.choice(self.cookies[-200:])
        cookie = self.server.enter(self.name())
        self.cookies.append(cookie)
        return cookie

    def join(self, cookie: str, room: str = "", **fields: object) -> Stay:
        """Join a room; return who is there."""
        browser = self.server.join(cookie, room=room, rate=1, **fields)
        try:
            snapshot = browser.wait("snapshot")
        except ConnectionClosed as problem:
            raise AssertionError(f"{browser.came[-2:]}") from problem
        self.joined += 1
        room = snapshot["room"]["id"]
        alive = snapshot["state"] is not None
        return Stay(self.server, self.ledger, cookie, browser, room, snapshot["session"], alive)

    def stay(self, cookie: str, room: str) -> Stay:
        """Join a room, and wait for its session."""
        stay = self.join(cookie, room)
        if not stay.alive:
            stay.wait_for_session()
        return stay


def sessions_of(server: LiveServer) -> dict[str, psutil.Process]:
    """Return the processes of a server's sessions, by room."""
    found: dict[str, psutil.Process] = {}
    for child in session_processes(server.process.pid):
        try:
            errors = os.readlink(f"/proc/{child.pid}/fd/2")
        except OSError:
            continue  # gone meanwhile
        if errors.endswith("/stderr.txt"):
            found[errors.split("/")[-2].rpartition("-")[0]] = child
    return found
