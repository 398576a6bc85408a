"""Formats as other languages write them, in places that take none, or that are none."""

from vrts.lang.meaning.type_mistakes import TYPES_SAY
from vrts.lang.problems import Problems
from vrts.lang.steps.other_forms import INVALID_FORMAT
from vrts.lang.syntax.expressions import FormatItem, Infix


def pascal_format(problems: Problems, node: Infix) -> None:
    """Report `TYPE x:6:2`."""
    text = problems.source.text
    value, *widths = (part.strip() for part in text[node.start : node.end].split(":"))
    instead = f"/F{'.'.join(widths)}, {value}" if len(widths) > 1 else f"/I{widths[0]}, {value}"
    problems.error(
        INVALID_FORMAT,
        "`:` gives no format",
        node.start,
        node.end,
        notes=(TYPES_SAY,),
        help=(f"a format stands before its number: write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead),
    )


def format_here(problems: Problems, node: FormatItem) -> None:
    """Report a format in an expression."""
    problems.error(
        INVALID_FORMAT,
        f"the format `{node.text}` does not belong here",
        node.start,
        node.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=("formats stand in TYPE and $ENCODE",),
    )


def unknown_format(problems: Problems, item: FormatItem) -> None:
    """Report `/Q`."""
    problems.error(
        INVALID_FORMAT,
        f"`{item.text}` is not a format",
        item.start,
        item.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=("formats are /D /F8.2 /I4 /G8.2 /E10.2 /H /O /C /X /U /B /S",),
    )
