"""What is known of the word under the cursor."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.ir.values import Value
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS
from vrts.lsp.answers.symbols import header_of
from vrts.lsp.documents.asking import instruction_at
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import VARIABLES, Occurrence, ProgramNames
from vrts.lsp.documents.uses import Kind, Role
from vrts.lsp.documents.words import function_help, function_usage, instruction_help
from vrts.monitor.listings import COMPONENTS, location_row

MOST_VALUES = 8  # elements of an array that are shown
MOST_COMMENTS = 8  # lines
_FIRST_INPUT, _FIRST_INTERNAL = 1001, 2001
_FAMILIES = {
    Kind.LOCATION: "location",
    Kind.JOINTS: "precision point",
    Kind.STRING: "string",
    Kind.VARIABLE: "variable",
}


class Hover(NamedTuple):
    """Help for a range of the text."""

    start: int
    end: int
    code: str  # how it is written or what it holds, in columns
    about: str
    place: Pose | None = None  # a pose whose reach may be told


def hover(document: Document, offset: int, group: Sequence[Document]) -> Hover | None:
    """Return help for what stands at an offset; None where there is nothing to say."""
    occurrence = document.names.at(offset)
    if occurrence is not None:
        return _named(occurrence, document, group)
    found = instruction_at(document, offset)
    if found is not None:
        word, start, end = found
        return Hover(start, end, word.usage or word.text, instruction_help(word))
    return _qualifier(document, offset)


def definitions(
    occurrence: Occurrence, group: Sequence[Document]
) -> list[tuple[Document, Occurrence]]:
    """Return where a name gets its value or its place: in its own file if anywhere there."""
    for document in group[:1] if occurrence.target.program else group:
        found = document.names.by_target.get(occurrence.target, [])
        written = [(document, o) for o in found if o.role is Role.WRITE]
        if written:
            return written
    return []


def _named(o: Occurrence, document: Document, group: Sequence[Document]) -> Hover | None:
    written = document.source.text[o.start : o.end]
    if o.kind is Kind.FUNCTION:
        function = FUNCTIONS.get(o.target.name)
        if function is None:
            return None
        return Hover(o.start, o.end, function_usage(function), function_help(function))
    if o.kind is Kind.CONSTANT:
        value = CONSTANTS[o.target.name]
        return Hover(o.start, o.end, f"{written.upper()} = {value:g}", "a constant")
    if o.kind is Kind.SIGNAL:
        count = sum(len(d.names.by_target.get(o.target, ())) for d in group)
        return Hover(o.start, o.end, f"signal {o.target.name}", f"{_signal(o)}; {_times(count)}")
    places = definitions(o, group)
    if o.kind is Kind.LABEL:
        line = places[0][0].source.line_of(places[0][1].start) if places else 0
        where = f"in line {line}" if line else "not in this program"
        return Hover(o.start, o.end, f"label {o.target.name}", where)
    if o.kind is Kind.PROGRAM:
        return _program(o, places, group)
    return _variable(o, places, group) if o.kind in VARIABLES else None


def _program(
    o: Occurrence, places: list[tuple[Document, Occurrence]], group: Sequence[Document]
) -> Hover:
    calls = sum(use.role is Role.READ for d in group for use in d.names.by_target.get(o.target, ()))
    for document, _ in places:
        program = next((p for p in document.names.programs if p.name == o.target.name), None)
        if program is not None:
            rows = [*_comments(document, program), f"in `{document.source.name}`; {_times(calls)}"]
            return Hover(o.start, o.end, f".PROGRAM {header_of(program)}", "\n\n".join(rows))
    return Hover(o.start, o.end, f".PROGRAM {o.target.name}", "not in this folder")


def _variable(
    o: Occurrence, places: list[tuple[Document, Occurrence]], group: Sequence[Document]
) -> Hover:
    kinds = (d.names.kind_of(o.target) for d in group)
    found = [kind for kind in kinds if kind is not None]
    kind = next((k for k in found if k is not Kind.VARIABLE), o.kind)
    values = _values(o.target.name, group) if not o.target.program else []
    poses = [value for _, value in values if isinstance(value, Pose)]
    rows = [_FAMILIES[kind]]
    if o.target.program:
        rows.append(f"its own in `{o.target.program}`")
    elif places and not values:
        document, first = places[0]
        line = document.source.line_of(first.start)
        text = " ".join(document.source.line_text(line).split())
        rows.append(f"`{text[:80]}` in line {line} of `{document.source.name}`")
    elif not places:
        rows.append("never given a value")
    return Hover(
        o.start,
        o.end,
        _shown(values) or o.target.name,
        "; ".join(rows),
        poses[0] if len(poses) == 1 else None,
    )


def _values(name: str, group: Sequence[Document]) -> list[tuple[str, Value]]:
    for document in group:
        found = [
            (_element(name, subscripts), datum.value)
            for (datum_name, subscripts), datum in document.data.items()
            if datum_name == name
        ]
        if found:
            return sorted(found, key=lambda item: item[0])
    return []


def _shown(values: list[tuple[str, Value]]) -> str:
    rows: list[str] = []
    for name, value in values[:MOST_VALUES]:
        if isinstance(value, tuple):
            if not rows:
                rows.append(" " * 12 + "".join(f"{c:>10}" for c in COMPONENTS.split()))
            rows.append(f"{name:<12}{location_row(value)}")
        elif isinstance(value, str):
            rows.append(f'{name} = "{value}"')
        else:
            rows.append(f"{name} = {value:g}")
    if len(values) > MOST_VALUES:
        rows.append(f"... {len(values) - MOST_VALUES} more")
    return "\n".join(rows)


def _element(name: str, subscripts: tuple[int, ...]) -> str:
    return f"{name}[{','.join(map(str, subscripts))}]" if subscripts else name


def _comments(document: Document, program: ProgramNames) -> list[str]:
    """Return what is written below the header of a program, or above it."""
    source = document.source
    number = source.line_of(program.start)
    below = [source.line_text(n) for n in range(number + 1, len(source.line_starts) + 1)]
    rows: list[str] = []
    for line in below[:MOST_COMMENTS]:
        if not line.lstrip().startswith(";"):
            break
        rows.append(line.strip(" ;\t"))
    return [" ".join(rows)] if rows else []


def _qualifier(document: Document, offset: int) -> Hover | None:
    text = document.source.text
    start = end = offset
    while start > 0 and text[start - 1].isalpha():
        start -= 1
    while end < len(text) and text[end].isalpha():
        end += 1
    upper = text[start:end].upper()
    word = QUALIFIERS.get(upper) or OPERATORS.get(upper)
    return None if word is None else Hover(start, end, word.usage or word.text, word.about)


def _signal(o: Occurrence) -> str:
    number = int(float(o.target.name))
    if number < _FIRST_INPUT:
        return "an output"
    return "an input" if number < _FIRST_INTERNAL else "an internal signal"


def _times(count: int) -> str:
    return f"used {count} {'time' if count == 1 else 'times'}" if count else "never used"
