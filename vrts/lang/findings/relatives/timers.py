"""`UTIMER cure = 0`: the name of a timer of the user begins with `@`."""

from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.syntax.expressions import Element, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple


def check_user_timer(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report a timer without its sign [AS manual, 6.9 UTIMER]."""
    timer = node.operands[0]
    name = timer.name if isinstance(timer, Element) else timer
    if not isinstance(name, Name) or not name.text[:1].isalpha():
        return False
    problems = resolver.problems
    if problems.source.text[name.start] == "@":
        return False
    problems.error(
        WRONG_TYPE,
        "the name of a timer of UTIMER begins with `@`",
        name.start,
        name.end,
        help=(f"write `@{name.text}`",),
        fix=problems.replace(name.start, name.start, "@"),
    )
    return True
