"""Reads `tests/data/mistakes`: programs with one mistake each, what was meant, and right programs.

How the files are written stands in the README beside them.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from tests.places import TESTS
from vrts.lang.dialect import DIALECTS, Dialect

FOLDER = TESTS / "data" / "mistakes"
SEVERITIES = {
    "error": frozenset({"error"}),
    "warning": frozenset({"warning"}),
    "either": frozenset({"error", "warning"}),
}
CASE = re.compile(
    r"^## (?P<name>[a-z0-9-]+)\n(?P<about>(?:.+\n)*?)```\n(?P<body>(?:.*\n)*?)```$", re.M
)
FIRST = re.compile(r"(?P<severity>[a-z]+) (?P<low>\d)(?:-(?P<high>\d))?(?P<edit> edit)?")
WRONG, MEANT, PLACE, WRONG_PLACE, BOTH = "-", "+", "!", ">", " "


class BadCaseError(ValueError):
    """A case that the README's format does not allow."""


@dataclass(frozen=True, slots=True)
class Mistake:
    """One program with one mistake."""

    family: str
    name: str
    wrong: str
    meant: str
    lines: frozenset[int]  # on one of which the first message stands, counted from 1
    about: tuple[str, ...]  # one of which a good message names, lower case
    help: tuple[str, ...]  # one of which a good help names, lower case
    count: range  # how many diagnostics are right
    severities: frozenset[str]
    certain: bool  # whether an edit must make the program that was meant
    pair: str | None  # the situation that this one is easily confused with
    dialect: Dialect | None  # in which it is compiled; None where the text tells


class Right(NamedTuple):
    """One program without a mistake."""

    family: str
    name: str
    text: str


def mistakes(folder: Path = FOLDER) -> list[Mistake]:
    """Return every program with a mistake, in the order of the files."""
    return [
        _mistake(path.stem, match)
        for path in sorted(folder.glob("[0-9]*.md"))
        for match in _cases(path)
    ]


def right(folder: Path = FOLDER / "right") -> list[Right]:
    """Return every program without a mistake, in the order of the files."""
    return [
        Right(path.stem, match["name"], match["body"])
        for path in sorted(folder.glob("*.md"))
        for match in _cases(path)
    ]


def _cases(path: Path) -> list[re.Match[str]]:
    text = path.read_text("utf-8")
    found = list(CASE.finditer(text))
    if len(found) != len(re.findall(r"^## ", text, re.M)):
        raise BadCaseError(f"{path.name}: a case has no program, or is written otherwise")
    return found


def _mistake(family: str, match: re.Match[str]) -> Mistake:
    name = match["name"]
    head, *rest = match["about"].splitlines()
    first = FIRST.fullmatch(head)
    if first is None or first["severity"] not in SEVERITIES:
        raise BadCaseError(f"{name}: {head!r} is no severity and count")
    keys = dict(line.split(": ", 1) for line in rest)
    if not {"about", "help"} <= keys.keys() <= {"about", "help", "pair", "dialect"}:
        raise BadCaseError(f"{name}: it needs about and help, and may have pair or dialect")
    dialect = keys.get("dialect")
    if dialect is not None and dialect not in DIALECTS:
        raise BadCaseError(f"{name}: {dialect!r} is no dialect")
    wrong, meant, lines = _programs(name, match["body"].splitlines())
    low = int(first["low"])
    return Mistake(
        family=family,
        name=name,
        wrong=wrong,
        meant=meant,
        lines=lines,
        about=_words(keys["about"]),
        help=_words(keys["help"]),
        count=range(low, int(first["high"] or low) + 1),
        severities=SEVERITIES[first["severity"]],
        certain=first["edit"] is not None,
        pair=keys.get("pair"),
        dialect=DIALECTS[dialect] if dialect is not None else None,
    )


def _words(text: str) -> tuple[str, ...]:
    return tuple(word.strip().lower() for word in text.split(" | "))


def _programs(name: str, rows: list[str]) -> tuple[str, str, frozenset[int]]:
    wrong: list[str] = []
    meant: list[str] = []
    marked: list[int] = []
    removed: list[int] = []
    for row in rows:
        mark, text = row[:1] or BOTH, row[2:]
        if mark not in (WRONG, MEANT, PLACE, WRONG_PLACE, BOTH) or row[1:2] not in ("", " "):
            raise BadCaseError(f"{name}: {row!r} does not begin with a mark and a blank")
        if mark != MEANT:
            wrong.append(text)
        if mark in (MEANT, PLACE, BOTH):
            meant.append(text)
        if mark in (PLACE, WRONG_PLACE):
            marked.append(len(wrong))
        if mark in (WRONG, WRONG_PLACE):
            removed.append(len(wrong))
    lines = marked or removed[:1]
    if not lines or wrong == meant:
        raise BadCaseError(f"{name}: it does not show where the mistake stands")
    return _text(wrong), _text(meant), frozenset(lines)


def _text(rows: list[str]) -> str:
    return "".join(f"{row}\n" for row in rows)
