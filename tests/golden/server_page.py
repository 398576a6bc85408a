"""Follow the manual's page about a server for a term: `python -m tests.golden.server_page`.

It writes the numbers and outputs on the page anew. Commands of vrts are typed, and those of a
shell that need no root; between `<!-- server: begins -->` and `<!-- server: ends -->` a server
works in the folder. Folders of the page are below a temporary one here. What differs each time
(codes, ids, times, counts) is not compared.
"""

import json
import os
import re
import subprocess
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.golden.limit_table import HEAD, limit_table
from tests.golden.tutorial import Shown, matches
from tests.places import ROOT
from tests.support_commands import vrts_shown
from tests.support_live import Browser, LiveServer
from tests.support_pty import Child

PAGE = ROOT / "vrts" / "manual" / "learn" / "server.md"
FOLDERS = ("/srv/vrts", "/var/backups/vrts", "/var/lib/vrts-state")
STATE = "/var/lib/vrts-state"
ADDRESS = "http://127.0.0.1:8000"
PASSWORD = "correct horse"
BEGINS, ENDS = "<!-- server: begins -->", "<!-- server: ends -->"

_PIECE = re.compile(rf"^(?:{BEGINS}|{ENDS}|```console\n(?P<body>.*?)^```)$", re.M | re.S)
_COMMAND = re.compile(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", re.M)
_DIFFERS = (
    (r"\b(?=\w*\d)[0-9a-f]{8}\b", "ID"),
    (r"\b[A-Z0-9]{3}(-[A-Z0-9]{3})+\b", "CODE"),
    (r"#enter=[\w-]+", "#enter=TOKEN"),
    (r"\d{4}-\d\d-\d\d \d\d:\d\d", "TIME"),
    (r"\b\d+ (records|times)\b", r"N \1"),
    (r"(entries|still there): \d+", r"\1: N"),
    (r"(up_s|people|\brooms|sessions)\":[\d.]+", r"\1:N"),
    (r"ExecStart=\S+ serve", "ExecStart=vrts serve"),
)


def alike(text: str) -> str:
    """Return an output without what differs each time."""
    for pattern, name in _DIFFERS:
        text = re.sub(pattern, name, text)
    return text


def fits(step: Shown) -> bool:
    """Whether the page shows what comes, but for what differs each time."""
    return matches(alike(step.shown), alike(step.real))


def follow(text: str, folder: Path) -> Iterator[Shown]:
    """Type the commands of the page, with a server where it says so, and Anna working in it.

    Args:
        text: The page.
        folder: Empty; stands for the root of the machine.
    """
    for name in FOLDERS:
        (folder / name[1:]).mkdir(parents=True)
    here = _Here(folder)
    before = dict(os.environ)
    os.environ["XDG_STATE_HOME"] = f"{folder}{STATE}"
    work: Callable[[], None] = lambda: None  # noqa: E731 -- nobody is there
    try:
        for piece in _PIECE.finditer(text):
            if piece[0] == BEGINS:
                here.server = LiveServer(folder / "srv" / "vrts")
                work = _anna(here.server)
                work()
            elif piece[0] == ENDS:
                work()  # after the backup
                here.end()
            else:
                yield from here.typed(text, piece)
    finally:
        here.end()
        os.environ.clear()
        os.environ.update(before)


class _Here:
    """The folder in which the commands are typed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.server: LiveServer | None = None
        self._ids: dict[str, str] = {}  # that the page shows, and what they are here

    def end(self) -> None:
        """End the server."""
        if self.server is not None:
            with self.server:
                pass
            self.server = None

    def typed(self, text: str, piece: re.Match[str]) -> Iterator[Shown]:
        """Type the commands of a block."""
        offset = piece.start("body")
        for found in _COMMAND.finditer(piece["body"]):
            start, end = offset + found.start(2), offset + found.end(2)
            line = text.count("\n", 0, offset + found.start()) + 1
            real = self._run(found[1])
            for shown, here in zip(_ids(found[2]), _ids(real), strict=False):
                self._ids.setdefault(shown, here)
            yield Shown(found[1], line, found[2], real, start, end)

    def _run(self, command: str) -> str:
        for name in FOLDERS:
            command = command.replace(name, f"{self.folder}{name}")
        for shown, here in self._ids.items():
            command = command.replace(shown, here)
        environment = {**os.environ, "NO_COLOR": "1"}
        words = [word.strip('"') for word in re.findall(r'"[^"]*"|\S+', command)]
        if words[0] == "curl":
            assert self.server is not None
            url = words[-1].replace(ADDRESS, f"http://127.0.0.1:{self.server.port}")
            with urllib.request.urlopen(url) as answer:
                real = json.dumps(json.load(answer), separators=(",", ":")) + "\n"
        elif "--add-user" in words:
            real = self._asked(words[1:])
        elif words[0] == "vrts":
            real = vrts_shown(*words[1:], cwd=self.folder, env=environment)
        else:
            assert words[0] in ("mkdir", "mv", "cp"), command
            subprocess.run(["sh", "-ec", command], check=True)
            real = ""
        for name in FOLDERS:
            real = real.replace(f"{self.folder}{name}", name)
        return real

    def _asked(self, words: list[str]) -> str:
        """Type a command that asks for a password, at a terminal."""
        with closing(Child(words, self.folder)) as child:
            for asked_for in ("password: ", "Repeat for confirmation: "):
                child.expect(asked_for)
                child.until_it_waits()
                child.send(PASSWORD + "\r")
            child.expect("there is an account `Dr. Lee` now")
            assert child.status() == 0
        return "password:\nRepeat for confirmation:\nthere is an account `Dr. Lee` now\n"


def _ids(text: str) -> list[str]:
    return re.findall(r"^(\b[0-9a-f]{8}\b)", text, re.M)


def _anna(server: LiveServer) -> Callable[[], None]:
    """Have Anna enter and take control; return what has her do one thing."""
    anna: Browser = server.join(server.enter("Anna"))
    anna.wait("state", lambda message: message["state"] is not None)
    lease = anna.take_control()

    def work() -> None:
        assert anna.answer(anna.command(lease, "line", line="DO a = 1"))["type"] == "result"

    return work


def main() -> None:
    """Write the page anew."""
    text = PAGE.read_text("utf-8")
    before = re.search(rf"^{re.escape(HEAD)}(?:\|.*\n)+|^<!-- limits -->\n", text, re.M)
    assert before is not None
    text = text[: before.start()] + limit_table() + text[before.end() :]
    with TemporaryDirectory() as temporary:
        steps = list(follow(text, Path(temporary)))
    for step in reversed(steps):
        if not fits(step):
            text = text[: step.start] + step.real + text[step.end :]
    PAGE.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
