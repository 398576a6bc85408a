"""Names without `$` that are given a string: `name = "Ada"`, `total = $a + 10`."""

from vrts.base.diagnostic import Fix
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.name_uses import NameUses, TextGiven
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import NUMBER, TYPES_SAY, WRONG_TYPE
from vrts.lang.names import as_string, key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Element, Expression, Infix, Name, Parenthesised, Text

MOST_PLACES = 50  # of a name that are mended together


def report_given_texts(types: NameUses) -> set[str]:
    """Report names without `$` that are given strings, each once; return those meant as strings."""
    strings: set[str] = set()
    for given in types.texts_given:
        entry = types.scope.entry(given.program, key(given.name.text))
        if entry.name in strings:
            continue
        if _is_number_as_text(types, given, entry):
            _as_number(types, given)
        else:
            _as_string(types, given, entry)
            strings.add(entry.name)
    return strings


def _is_number_as_text(types: NameUses, given: TextGiven, entry: Entry) -> bool:
    """Return whether what is given is the text of a number, and a number is meant."""
    operands = _operands(given.value)
    if any(isinstance(o, Text) and not NUMBER.fullmatch(o.value.strip()) for o in operands):
        return False
    return len(operands) > 1 or Type.REAL in entry.given or _counts(types, entry)


def _counts(types: NameUses, entry: Entry) -> bool:
    """Return whether a name is used as a number anywhere but in TYPE."""
    place = entry.types.get(Type.REAL)
    if place is None:
        return False
    line = types.problems.source.line_text(types.problems.source.line_of(place[0]))
    return not line.split(";")[0].strip().upper().startswith("TYPE")


def _operands(value: Expression) -> list[Expression]:
    """Return what a sum adds up, in its order."""
    operands: list[Expression] = []
    node = value
    while isinstance(node, Infix) and node.operator == "+":
        operands.append(node.right)
        node = node.left
    operands.append(node)
    return [_plain(operand) for operand in reversed(operands)]


def _plain(node: Expression) -> Expression:
    while isinstance(node, Parenthesised):
        node = node.inner
    return node


def _as_number(types: NameUses, given: TextGiven) -> None:
    problems = types.problems
    text = problems.source.text
    written = text[given.value.start : given.value.end]
    for operand in reversed(_operands(given.value)):
        start, end = (operand.start - given.value.start, operand.end - given.value.start)
        part = written[start:end]
        if isinstance(operand, Text):
            part = operand.value.strip()
        elif is_text(operand):
            part = f"VAL({part})"
        written = written[:start] + part + written[end:]
    target = text[given.target.start : given.target.end]
    quoted = isinstance(_plain(given.value), Text)
    why = "a number stands without quotes" if quoted else "VAL turns the text of a number into one"
    _tell(
        problems,
        given,
        (f"{why}: `{target} = {written}`",),
        problems.replace(given.value.start, given.value.end, written),
    )


def _as_string(types: NameUses, given: TextGiven, entry: Entry) -> None:
    problems = types.problems
    name = given.name.text
    value = problems.source.text[given.value.start : given.value.end]
    target = problems.source.text[given.target.start : given.target.end]
    alone = _plain(given.value)
    meant = f"{as_string(target)} = {_joined(types, given)}"
    helps = [f"the name of a string begins with `$`: write `{meant}`"]
    if isinstance(alone, Text) and NUMBER.fullmatch(alone.value.strip()):
        helps.append(f"for a number leave the quotes out: `{target} = {alone.value.strip()}`")
    elif isinstance(alone, Name | Element):
        helps.append(f"for the number that the text begins with write `{target} = VAL({value})`")
    elif Type.REAL in entry.given:
        helps.append(f"`{name}` holds numbers elsewhere, so give the text a name of its own")
    fix = None
    places = sorted({at for at, _ in (*entry.reads, *entry.writes)})
    inside = any(given.value.start <= at < given.value.end for at in places)
    own = not entry.passed and entry.slot is None and not inside
    if len(helps) == 1 and own and len(places) <= MOST_PLACES:
        edits = [edit for at in places for edit in problems.replace(at, at, "$").edits]
        if _joined(types, given) != value:
            joined = problems.replace(given.value.start, given.value.end, _joined(types, given))
            edits = sorted((*edits, *joined.edits), key=lambda edit: edit.span.start)
        fix = Fix.from_edits(edits)
        if len(places) > 1:
            helps[0] += ", and so wherever it stands"
    _tell(problems, given, tuple(helps), fix)


def _joined(types: NameUses, given: TextGiven) -> str:
    """Return a sum with its numbers as strings."""
    text = types.problems.source.text
    operands = _operands(given.value)
    if all(is_text(operand) for operand in operands):
        return text[given.value.start : given.value.end]
    shown = (text[o.start : o.end] for o in operands)
    return "+".join(
        part if is_text(o) else f"$ENCODE({part})" for o, part in zip(operands, shown, strict=True)
    )


def _tell(problems: Problems, given: TextGiven, help_: tuple[str, ...], fix: Fix | None) -> None:
    problems.error(
        WRONG_TYPE,
        f"`{given.name.text}` holds a number, not a string",
        given.value.start,
        given.value.end,
        "this is a string",
        secondary=(problems.label(given.name.start, given.name.end, "no `$`, so a number"),),
        notes=(TYPES_SAY,),
        help=help_,
        fix=fix,
    )
