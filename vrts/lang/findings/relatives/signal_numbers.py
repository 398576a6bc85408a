"""`DLYSIG 0.5, 3`, `ONI SIG(1001) CALL stop`: the number of a signal is a whole number."""

from vrts.lang.findings.relatives.seconds import is_condition
from vrts.lang.findings.values.comparisons import bare
from vrts.lang.findings.values.complaints import NO_SUCH_SIGNAL
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.syntax.expressions import Application, FormatItem, Infix, Item, Number, Prefix
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

_LISTS = frozenset({"SIGNAL", "SWAIT"})
_SECONDS = 1  # of the operands of PULSE and DLYSIG
_JOINING = frozenset({"AND", "OR"})


def check_signal(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report SIG, and a number that is no whole one, in the place of a number of a signal."""
    many = node.operands if node.word in _LISTS else node.operands[:1]
    if len(many) > 1 and _several(resolver, node):
        return True
    return any(_no_number(resolver, node, operand) for operand in many)


def _several(resolver: Resolver, node: Simple | Device | ReactStatement) -> bool:
    """Report `SWAIT SIG(1001), SIG(1002)` in one go."""
    problems = resolver.problems
    text = problems.source.text
    given = [operand for operand in node.operands if operand is not None]
    asked = [_numbers_asked(text, operand) for operand in given]
    if len([numbers for numbers in asked if numbers]) < len(("one", "and another")):
        return False
    written = ", ".join(
        ", ".join(numbers) or text[operand.start : operand.end]
        for operand, numbers in zip(given, asked, strict=True)
    )
    problems.error(
        NO_SUCH_SIGNAL,
        f"{node.word} takes the numbers of signals, and SIG tells whether they are on",
        given[0].start,
        given[-1].end,
        help=(f"write the numbers alone: `{node.word} {written}`",),
        fix=problems.replace(given[0].start, given[-1].end, written),
    )
    return True


def check_stop_signal(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `XMOVE part TILL SIG(1001)`."""
    return len(node.operands) > 1 and _no_number(resolver, node, node.operands[1])


def check_timed_signal(
    resolver: Resolver, _program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `DLYSIG 0.5, 3`, with the seconds before the signal."""
    first = node.operands[0]
    if not isinstance(first, Number) or first.value == round(first.value):
        return _no_number(resolver, node, first)
    problems = resolver.problems
    text = problems.source.text
    word = node.word
    second = node.operands[_SECONDS] if len(node.operands) > _SECONDS else None
    if second is None:
        return _no_number(resolver, node, first)
    written = f"{text[second.start : second.end]}, {text[first.start : first.end]}"
    problems.error(
        WRONG_TYPE,
        f"the number of the signal comes first in {word}, then the seconds",
        first.start,
        second.end,
        help=(f"write `{word} {written}`",),
        fix=problems.replace(first.start, second.end, written),
    )
    return True


def _no_number(
    resolver: Resolver, node: Simple | Device | ReactStatement, operand: Item | None
) -> bool:
    if operand is None or isinstance(operand, FormatItem):
        return False
    problems = resolver.problems
    text = problems.source.text
    inner = bare(operand)
    word = node.word
    numbers = _numbers_asked(text, inner)
    if numbers:
        if word in ("SIGNAL", "PULSE") and len(numbers) == 1 and isinstance(inner, Application):
            return False  # told with the values
        written = ", ".join(numbers)
        problems.error(
            NO_SUCH_SIGNAL,
            f"{word} takes the numbers of signals, and SIG tells whether they are on",
            operand.start,
            operand.end,
            help=(f"write the number alone: `{written}`",),
            fix=problems.replace(operand.start, operand.end, written),
        )
        return True
    if isinstance(inner, Number) and inner.value != round(inner.value):
        problems.error(
            NO_SUCH_SIGNAL,
            f"a signal has a whole number, and {inner.value:g} is none",
            operand.start,
            operand.end,
            help=("write the number of a signal, as in `3`, or `-3` to switch it off",),
        )
        return True
    if word == "SWAIT" and is_condition(operand):
        written = text[operand.start : operand.end]
        problems.error(
            NO_SUCH_SIGNAL,
            "SWAIT waits for signals by their numbers, and WAIT for a condition",
            operand.start,
            operand.end,
            help=(f"write `WAIT {written}`",),
            fix=problems.replace(node.start, node.start + len(word), "WAIT"),
        )
        return True
    return False


def _numbers_asked(text: str, node: object) -> list[str]:
    """Return the numbers of signals that an expression of SIG asks for; none for another one."""
    if isinstance(node, Prefix):
        inner = _numbers_asked(text, bare(node.operand))
        minus = len(inner) == 1 and inner[0][:1] != "-"
        return [f"-{inner[0]}"] if minus and node.operator in ("NOT", "-") else []
    if isinstance(node, Infix) and node.operator in _JOINING:
        left, right = (_numbers_asked(text, bare(side)) for side in (node.left, node.right))
        return [*left, *right] if left and right and node.operator == "AND" else []
    if not isinstance(node, Application) or node.name.text.lower() != "sig":
        return []
    return [text[part.start : part.end] for part in node.arguments if part is not None]
