"""A program before it is printed: what an author thinks of, and what one who copies changes."""

import re
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass, field

Values = tuple[float, float, float, float, float, float]  # X Y Z [mm], O A T [deg]
NAME = re.compile(r'"[^"]*"|[A-Za-z_][A-Za-z0-9_.]*')
WORDS_TEXT = """
    ALWAYS AND BY DX DY DZ DISTANCE INVERSE NOT OR SHIFT SIG TIMER TRANS TRUE FALSE MMPS
"""
WORDS = frozenset(WORDS_TEXT.split())
NO_NAMES = ("NOTE", "BLANK", "GOTO")  # lines whose arguments hold no names


@dataclass
class Line:
    """A statement with all that belongs to it, or a line without one.

    `LET` is an assignment, `NOTE` a comment of its own, `BLANK` an empty line, `IFGOTO` a jump
    under a condition; all other words are VAL-II's.
    """

    word: str
    args: list[str] = field(default_factory=list[str])
    note: str = ""  # comment behind it
    part: str = ""  # goal that it serves alone; parts may change places
    label: str = ""
    body: list["Line"] | None = None
    other: list["Line"] | None = None  # below ELSE

    @property
    def blocks(self) -> list[list["Line"]]:
        """The blocks inside of it."""
        return [block for block in (self.body, self.other) if block is not None]


@dataclass
class Unit:
    """A `.PROGRAM`."""

    name: str
    params: list[str]
    body: list[Line]
    notes: list[str] = field(default_factory=list[str])  # lines above it


@dataclass
class Program:
    """A whole file; the first unit is the main one."""

    units: list[Unit]
    places: dict[str, Values]
    head: list[str] = field(default_factory=list[str])  # comment lines at the top
    roles: dict[str, str] = field(default_factory=dict[str, str])  # keys of scenes, by name

    @property
    def main(self) -> Unit:
        """The unit that is executed."""
        return self.units[0]

    def copy(self) -> "Program":
        """Return a copy of everything."""
        return deepcopy(self)

    def unit(self, name: str) -> Unit | None:
        """Return the unit of a name."""
        return next((one for one in self.units if one.name == name), None)

    def lines(self) -> Iterator[Line]:
        """Yield every line, with those in blocks."""
        for unit in self.units:
            yield from every(unit.body)

    def blocks(self) -> Iterator[list[Line]]:
        """Yield every list of lines."""
        for unit in self.units:
            yield unit.body
            for line in every(unit.body):
                yield from line.blocks


def every(lines: list[Line]) -> Iterator[Line]:
    """Yield lines, and those in their blocks."""
    for line in lines:
        yield line
        for block in line.blocks:
            yield from every(block)


def names_in(text: str) -> list[str]:
    """Return the user's names in an argument, as often as they stand there."""
    found = NAME.findall(text)
    return [one for one in found if not one.startswith('"') and one.upper() not in WORDS]


def replaced(text: str, changed: Callable[[str], str]) -> str:
    """Return an argument with other names."""

    def one(match: re.Match[str]) -> str:
        word = match[0]
        return word if word.startswith('"') or word.upper() in WORDS else changed(word)

    return NAME.sub(one, text)


def names_of(program: Program) -> list[str]:
    """Return every name of a program once, in the order of their first use."""
    found: dict[str, None] = {}
    for unit in program.units:
        found.update(dict.fromkeys([unit.name, *unit.params]))
        for line in every(unit.body):
            if line.word not in NO_NAMES:
                found.update(dict.fromkeys(n for arg in line.args for n in names_in(arg)))
    found.update(dict.fromkeys(program.places))
    return list(found)


def rename(program: Program, names: dict[str, str]) -> None:
    """Give names other ones, everywhere."""

    def changed(name: str) -> str:
        return names.get(name, name)

    for unit in program.units:
        unit.name = changed(unit.name)
        unit.params = [changed(name) for name in unit.params]
        rename_lines(unit.body, names)
    program.places = {changed(name): values for name, values in program.places.items()}
    program.roles = {changed(name): key for name, key in program.roles.items()}


def rename_lines(lines: list[Line], names: dict[str, str]) -> None:
    """Give names in lines other ones."""

    def changed(name: str) -> str:
        return names.get(name, name)

    for line in every(lines):
        if line.word not in NO_NAMES:
            line.args = [replaced(arg, changed) for arg in line.args]
