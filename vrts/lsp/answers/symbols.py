"""The outline of a file: its programs with their labels, and its data."""

from bisect import bisect_left
from enum import Enum
from typing import NamedTuple

from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Occurrence, ProgramNames
from vrts.lsp.documents.uses import Kind, Role

MOST_DATA = 2000  # names of data that are listed


class What(Enum):
    """What a symbol is."""

    PROGRAM = "program"
    LABEL = "label"
    SECTION = "section"
    LOCATION = "location"
    NUMBER = "number"
    STRING = "string"


class Symbol(NamedTuple):
    """A piece of a file with a name; offsets into its text."""

    name: str
    detail: str
    what: What
    start: int
    end: int
    name_start: int
    name_end: int
    parts: tuple["Symbol", ...] = ()


def symbols(document: Document) -> list[Symbol]:
    """Return the programs and data sections of a file, in the order of the text."""
    names = document.names
    places = [o for o in names.occurrences if o.kind is Kind.LABEL and o.role is Role.WRITE]
    places.sort(key=_start)
    found = [
        _program(program, _between(places, program.start, program.end))
        for program in names.programs
    ]
    written = [o for o in names.occurrences if o.role is Role.WRITE and o.sure]
    written.sort(key=_start)
    for section in names.data:
        start, end = section.header.start, max(section.finish[1], section.header.end)
        inside = _between(written, start, end)[:MOST_DATA]
        parts = tuple(_datum(document, occurrence) for occurrence in inside)
        header = section.header
        title = header.text.split()[0].upper() if header.text else section.kind
        found.append(Symbol(title, "", What.SECTION, start, end, start, header.end, parts))
    return sorted(found, key=lambda symbol: symbol.start)


def all_symbols(documents: list[Document], query: str) -> list[tuple[Document, Symbol]]:
    """Return the programs and data of some files whose names hold the letters of a query."""
    wanted = query.lower()
    found: list[tuple[Document, Symbol]] = []
    for document in documents:
        for symbol in symbols(document):
            several = symbol.parts if symbol.what is What.SECTION else (symbol,)
            found += [(document, one) for one in several if _holds(one.name.lower(), wanted)]
    return found


def header_of(program: ProgramNames) -> str:
    """Return a program as it is called: name and formals."""
    formals = ", ".join(f.name.text.lower() + ("[]" if f.array else "") for f in program.formals)
    return f"{program.name}({formals})" if formals else program.name


def _start(o: Occurrence) -> int:
    return o.start


def _between(ordered: list[Occurrence], start: int, end: int) -> list[Occurrence]:
    """Return the names that begin in a range, of some in the order of the text."""
    return ordered[bisect_left(ordered, start, key=_start) : bisect_left(ordered, end, key=_start)]


def _program(program: ProgramNames, places: list[Occurrence]) -> Symbol:
    labels = tuple(
        Symbol(o.target.name, "label", What.LABEL, o.start, o.end, o.start, o.end)
        for o in places
        if o.target.program == program.name
    )
    detail = header_of(program)[len(program.name) :]
    place = (program.name_start, program.name_end)
    name = program.name or "(no name)"
    return Symbol(name, detail, What.PROGRAM, program.start, program.end, *place, labels)


def _datum(document: Document, o: Occurrence) -> Symbol:
    source = document.source
    line = source.line_of(o.start)
    start = source.line_starts[line - 1]
    end = start + len(source.line_text(line))
    text = source.text[o.start : end]
    whats = {Kind.LOCATION: What.LOCATION, Kind.JOINTS: What.LOCATION, Kind.STRING: What.STRING}
    name = source.text[o.start : o.end]
    detail = " ".join(text[len(name) :].split())[:80]
    return Symbol(name, detail, whats.get(o.kind, What.NUMBER), o.start, end, o.start, o.end)


def _holds(name: str, wanted: str) -> bool:
    """Return whether the letters of a query stand in a name in their order."""
    at = 0
    for letter in wanted:
        at = name.find(letter, at) + 1
        if not at:
            return False
    return True
