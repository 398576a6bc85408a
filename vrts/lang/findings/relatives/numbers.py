"""`JDEPART part`, `LAPPRO part, tray`: a location where a step of AS takes a number.

In AS a location and a number may share their name, so that the use alone is no clash.
"""

from vrts.ir.values import Type
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Item, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

_DISTANCE = 1  # of the operands of LAPPRO and JAPPRO


def check_draw(
    resolver: Resolver, program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `DRAW shelf`: DRAW takes ways in mm, and goes to no location."""
    first = node.operands[0]
    if len(node.operands) != 1 or not _is_place(resolver, program, first):
        return False
    assert isinstance(first, Name)
    problems = resolver.problems
    problems.error(
        WRONG_TYPE,
        f"{node.word} takes the ways along X, Y and Z, and `{first.text}` is a location",
        first.start,
        first.end,
        help=(
            f"to go to it write `LMOVE {first.text}`",
            f"to go some way from here write numbers of mm, as in `{node.word} 0, 0, 50`",
        ),
        fix=problems.replace(node.start, first.start, "LMOVE "),
    )
    return True


def check_distance(
    resolver: Resolver, program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report a location in the place of a distance."""
    at = _DISTANCE if node.word.startswith("APPRO") else 0
    operand = node.operands[at] if len(node.operands) > at else None
    if not isinstance(operand, Name) or not _is_place(resolver, program, operand):
        return False
    problems = resolver.problems
    text = problems.source.text
    word = text[node.start :].split(None, 1)[0].upper()
    first = text[node.start : operand.start].strip()
    instead = f"{first} 50" if at else f"{word} 50"
    problems.error(
        WRONG_TYPE,
        f"{word} takes a distance here, and `{operand.text}` is a location",
        operand.start,
        operand.end,
        help=(f"write a number of mm, as in `{instead}`",),
    )
    return True


def _is_place(resolver: Resolver, program: ProgramText, operand: Item | None) -> bool:
    """Whether something is a name that stands for a location, and for no number."""
    if not isinstance(operand, Name) or operand.text[0] == "$":
        return False
    entry = resolver.scope.entry(program.name, key(operand.text))
    if not entry.types.keys() & {Type.POSE, Type.JOINTS} or Type.REAL in entry.given:
        return False
    known = entry.slot is not None or bool(entry.passed)
    return not known and key(operand.text) not in resolver.bad_names
