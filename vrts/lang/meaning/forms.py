"""What expressions and statements are by their form alone, before names are looked up."""

from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Text,
)
from vrts.lang.syntax.statements import Device


def is_text(node: Item) -> bool:
    """Return whether an expression is a string: of a sum, one operand tells."""
    while True:
        if isinstance(node, Infix):
            if node.operator != "+":
                return False
            if _is_plain_text(node.right):
                return True
            node = node.left
        elif isinstance(node, Parenthesised):
            node = node.inner
        else:
            return _is_plain_text(node)


def _is_plain_text(node: Item) -> bool:
    while isinstance(node, Parenthesised):
        node = node.inner
    if isinstance(node, Name):
        return node.text[0] == "$"
    if isinstance(node, Text):
        return True
    return isinstance(node, (Application, Element)) and node.name.text[0] == "$"


def with_start(arguments: tuple[Item | None, ...]) -> tuple[Item | None, ...]:
    """Return the arguments of INSTR with the start, which AS lets programs leave out."""
    return (None, *arguments) if len(arguments) == 2 else arguments


def prompt_parts(
    operands: tuple[Item | None, ...],
) -> tuple[Expression | None, tuple[Item | None, ...]]:
    """Return the text of PROMPT and its variables.

    A string variable that stands alone is read into; before others it is the text.
    """
    first = operands[0] if operands else None
    if first is None or not is_text(first):
        return None, operands[1:] if operands and first is None else operands
    alone = isinstance(first, Name | Element) and len(operands) == 1
    if alone or isinstance(first, FormatItem):
        return None, operands
    return first, operands[1:]


def device_is_opaque(node: Device) -> bool:
    """Return whether an instruction with a device does nothing that is simulated.

    The terminal is unit 0 or 4; ATTACH and DETACH of the robot have nothing to do.
    """
    unit = node.unit[0] if node.unit else None
    terminal = unit is None or (isinstance(unit, Number) and unit.value in (0.0, 4.0))
    if node.word in ("ATTACH", "DETACH"):
        robot = unit is None or (isinstance(unit, Number) and unit.value in (0.0, 1.0, 4.0))
        return not robot or bool(node.operands)
    return node.word != "WRITE" or not terminal
