"""Every name of one source: where its programs begin, what is used in them, what data it holds."""

import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cache, cached_property
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.ir.entry import Outline, entry_among
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.headers import is_remarks, read_header
from vrts.lang.reading.sections.lines import Section
from vrts.lang.reading.splitter import split
from vrts.lang.syntax.program import Formal
from vrts.lsp.documents.uses import Kind, Role, Use, read_line, variable_kind

MOST_KEPT = 2000  # programs
_HEADER_NAME = re.compile(r"\.?PROGRAM[ \t]+(?P<name>[A-Za-z][\w.]*)", re.IGNORECASE | re.ASCII)
_DATUM = re.compile(r"(?P<name>[$#]?[A-Za-z][\w.]*)[ \t]*(?:\[[^\]]*\])?", re.ASCII)
_SHARED = frozenset({Kind.FUNCTION, Kind.CONSTANT, Kind.SIGNAL})  # the same in every file
VARIABLES = frozenset({Kind.VARIABLE, Kind.LOCATION, Kind.JOINTS, Kind.STRING})


class Target(NamedTuple):
    """What a name means: the same target is the same thing."""

    name: str
    family: str  # "program", "label", "variable", "function", "constant", "signal"
    program: str = ""  # whose own it is: labels, formals, AUTO, LOCAL


class Occurrence(NamedTuple):
    """A name at a place of the source."""

    target: Target
    kind: Kind
    role: Role
    start: int
    end: int
    sure: bool


class ProgramNames(NamedTuple):
    """One program."""

    name: str  # empty: none is written yet
    formals: tuple[Formal, ...]
    section: Section
    name_start: int
    name_end: int

    @property
    def start(self) -> int:
        """Where its header begins."""
        return self.section.header.start

    @property
    def end(self) -> int:
        """Where it ends."""
        return max(self.section.finish[1], self.section.header.end)


class Names:
    """The names of a source, in the order of the text."""

    def __init__(
        self,
        programs: tuple[ProgramNames, ...],
        data: tuple[Section, ...],
        occurrences: tuple[Occurrence, ...],
    ) -> None:
        self.programs = programs
        self.data = data  # its data sections
        self.occurrences = occurrences

    @cached_property
    def by_target(self) -> dict[Target, list[Occurrence]]:
        """Occurrences of each target."""
        found: dict[Target, list[Occurrence]] = {}
        for occurrence in self.occurrences:
            found.setdefault(occurrence.target, []).append(occurrence)
        return found

    def at(self, offset: int) -> Occurrence | None:
        """Return the name at an offset, or the one that ends there."""
        inside = [o for o in self.occurrences if o.start <= offset <= o.end]
        return max(inside, key=lambda o: (offset < o.end, o.start), default=None)

    def program_at(self, offset: int) -> ProgramNames | None:
        """Return the program around an offset."""
        at = bisect_right(self.programs, offset, key=_start)
        return self.programs[at - 1] if at else None

    @cached_property
    def entry(self) -> str | None:
        """The program that is executed where nothing names one; None where there is none."""
        calls: dict[str, set[str]] = {program.name: set() for program in self.programs}
        for occurrence in self.occurrences:
            if occurrence.target.family != "program" or occurrence.role is Role.WRITE:
                continue
            around = self.program_at(occurrence.start)
            if around is not None:
                calls[around.name].add(occurrence.target.name)
        found = entry_among(
            [
                Outline(program.name, bool(program.formals), frozenset(calls[program.name]))
                for program in self.programs
                if program.name
            ]
        )
        return None if found is None else found.name

    @cached_property
    def defined_programs(self) -> frozenset[str]:
        """Programs that stand here."""
        return self._defined("program")

    @cached_property
    def defined_variables(self) -> frozenset[str]:
        """Shared names that get a value here."""
        return self._defined("variable")

    @cached_property
    def missing_programs(self) -> frozenset[str]:
        """Programs that are called here and stand elsewhere."""
        return self._used("program") - self.defined_programs

    @cached_property
    def missing_variables(self) -> frozenset[str]:
        """Shared names that are used here and get their values elsewhere."""
        return self._used("variable") - self.defined_variables

    def summarise(self) -> None:
        """Work out now what linking asks for; it is kept."""
        _ = self.missing_programs, self.missing_variables

    def _used(self, family: str) -> frozenset[str]:
        return frozenset(t.name for t in self.by_target if t.family == family and not t.program)

    def _defined(self, family: str) -> frozenset[str]:
        return frozenset(
            target.name
            for target, found in self.by_target.items()
            if target.family == family
            and not target.program
            and any(o.role is Role.WRITE for o in found)
        )

    def kind_of(self, target: Target) -> Kind | None:
        """Return what a target is; None when it does not occur."""
        found = self.by_target.get(target)
        if not found:
            return None
        return next((o.kind for o in found if o.sure), found[0].kind)


