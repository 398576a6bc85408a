"""Numbers where strings belong: names without `$`, and mixed sums."""

from itertools import pairwise

from vrts.base.diagnostic import Fix
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.name_uses import NameUses, NoText
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import IN_WORDS, TYPES_SAY, WRONG_TYPE
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Expression, Infix, Item, Name, Parenthesised


def report_no_texts(types: NameUses) -> None:
    """Report numbers and locations where strings belong, each item of TYPE once."""
    said: set[int] = set()
    for found in types.no_texts:
        if found.item is not None and found.item.start in said:
            continue
        if found.item is not None:
            said.add(found.item.start)
        _report(types, found)


def _report(types: NameUses, found: NoText) -> None:
    problems = types.problems
    node, name = found.node, found.name
    kind = Type.REAL
    entry = None
    if name is not None:
        entry = types.scope.entry(found.program, key(name.text))
        kind = Type.POSE if entry.type is Type.POSE else Type.REAL
    text = problems.source.text
    fix: Fix | None = None
    string = f"${name.text}" if name is not None else ""
    if name is not None and entry is not None and _means_string(types, found, entry):
        help_ = f"did you mean `{string}`? The name of a string begins with `$`"
        fix = problems.replace(name.start, name.start, "$")
    elif kind is Type.POSE:
        help_ = "DX(l), DY(l) and DZ(l) are the coordinates of a location"
    elif name is not None and entry is not None and not _has_value(types, name, entry):
        help_ = "put text between double quotes; the name of a string begins with `$`"
    elif found.item is not None:
        items = _apart(text, found.item)
        help_ = (
            f"write a comma between them: `TYPE {items}`" if items else "separate them by commas"
        )
        fix = problems.replace(found.item.start, found.item.end, items) if items else None
    else:
        help_ = f"$ENCODE turns a number into a string: `$ENCODE({text[node.start : node.end]})`"
    problems.error(
        WRONG_TYPE,
        f"{found.why}, not {IN_WORDS[kind]}",
        node.start,
        node.end,
        f"this is {IN_WORDS[kind]}",
        notes=(TYPES_SAY,),
        help=(help_,),
        fix=fix,
    )


def _has_value(types: NameUses, name: Name, entry: Entry) -> bool:
    """Return whether a name is given a value, or may be, in a line that could not be read."""
    given = bool(entry.writes or entry.passed) or entry.slot is not None
    return given or key(name.text) in types.bad_names


def _means_string(types: NameUses, found: NoText, entry: Entry) -> bool:
    """Return whether a string has the name, and nothing else has it."""
    if entry.writes or entry.slot is not None:
        return False
    own = types.scope.formals.get(found.program or "", {})
    other = own.get(f"${entry.name}") or types.scope.entries.get(f"${entry.name}")
    return other is not None and bool(other.writes or other.slot is not None)


def _apart(text: str, item: Item) -> str:
    """Return a mixed sum as items of TYPE; empty where two numbers stand side by side."""
    operands: list[Expression] = []
    node: Item = item
    while isinstance(node, Parenthesised):
        node = node.inner
    while isinstance(node, Infix) and node.operator == "+":
        operands.append(node.right)
        node = node.left
    if not operands or not isinstance(node, Expression):
        return ""
    operands.append(node)
    operands.reverse()
    shown = text[operands[0].start : operands[0].end]
    for before, operand in pairwise(operands):
        texts = is_text(before), is_text(operand)
        if not any(texts):
            return ""
        shown += "+" if all(texts) else ", "
        shown += text[operand.start : operand.end]
    return shown
