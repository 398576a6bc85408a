"""What the word that is being typed may become."""

import re
from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions
from vrts.lang.vocabulary.lookup import instructions_of
from vrts.lang.vocabulary.words import OPERATORS
from vrts.lsp.answers.symbols import header_of
from vrts.lsp.answers.wanted import ANYTHING, takes_signals, wanted
from vrts.lsp.documents.asking import Asked, asked_at
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Target
from vrts.lsp.documents.uses import PROGRAM_WORDS, Kind
from vrts.lsp.documents.words import function_help, instruction_help, named_usage

_SECTIONS = {
    ".PROGRAM": "begins a program",
    ".END": "ends a program or a section of data",
    ".LOCATIONS": "names with X Y Z O A T, or joints",
    ".REALS": "names with numbers",
    ".STRINGS": "names with texts",
}
_JUMPS = frozenset({"GOTO"})
_CALLS = frozenset({"CALL"}) | PROGRAM_WORDS
_SIGNAL_PLACES = re.compile(
    r"^[ \t]*(?:\d+[ \t]+)?(?:SIGNAL|REACTI?|IGNORE|RUNSIG|SWAIT)[ \t]+([^\n;]*)"
    r"|\bSIG[ \t]*\(([^\n;)]*)",
    re.IGNORECASE | re.MULTILINE,
)
_NAMES = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_TYPES = {
    Kind.VARIABLE: Type.REAL,
    Kind.LOCATION: Type.POSE,
    Kind.JOINTS: Type.JOINTS,
    Kind.STRING: Type.STRING,
}
_REACTIONS = frozenset({"REACT", "REACTI"})
MOST = 1000  # proposals


class What(Enum):
    """What a proposal is."""

    INSTRUCTION = "instruction"
    QUALIFIER = "qualifier"
    FUNCTION = "function"
    CONSTANT = "constant"
    PROGRAM = "program"
    LABEL = "label"
    LOCATION = "location"
    VARIABLE = "variable"
    SIGNAL = "signal"
    SECTION = "section"


class Proposal(NamedTuple):
    """A word that may be meant."""

    text: str
    what: What
    detail: str = ""
    about: str = ""
    rank: int = 1  # smaller comes first


class Completion(NamedTuple):
    """Proposals in place of what is typed so far."""

    start: int
    end: int
    proposals: tuple[Proposal, ...]
    is_all: bool = True  # whether there are no more that begin like this


def complete(
    document: Document,
    offset: int,
    group: Sequence[Document],
    beside: Sequence[Document] = (),
) -> Completion:
    """Return what the word before an offset may become.

    Args:
        document: The buffer.
        offset: Of the cursor.
        group: Files that belong together with it, itself first.
        beside: All files of its folder: programs of theirs may be called, and data of those that
            hold nothing else may be used, from now on.
    """
    asked = asked_at(document, offset)
    if asked.silent:
        return Completion(offset, offset, ())
    data = [d for d in beside if d not in group and not d.names.programs]
    group = [*group, *data]
    start = asked.prefix.lower()
    found = {
        (p.text, p.what): p
        for p in _proposals(document, asked, group, beside)
        if p.text and p.text.lower().startswith(start) and p.text.lower() != start
    }
    ordered = sorted(found.values(), key=lambda p: (p.rank, p.text.lower()))
    return Completion(asked.start, offset, tuple(ordered[:MOST]), len(ordered) <= MOST)


