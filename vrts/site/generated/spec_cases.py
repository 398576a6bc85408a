"""Cases of `tests/spec` as examples: each is executed by a test, with what it types and does."""

import re
from pathlib import Path
from typing import NamedTuple

from vrts.lang.dialect import DIALECTS

_HEADING = re.compile(r"^## (.*)$", re.M)
_BLOCK = re.compile(r"^```([\w+]+)(?: on (\w+)| (\S+))?\n(.*?)^```$", re.M | re.S)
_PARTS = {  # what follows a program, and how a page calls it
    "scenario": "From outside comes",
    "command": "It is started by",
    "output": "It types",
    "error": "It stops with",
    "events": "What happens, and when (seconds)",
}
_NOT_CODE = re.compile(r'"[^"\n]*"|;.*$', re.M)
_TOKEN = re.compile(r"[$#]?[A-Z][A-Z0-9]*(?:\.[A-Z0-9]+)*")
MOST_LINES = 26  # of a program and what belongs to it


class SpecCase(NamedTuple):
    """One program of the spec and what is shown of it."""

    where: str  # file and line
    title: str
    dialect: str
    program: str
    parts: tuple[tuple[str, str, str], ...]  # kind, how it is called, text

    @property
    def lines(self) -> int:
        """How long it is on a page."""
        return sum(text.count("\n") for text in (self.program, *(part[2] for part in self.parts)))

    @property
    def firsts(self) -> frozenset[str]:
        """Words with which steps begin."""
        lines = _NOT_CODE.sub("", self.program).splitlines()
        words = (re.sub(r"^\s*\d+\s+", "", line).split() or [""] for line in lines)
        return frozenset(_TOKEN.findall(" ".join(word[0] for word in words)))

    @property
    def words(self) -> frozenset[str]:
        """Words anywhere in it."""
        return frozenset(_TOKEN.findall(_NOT_CODE.sub("", self.program)))


class Dialogue(NamedTuple):
    """A conversation with the monitor."""

    title: str
    program: str
    transcript: str

    @property
    def commands(self) -> frozenset[str]:
        """First words of what is typed."""
        return frozenset(re.findall(r"^\.([A-Z][A-Z.]*)", self.transcript, re.M))


def run_cases(spec: Path) -> tuple[SpecCase, ...]:
    """Return the programs that the pages `run-*.md` execute, with what the pages say of them."""
    found: list[SpecCase] = []
    for page in sorted(spec.glob("run-*.md")):
        text = page.read_text("utf-8")
        for block in _BLOCK.finditer(text):
            kind, robot, _, body = block.groups()
            if kind in DIALECTS:
                line = text[: block.start()].count("\n") + 1
                title = _title(text, block.start())
                parts = (("robot", "The robot is", robot),) if robot else ()
                found.append(SpecCase(f"{page.name}:{line}", title, kind, body, parts))
            else:
                last = found.pop()
                found.append(last._replace(parts=(*last.parts, (kind, _PARTS[kind], body))))
    return tuple(found)


def dialogues(spec: Path) -> tuple[Dialogue, ...]:
    """Return the conversations of the pages `monitor-*.md`, with the programs that they use."""
    found: list[Dialogue] = []
    for page in sorted(spec.glob("monitor-*.md")):
        text = page.read_text("utf-8")
        programs: dict[str, str] = {}
        for block in _BLOCK.finditer(text):
            title = _title(text, block.start())
            if block[1] == "monitor":
                found.append(Dialogue(title, programs.get(title, ""), block[4]))
            else:
                programs[title] = block[4]
    return tuple(found)


def _title(text: str, before: int) -> str:
    """Return the heading above a place, without the numbers of cases."""
    titles = _HEADING.findall(text, 0, before)
    return re.sub(r" \(C\d.*\)$", "", titles[-1]) if titles else ""
