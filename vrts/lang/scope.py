"""What is known of every name of one compilation: its uses, its type, its values."""

from dataclasses import dataclass, field
from typing import NamedTuple

from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.lang.syntax import Expression, ProgramText

Place = tuple[int, int]  # range of offsets


class Passed(NamedTuple):
    """A variable passed to a program by reference."""

    program: str
    argument: int
    array: bool


@dataclass(slots=True)
class Entry:
    """Uses of one name."""

    name: str
    formal: int | None = None  # slot number
    types: dict[Type, Place] = field(default_factory=dict[Type, Place])  # first use as each type
    reads: list[Place] = field(default_factory=list[Place])
    writes: list[Place] = field(default_factory=list[Place])
    passed: list[Passed] = field(default_factory=list[Passed])
    scalar: Place | None = None
    array: Place | None = None
    spellings: dict[str, Place] = field(default_factory=dict[str, Place])
    values: list[Expression] = field(default_factory=list[Expression])  # all that is assigned

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
        for program in programs:
            slots: dict[str, Entry] = {}
            for i, formal in enumerate(program.formals):
                if formal.name.text:
                    name = key(formal.name.text)
                    slots[name] = Entry(name, i)
            self.formals[program.name] = slots

    def entry(self, program: str | None, name: str) -> Entry:
        """Return what is known of a name as a program sees it."""
        if program is not None:
            formal = self.formals[program].get(name)
            if formal is not None:
                return formal
        found = self.entries.get(name)
        if found is None:
            found = self.entries[name] = Entry(name)
        return found

    def all_entries(self) -> list[Entry]:
        """Return every name, globals first."""
        return [*self.entries.values(), *(e for f in self.formals.values() for e in f.values())]

    def spread_types(self) -> None:
        """Give a name passed by reference the type its formal has, until nothing changes."""
        changed = True
        while changed:
            changed = False
            for entry in self.all_entries():
                if entry.type is not Type.DYNAMIC:
                    continue
                for passed in entry.passed:
                    formal = self.formal(passed)
                    if formal is not None and formal.type in (Type.REAL, Type.POSE):
                        entry.types[formal.type] = next(iter(entry.spellings.values()), (0, 0))
                        changed = True
                        break

    def formal(self, passed: Passed) -> Entry | None:
        """Return the formal a variable is passed to, if the program is known."""
        program = self.programs.get(passed.program)
        if program is None or passed.argument >= len(program.formals):
            return None
        name = program.formals[passed.argument].name.text
        return self.formals[program.name].get(key(name)) if name else None

    def may_have_value(self, entry: Entry, seen: frozenset[int] = frozenset()) -> bool:
        """Return whether anything gives a name a value, also through calls."""
        if entry.writes or entry.formal is not None:
            return True
        for passed in entry.passed:
            formal = self.formal(passed)
            if formal is None or formal.writes:
                return True
            if id(formal) not in seen and formal.passed:
                seen = seen | {id(formal)}
                if any(self._written(p, seen) for p in formal.passed):
                    return True
        return False

    def _written(self, passed: Passed, seen: frozenset[int]) -> bool:
        formal = self.formal(passed)
        if formal is None or formal.writes:
            return True
        if id(formal) in seen:
            return False
        return any(self._written(p, seen | {id(formal)}) for p in formal.passed)
