"""Angles that look like radians: the language has degrees."""

import math

from vrts.base.diagnostic import Rule
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.statements import Simple

RADIANS = Rule("V234", "angle-in-radians")

_ANGLES = {"sin": 0, "cos": 0, "tan": 0, "rx": 0, "ry": 0, "rz": 0, "trans": 3, "#ppoint": 0}
_TURNS = frozenset({"sin", "cos", "tan"})
_PARTS = (math.pi / 6, math.pi / 4, math.pi / 3, math.pi / 2, math.pi, 3 * math.pi / 2, 2 * math.pi)
_NEAR = 0.002  # [rad] how near to one of these a written number is
_FEW_DIGITS = 3  # with fewer behind its point, a number may be an angle in degrees by chance


def check_angles(types: NameUses, asked: Asked) -> bool:
    """Warn of angles in radians; return whether there is one."""
    node = asked.node
    if isinstance(node, Application) and node.name.text.lower() in _ANGLES:
        first, turns = _ANGLES[node.name.text.lower()], node.name.text.lower() in _TURNS
        angles = node.arguments[first:]
        where = node.name.text.upper()
    elif isinstance(node, Simple) and node.word == "DRIVE":
        angles, turns, where = node.operands[1:2], False, "DRIVE"
    else:
        return False
    found = [a for a in angles if a is not None and _radians(types, asked.program, a, turns=turns)]
    for angle in found[:1]:
        _warn(types, angle, where)
    return bool(found)


def _warn(types: NameUses, node: Item, where: str) -> None:
    problems = types.problems
    value = evaluate(node, nothing_known)
    known = value[0] == value[1]
    degrees = f"{round(math.degrees(value[0]), 2):g}" if known else ""
    problems.warning(
        RADIANS,
        f"{where} takes degrees, and this looks like radians",
        node.start,
        node.end,
        f"{value[0]:.4g} degrees" if known else "",
        notes=("a right angle is 90 degrees, a full turn 360",),
        help=(
            f"write `{degrees}`" if known else "leave PI out: a full turn is 360 degrees, not 2*PI",
        ),
        fix=problems.replace(node.start, node.end, degrees) if known else None,
    )


def _radians(types: NameUses, program: str | None, node: Item, *, turns: bool) -> bool:
    inner = node.operand if isinstance(node, Prefix) else node
    if isinstance(inner, Number):
        written = types.problems.source.text[inner.start : inner.end].partition(".")[2]
        if not turns or len(written) < _FEW_DIGITS:
            return False
        return any(abs(inner.value - part) < _NEAR for part in _PARTS)
    return _has_pi(types, program, node, follow=True)


def _has_pi(types: NameUses, program: str | None, node: Item | None, *, follow: bool) -> bool:
    """Return whether PI is a factor, not a divisor, also in a variable only ever given so."""
    match node:
        case Name(text):
            if text.lower() == "pi":
                return True
            if not follow or text[0] in "$#" or text.lower() in types.predefined:
                return False
            values = types.scope.entry(program, key(text)).values
            return len(values) == 1 and _has_pi(types, program, values[0], follow=False)
        case Parenthesised(inner) | Prefix(_, inner):
            return _has_pi(types, program, inner, follow=follow)
        case Infix("/", left, _):
            return _has_pi(types, program, left, follow=follow)
        case Infix("*" | "+" | "-", left, right):
            return _has_pi(types, program, left, follow=follow) or _has_pi(
                types, program, right, follow=follow
            )
        case _:
            return False
