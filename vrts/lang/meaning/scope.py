"""What is known of every name of one compilation: its uses, its type, its values."""

from dataclasses import dataclass, field
from typing import NamedTuple

from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Expression, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad, Declare

Place = tuple[int, int]  # range of offsets


class Passed(NamedTuple):
    """A variable passed to a program by reference."""

    program: str
    argument: int
    array: bool
    at: Place = (0, 0)


@dataclass(slots=True)
class Entry:
    """Uses of one name."""

    name: str
    slot: int | None = None  # of a formal, or of a variable of each call
    automatic: bool = False  # a variable of each call: AUTO, or `.x` of AS
    stored: str = ""  # name in memory of a LOCAL variable; empty: its own
    types: dict[Type, Place] = field(default_factory=dict[Type, Place])  # first use as each type
    reads: list[Place] = field(default_factory=list[Place])
    writes: list[Place] = field(default_factory=list[Place])
    passed: list[Passed] = field(default_factory=list[Passed])
    scalar: Place | None = None
    array: Place | None = None
    spellings: dict[str, Place] = field(default_factory=dict[str, Place])
    both: bool = False  # AS: a number and a location of the same name, two variables
    asked: bool = False  # DEFINED and its like look whether it has a value
    changed: bool = False  # given a value by something else than `=`
    written_in: set[str | None] = field(default_factory=set[str | None])  # programs, by CALL too
    values: list[Expression] = field(default_factory=list[Expression])  # all that is assigned
    given: dict[Type, Place] = field(default_factory=dict[Type, Place])  # first value of each type

    @property
    def type(self) -> Type:
        """Type of the name; DYNAMIC when nothing tells."""
        if self.name[0] == "$":
            return Type.STRING
        if self.name[0] == "#":
            return Type.JOINTS
        return next(iter(self.types), Type.DYNAMIC)


class Scope:
    """Globals of the compilation and formals of its programs."""

    def __init__(self, programs: list[ProgramText]) -> None:
        self.programs = {program.name: program for program in programs}
        self.entries: dict[str, Entry] = {}
        self.formals: dict[str, dict[str, Entry]] = {}
        self.unread: set[str] = set()  # programs with steps that could not be read
        self.slots = {program.name: len(program.formals) for program in programs}  # the next ones
        for program in programs:
            slots: dict[str, Entry] = {}
            for i, formal in enumerate(program.formals):
                if formal.name.text:
                    name = key(formal.name.text)
                    slots[name] = Entry(name, i)
            self.formals[program.name] = slots
            for step in program.steps:
                if isinstance(step.statement, Declare):
                    self._declare(program, step.statement, slots)
                elif isinstance(step.statement, Bad):
                    self.unread.add(program.name)

    def entry(self, program: str | None, name: str) -> Entry:
        """Return what is known of a name as a program sees it."""
        if program is not None:
            own = self.formals[program]
            formal = own.get(name)
            if formal is not None:
                return formal
            if name[0] == "." or (name[0] in "$#" and name[1:2] == "."):  # `.x`, `$.x` of AS
                return self._automatic(program, own, name)
        found = self.entries.get(name)
        if found is None:
            found = self.entries[name] = Entry(name)
        return found

    def _declare(self, program: ProgramText, node: Declare, own: dict[str, Entry]) -> None:
        """Make the variables of AUTO and LOCAL; GLOBAL needs none."""
        for written in node.names:
            name = written.name if isinstance(written, Element) else written
            if not isinstance(name, Name) or node.word == "GLOBAL" or key(name.text) in own:
                continue
            where = (name.start, name.end)
            if node.word == "AUTO":
                entry = self._automatic(program.name, own, key(name.text))
            else:
                stored = f"{key(name.text)}@{program.name}"
                entry = own[key(name.text)] = Entry(key(name.text), stored=stored)
            if isinstance(written, Element):
                entry.array = where
            kind = {"REAL": Type.REAL, "DOUBLE": Type.REAL, "LOC": Type.POSE}.get(node.kind or "")
            if kind is not None and name.text[0] not in "$#":
                entry.types[kind] = where

    def _automatic(self, program: str, own: dict[str, Entry], name: str) -> Entry:
        """Make a variable of each call, with the slot after those there are."""
        slot = self.slots[program]
        self.slots[program] += 1
        entry = own[name] = Entry(name, slot, automatic=True)
        return entry

    def automatics(self, program: str) -> list[Entry]:
        """Return the variables of each call of a program, in the order of their slots."""
        return [entry for entry in self.formals[program].values() if entry.automatic]

    def all_entries(self) -> list[Entry]:
        """Return every name, globals first."""
        return [*self.entries.values(), *(e for f in self.formals.values() for e in f.values())]

    def formal(self, passed: Passed) -> Entry | None:
        """Return the formal a variable is passed to, if the program is known."""
        program = self.programs.get(passed.program)
        if program is None or passed.argument >= len(program.formals):
            return None
        name = program.formals[passed.argument].name.text
        return self.formals[program.name].get(key(name)) if name else None

    def may_have_value(self, entry: Entry) -> bool:
        """Return whether anything gives a name a value, also through calls."""
        if entry.slot is not None and not entry.automatic:
            return True
        seen: set[int] = set()
        waiting = [entry]
        while waiting:
            found = waiting.pop()
            if found.writes:
                return True
            for passed in found.passed:
                formal = self.formal(passed)
                if formal is None or passed.program in self.unread:
                    return True
                if id(formal) not in seen:
                    seen.add(id(formal))
                    waiting.append(formal)
        return False


def location_name(name: str) -> str:
    """Return the name in memory of a location of AS that shares its name with a number."""
    return f"&{name}"
