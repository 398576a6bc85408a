"""Numbers where strings belong: names without `$`, mixed sums and comparisons."""

from collections.abc import Collection
from itertools import pairwise
from typing import NamedTuple

from vrts.base.diagnostic import Fix
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.instead.logic_words import compared_with_word
from vrts.lang.meaning.name_uses import NameUses, NoText
from vrts.lang.meaning.roles import COMPARISONS, Role, role_of
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import IN_WORDS, NOT_COUNTED, NUMBER, TYPES_SAY, WRONG_TYPE
from vrts.lang.names import as_string, key
from vrts.lang.syntax.expressions import (
    Application,
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Text,
)
from vrts.lang.syntax.statements import Assignment, Simple

_SPEEDS_OF_KRL = ("$vel", "$ov_", "$acc")


class _Help(NamedTuple):
    help: tuple[str, ...]
    fix: Fix | None = None


def report_no_texts(types: NameUses, strings: Collection[str] = ()) -> None:
    """Report numbers and locations where strings belong, one of each step.

    Args:
        types: What was noted.
        strings: Names of which it was said that they are meant as strings.
    """
    said: set[int] = set()
    for found in types.no_texts:
        line = types.problems.source.line_of(found.node.start)
        meant = found.name is not None and key(found.name.text) in strings
        if line in said or meant:
            continue
        said.add(line)
        _report(types, found)


def _report(types: NameUses, found: NoText) -> None:
    problems = types.problems
    node, name = found.node, found.name
    kind = Type.REAL
    if name is not None:
        entry = types.scope.entry(found.program, key(name.text))
        kind = Type.POSE if entry.type is Type.POSE else Type.REAL
    why = found.why
    mixed = f"{why}, not one of each" if why.endswith("two numbers") else ""
    told = _help(types, found, kind)
    problems.error(
        WRONG_TYPE,
        mixed or f"{why}, not {IN_WORDS[kind]}",
        node.start,
        node.end,
        f"this is {IN_WORDS[kind]}",
        notes=(TYPES_SAY,),
        help=told.help,
        fix=told.fix,
    )


def _help(types: NameUses, found: NoText, kind: Type) -> _Help:
    problems = types.problems
    node, name = found.node, found.name
    text = problems.source.text
    written = text[node.start : node.end]
    entry = types.scope.entry(found.program, key(name.text)) if name is not None else None
    if name is not None and entry is not None and _means_string(types, found, entry):
        fix = problems.replace(name.start, name.start, "$")
        return _Help((f"did you mean `${name.text}`? The name of a string begins with `$`",), fix)
    if kind is Type.POSE:
        shown = f"DX({written}), DY({written}), DZ({written})"
        return _Help((f"write its coordinates, behind commas: `{shown}`",))
    valued = name is None or entry is None or _has_value(types, name, entry)
    if not valued and found.item is not None:
        return _Help(("put text between double quotes; the name of a string begins with `$`",))
    if found.item is not None:
        items = _apart(text, found.item)
        if not items:
            return _Help(("separate them by commas",))
        fix = problems.replace(found.item.start, found.item.end, items)
        return _Help((f"write a comma between them: `TYPE {items}`",), fix)
    role = role_of(types.scope.programs.values(), (node.start, node.end))
    told = _by_role(types, found, role, entry) if role is not None else None
    if told is not None:
        return told
    if not valued:
        return _Help(("put text between double quotes; the name of a string begins with `$`",))
    encoded = f"$ENCODE({written})"
    fix = problems.replace(node.start, node.end, encoded)
    return _Help((f"$ENCODE turns a number into a string: `{encoded}`",), fix)