def _proposals(
    document: Document, asked: Asked, group: Sequence[Document], beside: Sequence[Document]
) -> Iterator[Proposal]:
    names = [d.names for d in group]
    word = asked.word.canonical if asked.word is not None else ""
    if asked.is_first:
        if asked.prefix.startswith(".") or not asked.before.strip():
            yield from (Proposal(t, What.SECTION, "", a, 3) for t, a in _SECTIONS.items())
        for text, known in instructions_of(document.dialect).items():
            if not known.means:
                yield Proposal(text, What.INSTRUCTION, known.usage, instruction_help(known), 2)
        yield from _variables(document, asked, group)
        return
    before = asked.before[: len(asked.before) - len(asked.prefix)].split()
    if (word in _CALLS or (word in _REACTIONS and asked.operand == 1)) and asked.call is None:
        for other in (*group, *(d for d in beside if d not in group)):
            for program in other.names.programs:
                detail = header_of(program)
                if other is not document:
                    detail += f" in {other.source.name}"
                rank = 0 if other in group else 1
                yield Proposal(program.name, What.PROGRAM, detail, "", rank)
        return
    if (word in _JUMPS and len(before) == 1) or before[-1].upper() == "GOTO":
        yield from _labels(document, asked)
        return
    if word in ("ENABLE", "DISABLE"):
        yield from (Proposal(s.name, What.CONSTANT, "", s.about) for s in SWITCHES.values())
        return
    if word == "PARAMETER" and len(before) == 1:
        yield from (Proposal(p.name, What.CONSTANT, p.unit, p.about) for p in PARAMETERS.values())
        return
    if takes_signals(asked):
        numbers = {t.name for n in names for t in n.by_target if t.family == "signal"}
        yield from (Proposal(number, What.SIGNAL, "used here", "", 0) for number in numbers)
        for name in {n for other in group for n in _signal_names(other)}:
            yield Proposal(name, What.SIGNAL, "the number of a signal here", "", 0)
    yield from _operands(document, asked, group)


def _operands(document: Document, asked: Asked, group: Sequence[Document]) -> Iterator[Proposal]:
    yield from _variables(document, asked, group)
    types = wanted(asked)
    for name, function in applied_functions(document.dialect).items():
        if function.result in types:
            about = function_help(function)
            yield Proposal(name.upper(), What.FUNCTION, named_usage(function), about, 2)
    if Type.REAL in types:
        yield from (
            Proposal(name.upper(), What.CONSTANT, f"{value:g}", "", 3)
            for name, value in CONSTANTS.items()
        )
    qualifiers = asked.word.qualifiers if asked.word is not None else frozenset[str]()
    yield from (Proposal(text, What.QUALIFIER, "", "", 2) for text in sorted(qualifiers))
    if Type.REAL in types:
        yield from (Proposal(t, What.QUALIFIER, w.usage, w.about, 3) for t, w in OPERATORS.items())


def _variables(document: Document, asked: Asked, group: Sequence[Document]) -> Iterator[Proposal]:
    program = document.names.program_at(asked.start)
    own = program.name if program is not None else ""
    types = ANYTHING if asked.is_first else wanted(asked)
    seen: dict[Target, Kind] = {}
    sure: set[Target] = set()
    for other in group:
        for target, found in other.names.by_target.items():
            if target.family != "variable" or (target.program and other is not document):
                continue
            if not target.name.startswith(asked.prefix.lower()):
                continue
            if target.program not in ("", own) or all(o.start == asked.start for o in found):
                continue  # another program's own, or the very word that is typed
            kind = other.names.kind_of(target) or Kind.VARIABLE
            if any(o.sure for o in found):
                sure.add(target)
            if seen.get(target) in (None, Kind.VARIABLE):
                seen[target] = kind
    for target, kind in seen.items():
        place = kind in (Kind.LOCATION, Kind.JOINTS)
        what = What.LOCATION if place else What.VARIABLE
        own_type = _TYPES[kind]
        fits = own_type in types
        may = target not in sure and kind is Kind.VARIABLE and Type.POSE in types
        if not fits and not may:
            continue
        rank = 0 if fits and place == (Type.POSE in types) else 1
        detail = kind.value + (f" of {target.program}" if target.program else "")
        yield Proposal(target.name, what, detail, "", rank)


def _signal_names(document: Document) -> set[str]:
    """Return the variables that stand for signals somewhere in a file."""
    found: set[str] = set()
    for listed in _SIGNAL_PLACES.findall(document.source.text):
        found.update(name.lower() for part in listed for name in _NAMES.findall(part))
    known = document.names.by_target
    return {n for n in found if Target(n, "variable") in known}


def _labels(document: Document, asked: Asked) -> Iterator[Proposal]:
    program = document.names.program_at(asked.start)
    own = program.name if program is not None else ""
    for target in document.names.by_target:
        if target.family == "label" and target.program == own:
            yield Proposal(target.name, What.LABEL, f"label of {own}", "", 0)
