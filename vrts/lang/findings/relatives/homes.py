"""`HOME 3`, `SETHOME #rest, 10`: AS has two homes, and says how near before it says where."""

from vrts.lang.findings.values.complaints import OPERAND_RANGE
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.syntax.expressions import Name, Number
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

_HOMES = (1.0, 2.0)


def check_home(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report a home that is neither the first nor the second [AS manual, 6.1 HOME]."""
    home = node.operands[0]
    if not isinstance(home, Number) or home.value in _HOMES:
        return False
    problems = resolver.problems
    problems.error(
        OPERAND_RANGE,
        f"there is no HOME {home.value:g}: AS has two homes",
        home.start,
        home.end,
        help=("write `HOME` or `HOME 1`, which SETHOME sets, or `HOME 2`, which SET2HOME sets",),
    )
    return True


def check_home_place(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `SETHOME #rest, 10` and `SETHOME #rest` [AS manual, 6.9 SETHOME]."""
    first = node.operands[0]
    second = node.operands[1] if len(node.operands) > 1 else None
    located = isinstance(first, Name) and (first.text[0] == "#" or first.text.upper() == "HERE")
    if first is None or not located:
        return False
    problems = resolver.problems
    text = problems.source.text
    place = text[first.start : first.end]
    near = text[second.start : second.end] if second is not None else "10"
    end = second.end if second is not None else first.end
    problems.error(
        WRONG_TYPE,
        f"the accuracy in mm comes first in {node.word}, then the location",
        first.start,
        end,
        help=(f"write `{node.word} {near}, {place}`",),
        fix=problems.replace(first.start, end, f"{near}, {place}", sure=second is not None),
    )
    return True
