"""INRANGE taken for a truth: it yields 0 where a location can be reached."""

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.syntax.expressions import (
    Application,
    Expression,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.statements import If, Simple, Structure

IN_RANGE = Rule("V268", "in-range-is-zero")

_GOING = frozenset({"MOVE", "MOVES", "MOVET", "MOVEST", "APPRO", "APPROS"})
_OPENERS = ("If", "While", "For", "Case")
_TRUTHS = frozenset({"true", "on"})


def check_in_range(types: NameUses, asked: Asked) -> bool:
    """Warn of `IF INRANGE(far) THEN`, `MOVE far`, and of `INRANGE(far) == TRUE`."""
    node = asked.node
    if isinstance(node, Infix) and node.operator in ("==", "<>"):
        call = _call(node.left)
        one = isinstance(node.right, Number) and node.right.value == 1.0
        sure = call is not None and _is_true(node.right)
        if call is None or not (sure or (one and _goes(types, asked, call))):
            return False
        _told(types, call, node, f"{_written(types, call)} {node.operator} 0")
        return True
    call = _call(node.condition) if isinstance(node, If) else None
    if call is None or not isinstance(node, If) or not _goes(types, asked, call):
        return False
    _told(types, call, node.condition, f"{_written(types, call)} == 0")
    return True


def _goes(types: NameUses, asked: Asked, call: Application) -> bool:
    """Whether the steps behind THEN go to the location, before ELSE or END."""
    text = types.problems.source.text
    first = call.arguments[0] if call.arguments else None
    if first is None or asked.program is None:
        return False
    goal = text[first.start : first.end].lower()
    depth = 0
    inside = False
    for step in types.scope.programs[asked.program].steps:
        node = step.statement
        if node is None:
            continue
        if not inside:
            inside = node.start == asked.step
            continue
        if isinstance(node, Structure) and node.word in ("ELSE", "END") and not depth:
            return False
        depth += type(node).__name__ in _OPENERS
        depth -= isinstance(node, Structure) and node.word == "END"
        if isinstance(node, Simple) and node.word in _GOING and node.operands:
            to = node.operands[0]
            if to is not None and text[to.start : to.end].lower() == goal:
                return True
    return False


def _call(node: Expression) -> Application | None:
    while isinstance(node, Parenthesised):
        node = node.inner
    is_call = isinstance(node, Application) and node.name.text.lower() == "inrange"
    return node if is_call and isinstance(node, Application) else None


def _is_true(node: Expression) -> bool:
    if isinstance(node, Name):
        return node.text.lower() in _TRUTHS
    within = node.operand if isinstance(node, Prefix) else None
    return isinstance(within, Number) and within.value == 1.0


def _written(types: NameUses, node: Application) -> str:
    return types.problems.source.text[node.start : node.end]


def _told(types: NameUses, call: Application, node: Expression, instead: str) -> None:
    types.problems.warning(
        IN_RANGE,
        "INRANGE yields 0 where the location can be reached: this is the wrong way round",
        call.start,
        call.end,
        notes=("another number tells which joints cannot get there, and counts as true",),
        help=(f"write `{instead}`",),
        fix=types.problems.replace(node.start, node.end, instead),
    )
