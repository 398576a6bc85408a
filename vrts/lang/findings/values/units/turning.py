"""Variables that SIN, COS or TAN take and that count up to 2*PI: the language has degrees."""

import math

from vrts.lang.findings.values.comparisons import COMPARISONS
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.units.angles import RADIANS, has_pi
from vrts.lang.findings.values.units.parts_of_pi import is_part_of_pi, number_written
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
from vrts.lang.syntax.statements import For

TURNS = frozenset({"sin", "cos", "tan"})
_MOST_TIMES = 12  # `COS(2*a)`; what is multiplied by more is converted

Turned = dict[tuple[str | None, str], str]  # the function that takes a variable of a program


def turned(types: NameUses) -> Turned:
    """Return the variables whose sine, cosine or tangent is asked for as they are."""
    found: Turned = {}
    for asked in types.asked:
        node = asked.node
        if isinstance(node, Application) and node.name.text.lower() in TURNS:
            for name in _names(node.arguments[0] if node.arguments else None):
                found.setdefault((asked.program, name), node.name.text.upper())
    return found


def check_turning(types: NameUses, asked: Asked, angles: Turned) -> bool:
    """Warn of such a variable that counts to, or is compared with, a part of PI."""
    node = asked.node
    if isinstance(node, For) and isinstance(node.target, Name):
        function = angles.get((asked.program, key(node.target.text)))
        if function is not None and _in_radians(types, asked, node.last):
            _counted(types, node, function)
            return True
    if isinstance(node, Infix) and node.operator in COMPARISONS:
        for side, other in ((node.left, node.right), (node.right, node.left)):
            function = (
                angles.get((asked.program, key(side.text))) if isinstance(side, Name) else None
            )
            if function is not None and _in_radians(types, asked, other):
                _compared(types, node, other, function)
                return True
    return False


def _names(node: Item | None) -> list[str]:
    """Return the variables in an angle, where nothing converts them."""
    match node:
        case Name(text):
            return [key(text)]
        case Parenthesised(inner) | Prefix("-" | "+", inner):
            return _names(inner)
        case Infix("+" | "-", left, right):
            return _names(left) + _names(right)
        case Infix("*", Number(value), other) | Infix("*", other, Number(value)):
            return _names(other) if abs(value) <= _MOST_TIMES else []
        case _:
            return []


def _in_radians(types: NameUses, asked: Asked, node: Item) -> bool:
    if has_pi(types, asked.program, node, follow=True):
        return True
    written = number_written(types, asked.program, node)
    return written is not None and is_part_of_pi(written)


def _counted(types: NameUses, node: For, function: str) -> None:
    problems = types.problems
    text = problems.source.text
    known = [
        evaluate(part, nothing_known)
        for part in (node.first, node.last, node.increment)
        if part is not None
    ]
    instead = ""
    if all(low == high for low, high in known):
        degrees = [_shown(low) for low, _ in known]
        instead = f"FOR {text[node.target.start : node.target.end]} = " + " TO ".join(degrees[:2])
        instead += f" STEP {degrees[2]}" if len(degrees) > 2 else ""
    problems.warning(
        RADIANS,
        f"this counts in radians, and {function} takes degrees",
        node.last.start,
        node.last.end,
        "a few degrees only",
        notes=("a right angle is 90 degrees, a full turn 360",),
        help=(f"write `{instead}`" if instead else "count in degrees, up to 360",),
        fix=problems.replace(node.start, node.end, instead, sure=False) if instead else None,
    )


def _compared(types: NameUses, node: Infix, other: Item, function: str) -> None:
    problems = types.problems
    low, high = evaluate(other, nothing_known)
    degrees = _shown(low) if low == high else ""
    side = node.left if other is node.right else node.right
    name = problems.source.text[side.start : side.end]
    problems.warning(
        RADIANS,
        f"`{name}` is compared with radians, and {function} takes degrees",
        other.start,
        other.end,
        "a few degrees only",
        notes=("a right angle is 90 degrees, a full turn 360",),
        help=(
            f"write `{degrees}`, and let `{name}` grow by degrees" if degrees else "use degrees",
        ),
        fix=problems.replace(other.start, other.end, degrees, sure=False) if degrees else None,
    )


def _shown(radians: float) -> str:
    """Return an angle in whole degrees, where it has at least two."""
    degrees = math.degrees(radians)
    return f"{round(degrees)}" if abs(degrees) >= 2.0 or not degrees else f"{degrees:.2g}"
