"""`VALUE 4-6:` and `VALUE 1 OR 2:`: one number, where several are meant."""

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.roles import COMPARISONS
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Infix, Item, Number, Parenthesised
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Case, ValueGroup

VALUE_LIST = Rule("V270", "value-list")

_MOST_WRITTEN = 10  # numbers of a range that are written out


def check_groups(problems: Problems, program: ProgramText) -> None:
    """Warn of values of a CASE that are worked out of two numbers."""
    selector: Item | None = None
    for step in program.steps:
        node = step.statement
        if isinstance(node, Case):
            selector = node.selector
        if isinstance(node, ValueGroup):
            for value in node.values:
                if _compares(problems, value, selector):
                    continue
                instead = _meant(value)
                if value is not None and instead:
                    _report(problems, node, value, instead)


def _meant(value: Item | None) -> list[int]:
    """Return the numbers that a value stands for: those of a range, or on both sides of OR."""
    while isinstance(value, Parenthesised):
        value = value.inner
    if not isinstance(value, Infix):
        return []
    if value.operator == "OR":
        left, right = _numbers(value.left), _numbers(value.right)
        return left + right if left and right else []
    if value.operator != "-" or not isinstance(value.left, Number):
        return []
    first, last = number_of(value.left), number_of(value.right)
    if first is None or last is None or not 0 <= first < last or last - first >= _MOST_WRITTEN:
        return []
    return list(range(round(first), round(last) + 1))


def _compares(problems: Problems, value: Item | None, selector: Item | None) -> bool:
    """`VALUE x > 3:`: true and false are -1 and 0; return whether it was told."""
    inner = value
    while isinstance(inner, Parenthesised):
        inner = inner.inner
    if value is None or not isinstance(inner, Infix) or inner.operator not in COMPARISONS:
        return False
    text = problems.source.text
    of = text[selector.start : selector.end].strip("() \t").lower() if selector is not None else ""
    if of not in (text[side.start : side.end].lower() for side in (inner.left, inner.right)):
        return False  # `CASE TRUE OF`
    written = text[value.start : value.end]
    problems.warning(
        VALUE_LIST,
        f"`{written}` is a condition: as a value it is -1 for true, 0 for false",
        value.start,
        value.end,
        notes=("VALUE takes numbers: the CASE compares them with its expression",),
        help=(f"list the numbers, or ask by IF: `IF {written} THEN`",),
    )
    return True


def _numbers(value: Item) -> list[int]:
    number = number_of(value)
    return [round(number)] if number is not None else _meant(value)


def _report(problems: Problems, node: ValueGroup, value: Item, numbers: list[int]) -> None:
    text = problems.source.text
    written = text[value.start : value.end]
    instead = ", ".join(map(str, numbers))
    is_range = "-" in written
    headline = f"`{written}` is one number: {numbers[0] - numbers[-1]}"
    note = "VALUE knows no ranges: `-` subtracts"
    if not is_range:
        headline = f"`{written}` is one value, and not a choice of {len(numbers)}"
        note = "OR yields -1 for true or 0 for false"
    problems.warning(
        VALUE_LIST,
        headline,
        value.start,
        value.end,
        notes=(note,),
        help=(f"list all numbers, with commas between them: `VALUE {instead}:`",),
        fix=problems.replace(value.start, value.end, instead),
    )