def _by_role(types: NameUses, found: NoText, role: Role, entry: Entry | None) -> _Help | None:
    """Return what helps by what the number stands in."""
    around, problems = role.around, types.problems
    text = problems.source.text
    written = text[found.node.start : found.node.end]
    if isinstance(around, Infix) and around.operator in COMPARISONS:
        return _compared(types, found, role, entry)
    if isinstance(around, Assignment):
        target = text[around.target.start : around.target.end]
        plain = f"`{target[1:]} = {written}`"
        if target.lower().startswith(_SPEEDS_OF_KRL):
            return _Help(("a speed is set by SPEED: `SPEED 50`, or `SPEED 100 MMPS` in mm/s",))
        if isinstance(found.node, Number):
            return _Help(
                (
                    f"leave the `$` out if this is a number: {plain}",
                    f'put it between quotes if it is a text: `{target} = "{written}"`',
                )
            )
        encoded = f"$ENCODE({written})"
        if (
            isinstance(found.node, Name)
            and entry is not None
            and not _has_value(types, found.node, entry)
        ):
            return _Help(
                (
                    f'text stands between double quotes: write `{target} = "{written}"`',
                    f"the name of a string begins with `$`: `{target} = {as_string(written)}`",
                )
            )
        return _Help(
            (
                f"$ENCODE turns a number into a string: `{target} = {encoded}`",
                f"leave the `$` out if it is to stay a number: {plain}",
            ),
            problems.replace(found.node.start, found.node.end, encoded),
        )
    if isinstance(around, Application) and around.name.text.upper() == "LEN" and entry is not None:
        return _Help((NOT_COUNTED,)) if entry.array is not None else None
    if isinstance(around, Application) and around.name.text.upper() == "ASC":
        step = role.step
        target = text[step.target.start : step.target.end] if isinstance(step, Assignment) else ""
        if not target.startswith("$"):
            return None
        fix = problems.replace(around.name.start, around.name.end, "$CHR")
        return _Help((f"$CHR makes a character of its code: write `$CHR({written})`",), fix)
    if isinstance(around, Application) and around.name.text.upper() == "VAL":
        fix = problems.replace(around.start, around.end, written)
        return _Help((f"this is a number already: leave VAL out, and write `{written}`",), fix)
    if isinstance(around, Simple) and around.word in ("PAUSE", "STOP", "HALT"):
        fix = None
        help_ = f"write {around.word} alone, or with a text"
        if around.word == "PAUSE":
            help_ = f"PAUSE stops until the operator goes on; to wait write `DELAY {written}`"
            fix = problems.replace(around.start, found.node.start, "DELAY ")
        return _Help((help_,), fix)
    return None


def _compared(types: NameUses, found: NoText, role: Role, entry: Entry | None) -> _Help | None:
    """A number beside a string: `$tray == 2`, `tray == "2"`, `answer == "yes"`."""
    problems = types.problems
    text = problems.source.text
    around: Infix = role.around
    other, written = role.other, text[found.node.start : found.node.end]
    while isinstance(other, Parenthesised):
        other = other.inner
    assert other is not None
    against = text[other.start : other.end]

    def changed(node: Expression, instead: str) -> str:
        return text[around.start : node.start] + instead + text[node.end : around.end]

    if found.name is not None and entry is not None and not _has_value(types, found.name, entry):
        quoted = changed(found.node, f'"{written}"')
        if not isinstance(other, Text):
            fix = problems.replace(found.node.start, found.node.end, f'"{written}"')
            return _Help((f"a text stands between double quotes: write `{quoted}`",), fix)
    if isinstance(other, Text):
        values = entry.values if entry is not None else ()
        asked = compared_with_word(problems, around, found.node, other, values)
        if asked is not None:
            return _Help(*asked)
        number = other.value.strip()
        if NUMBER.fullmatch(number):
            return _Help(
                (f"compare with a number, without quotes: `{changed(other, number)}`",),
                problems.replace(other.start, other.end, number),
            )
        if found.name is None or entry is None:
            return _Help((f"a number never equals a text: compare `{written}` with a number",))
        return _is_string(types, found.name, entry)
    value = f"VAL({against})"
    helps = [f"compare the number in the text: `{changed(other, value)}`"]
    if isinstance(found.node, Number) and around.operator in ("==", "<>"):
        quoted = f'"{written}"'
        helps.append(f"or compare with a text: `{changed(found.node, quoted)}`")
    return _Help(tuple(helps), problems.replace(other.start, other.end, value))


def _is_string(types: NameUses, name: Name, entry: Entry) -> _Help:
    """A name without `$` beside a text: `answer == "yes"`, all its places if nothing counts it."""
    problems = types.problems
    help_ = f"the name of a string begins with `$`: write `{as_string(name.text)}`"
    places = sorted({at for at, _ in (*entry.reads, *entry.writes)})
    if (entry.values and not entry.changed) or entry.passed or entry.slot is not None:
        return _Help((f"{help_}; `{name.text}` holds a number",))
    if len(places) > 1:
        help_ += ", and so wherever it stands"
    edits = [edit for at in places for edit in problems.replace(at, at, "$").edits]
    return _Help((help_,), Fix.from_edits(edits))


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