def _start(program: ProgramNames) -> int:
    return program.start


def names_of(source: SourceFile, dialect: Dialect) -> Names:
    """Return the names of a source. Never fails, whatever is written."""
    problems = Problems(source, dialect)
    sections = [s for s in split(problems) if not is_remarks(s, dialect)]
    programs: list[ProgramNames] = []
    data: list[Section] = []
    found: list[Occurrence] = []
    for section in sections:
        if section.kind == "program":
            program = _program(section, source)
            programs.append(program)
            found += _of_program(program, source, dialect)
        else:
            data.append(section)
            found += _of_data(section)
    return Names(tuple(programs), tuple(data), tuple(found))


def _program(section: Section, source: SourceFile) -> ProgramNames:
    name, formals = read_header(section, Problems(source))
    match = _HEADER_NAME.match(section.header.text)
    at = section.header.start
    if match is None:
        return ProgramNames(name, formals, section, at, at)
    return ProgramNames(name, formals, section, at + match.start("name"), at + match.end("name"))


def _of_program(program: ProgramNames, source: SourceFile, dialect: Dialect) -> list[Occurrence]:
    """Return the names of a program; one whose text is known is not read again."""
    known = _summaries(dialect)
    at = program.start
    text = source.text[at : program.end]
    summary = known.get(text)
    if summary is None:
        if len(known) >= MOST_KEPT:
            known.clear()
        summary = known[text] = tuple(
            Occurrence(t, kind, role, start - at, end - at, sure)
            for t, kind, role, start, end, sure in _read(program, dialect)
        )
    return [Occurrence(t, k, r, s + at, e + at, sure) for t, k, r, s, e, sure in summary]


@cache
def _summaries(dialect: Dialect) -> dict[str, tuple[Occurrence, ...]]:
    """Return the names of programs of a dialect by their text; offsets count from its start."""
    return {}


def _read(program: ProgramNames, dialect: Dialect) -> Iterator[Occurrence]:
    if program.name_end > program.name_start:
        target = Target(program.name, "program")
        place = (program.name_start, program.name_end)
        yield Occurrence(target, Kind.PROGRAM, Role.WRITE, *place, sure=True)
    lines = [(line.start, read_line(line.text, dialect).uses) for line in program.section.lines]
    own = {key(formal.name.text) for formal in program.formals if formal.name.text}
    own.update(use.name for _, found in lines for use in found if use.role is Role.OWN)
    for formal in program.formals:
        name = formal.name
        if name.text:
            target = Target(key(name.text), "variable", program.name)
            kind = variable_kind(name.text)
            yield Occurrence(target, kind, Role.WRITE, name.start, name.end, sure=False)
    for start, found in lines:
        for use in found:
            role = Role.WRITE if use.role is Role.OWN else use.role
            target = _target(use, program.name, own)
            yield Occurrence(target, use.kind, role, start + use.start, start + use.end, use.sure)


def _target(use: Use, program: str, own: set[str]) -> Target:
    if use.kind in _SHARED or use.kind is Kind.PROGRAM:
        return Target(use.name, use.kind.value)
    if use.kind is Kind.LABEL:
        return Target(use.name, "label", program)
    is_own = use.name in own or use.name.lstrip("$#").startswith(".")
    return Target(use.name, "variable", program if is_own else "")


def _of_data(section: Section) -> Iterator[Occurrence]:
    for line in section.lines:
        match = _DATUM.match(line.text)
        if match is None:
            continue
        name = match["name"]
        kind = variable_kind(name)
        if kind is Kind.VARIABLE and section.kind == "locations":
            kind = Kind.LOCATION
        target = Target(key(name), "variable")
        start = line.start + match.start("name")
        yield Occurrence(target, kind, Role.WRITE, start, start + len(name), sure=True)
