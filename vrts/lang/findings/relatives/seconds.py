"""`TWAIT SIG(1008)`, `WAIT.EVENT 0.5`: a condition, or another number, where seconds belong."""

from vrts.ir.ranges import INPUTS, INTERNAL
from vrts.lang.findings.values.comparisons import COMPARISONS, bare
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.syntax.expressions import Application, FormatItem, Infix, Item, Number, Prefix
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

_LOGICAL = frozenset({"AND", "OR", "XOR"})
_TRUTHS = frozenset({"sig", "switch", "defined", "identical", "outside"})


def check_seconds(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report a condition, or the number of a signal, where a step takes seconds."""
    operand = node.operands[0]
    if operand is None:
        return False
    problems = resolver.problems
    text = problems.source.text
    written = text[operand.start : operand.end]
    word = text[node.start : operand.start].strip().upper().rstrip("(")
    if is_condition(operand):
        instead = f"WAIT {written}"
        headline = f"{word} waits for seconds, and this is a condition"
    elif isinstance(operand, Number) and (operand.value in INPUTS or operand.value in INTERNAL):
        swait = f"SWAIT {written}" if resolver.dialect.is_as else f"WAIT SIG({written})"
        headline = f"{word} waits for seconds, and {written} looks like a signal"
        instead = swait
    else:
        return False
    problems.warning(
        WRONG_TYPE,
        headline,
        operand.start,
        operand.end,
        help=(f"to wait until it holds write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead),
    )
    return True


def check_event(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `WAIT.EVENT 0.5`: the seconds stand behind the comma."""
    operand = node.operands[0]
    if len(node.operands) != 1 or not isinstance(operand, Number):
        return False
    if operand.value == round(operand.value):
        return False
    problems = resolver.problems
    written = problems.source.text[operand.start : operand.end]
    instead = f"WAIT.EVENT , {written}"
    problems.warning(
        WRONG_TYPE,
        "the seconds of WAIT.EVENT stand behind its comma: before it stands which event",
        operand.start,
        operand.end,
        help=(f"write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead),
    )
    return True


def is_condition(node: Item) -> bool:
    """Return whether an expression is true or false, and no amount."""
    if isinstance(node, FormatItem):
        return False
    inner = bare(node)
    if isinstance(inner, Infix):
        return inner.operator in COMPARISONS or inner.operator in _LOGICAL
    if isinstance(inner, Prefix):
        return inner.operator == "NOT"
    return isinstance(inner, Application) and inner.name.text.lower() in _TRUTHS
