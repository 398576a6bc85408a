"""What the word that is being typed may become."""

from collections.abc import Iterator, Sequence
from enum import Enum
from typing import NamedTuple

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions
from vrts.lang.vocabulary.lookup import instructions_of
from vrts.lang.vocabulary.words import OPERATORS
from vrts.lsp.answers.symbols import header_of
from vrts.lsp.documents.asking import Asked, asked_at
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Target
from vrts.lsp.documents.uses import PROGRAM_WORDS, Kind
from vrts.lsp.documents.words import function_help, function_usage, instruction_help

_SECTIONS = {
    ".PROGRAM": "begins a program",
    ".END": "ends a program or a section of data",
    ".LOCATIONS": "names with X Y Z O A T, or joints",
    ".REALS": "names with numbers",
    ".STRINGS": "names with texts",
}
_JUMPS = frozenset({"GOTO"})
_CALLS = frozenset({"CALL"}) | PROGRAM_WORDS
_SIGNALS = frozenset({"SIGNAL", "REACT", "REACTI", "IGNORE", "RUNSIG"})
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
    if word in _SIGNALS or (asked.call is not None and asked.call.name.upper() == "SIG"):
        numbers = {t.name for n in names for t in n.by_target if t.family == "signal"}
        yield from (Proposal(number, What.SIGNAL, "used here", "", 0) for number in numbers)
    yield from _operands(document, asked, group)


def _operands(document: Document, asked: Asked, group: Sequence[Document]) -> Iterator[Proposal]:
    yield from _variables(document, asked, group)
    for name, function in applied_functions(document.dialect).items():
        about = function_help(function)
        yield Proposal(name.upper(), What.FUNCTION, function_usage(function), about, 2)
    yield from (
        Proposal(name.upper(), What.CONSTANT, f"{value:g}", "", 3)
        for name, value in CONSTANTS.items()
    )
    qualifiers = asked.word.qualifiers if asked.word is not None else frozenset[str]()
    yield from (Proposal(text, What.QUALIFIER, "", "", 2) for text in sorted(qualifiers))
    yield from (Proposal(t, What.QUALIFIER, w.usage, w.about, 3) for t, w in OPERATORS.items())


def _variables(document: Document, asked: Asked, group: Sequence[Document]) -> Iterator[Proposal]:
    program = document.names.program_at(asked.start)
    own = program.name if program is not None else ""
    wants_place = _wants_location(asked)
    seen: dict[Target, Kind] = {}
    for other in group:
        for target, found in other.names.by_target.items():
            if target.family != "variable" or (target.program and other is not document):
                continue
            if not target.name.startswith(asked.prefix.lower()):
                continue
            if target.program not in ("", own) or all(o.start == asked.start for o in found):
                continue  # another program's own, or the very word that is typed
            kind = other.names.kind_of(target) or Kind.VARIABLE
            if seen.get(target) in (None, Kind.VARIABLE):
                seen[target] = kind
    for target, kind in seen.items():
        place = kind in (Kind.LOCATION, Kind.JOINTS)
        what = What.LOCATION if place else What.VARIABLE
        rank = 0 if place is wants_place else 1
        detail = kind.value + (f" of {target.program}" if target.program else "")
        yield Proposal(target.name, what, detail, "", rank)


def _wants_location(asked: Asked) -> bool:
    if asked.word is None or asked.call is not None or not asked.word.operands:
        return False
    operands = asked.word.operands
    return operands[min(asked.operand, len(operands) - 1)] == "a location"


def _labels(document: Document, asked: Asked) -> Iterator[Proposal]:
    program = document.names.program_at(asked.start)
    own = program.name if program is not None else ""
    for target in document.names.by_target:
        if target.family == "label" and target.program == own:
            yield Proposal(target.name, What.LABEL, f"label of {own}", "", 0)
