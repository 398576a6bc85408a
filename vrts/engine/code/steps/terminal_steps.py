"""TYPE and PROMPT, and parts of strings, as closures."""

import re

from vrts.base.numbers import single
from vrts.base.oat import known_components, plain_angles
from vrts.base.pose import Pose
from vrts.base.units import deg
from vrts.engine.code.closures import BLOCKED, Step
from vrts.engine.code.values.arithmetic import LONGEST_STRING, checked_string, integer, rounded
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.functions import number_at_start
from vrts.engine.code.values.pieces import packed, spread
from vrts.engine.code.values.string_functions import written
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Answered, Cause, Printed, Prompted
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Format, FormatKind
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type

MOST_PACKED = 32767 * 128  # characters of a string array

TextInstruction = ir.Type | ir.Prompt | ir.Pack | ir.Decompose


class TerminalStepCompiler:
    """Compiles what deals with text."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def step(self, instruction: TextInstruction, following: int, cause: Cause) -> Step:
        """Return the step of an instruction."""
        match instruction:
            case ir.Type(items=items):
                return self._type(items, following, cause)
            case ir.Prompt():
                return self._prompt(instruction, following, cause)
            case ir.Pack():
                return self._pack(instruction, following, cause)
            case ir.Decompose():
                return self._decompose(instruction, following)

    def _type(self, items: tuple[Expression | Format, ...], following: int, cause: Cause) -> Step:
        text = written(self.expressions, items, "TYPE")
        last = items[-1] if items else None
        end = "" if isinstance(last, Format) and last.kind is FormatKind.STAY else "\r\n"

        def write(c: Context) -> int:
            found = text(c)
            if c.system.is_on("MESSAGES"):
                put(c, found + end, cause)
            return following

        return write

    def _prompt(self, prompt: ir.Prompt, following: int, cause: Cause) -> Step:
        e = self.expressions
        text = e.string(prompt.text) if prompt.text is not None else None
        cells = tuple((e.cell(place), place.variable.type) for place in prompt.places)

        def ask(c: Context) -> int:
            if c.phase == 0:
                if text is not None:
                    put(c, text(c), cause)
                c.phase = 1
                c.events.append(Prompted(c.now, cause))
            answer = c.system.next_answer()
            if answer is None:
                c.wait_for_change()
                return BLOCKED
            line = answer[:LONGEST_STRING]
            c.phase = 0
            c.events.append(Answered(c.now, line, cause))
            put(c, line + "\r\n", cause)
            if len(cells) == 1 and cells[0][1] is Type.STRING:
                cells[0][0](c).assign(line, c.finished)
                return following
            values = numbers_of(line, len(cells), cause)
            for (cell, _), value in zip(cells, values, strict=True):
                cell(c).assign(value, c.finished)
            return following

        return ask

    def _pack(self, instruction: ir.Pack, following: int, cause: Cause) -> Step:
        e, place = self.expressions, instruction.place
        first, length = e.real(instruction.first), e.real(instruction.length)
        text = e.string(instruction.text)
        elements = e.elements(place)

        def pack(c: Context) -> int:
            start = integer(first(c), cause.span, 1, MOST_PACKED, "position")
            part = text(c)
            many = integer(length(c), cause.span, 0, MOST_PACKED, "number of characters")
            for element, at, taken in spread(start, many):
                cell = elements(c, element)
                now = cell.value if isinstance(cell.value, str) else ""
                value = checked_string(packed(now, at, taken, part[:taken]), cause.span)
                cell.assign(value, c.finished)
                part = part[taken:]
            return following

        return pack

    def _decompose(self, instruction: ir.Decompose, following: int) -> Step:
        e = self.expressions
        elements, location = e.elements(instruction.place), e.location(instruction.location)
        plain = instruction.plain_angles

        def decompose(c: Context) -> int:
            found = location(c)
            if isinstance(found, Pose):
                x, y, z, o, a, t = known_components(found)
                values = (x, y, z, *(plain_angles(o, a, t) if plain else (o, a, t)))
            else:
                values = tuple(deg(joint) for joint in found)  # type: ignore[union-attr]
            for k, value in enumerate(values):
                elements(c, k).assign(rounded(value, instruction.place.span), c.finished)
            return following

        return decompose


def put(c: Context, text: str, cause: Cause | None) -> None:
    """Write to the terminal."""
    c.system.terminal.wrote(text)
    c.events.append(Printed(c.now, text, cause))


def numbers_of(line: str, count: int, cause: Cause) -> list[float]:
    """Return the numbers typed in a line; those missing are 0, those too many are ignored.

    Raises:
        RuntimeFault: Something in the line is no number.
    """
    values: list[float] = []
    for word in re.split(r"[\s,]+", line.strip()):
        if not word or len(values) == count:
            continue
        found = number_at_start(word)
        if found is None or found[1] != len(word):
            raise _unreadable(word, line, cause)
        try:
            values.append(single(found[0]))
        except OverflowError:
            raise _unreadable(word, line, cause) from None
    return values + [0.0] * (count - len(values))


def _unreadable(word: str, line: str, cause: Cause) -> RuntimeFault:
    return RuntimeFault(
        RuntimeErrorKind.INVALID_NUMBER,
        f"`{word}` in the answer is no number",
        cause.span,
        notes=(f"the whole line is `{line}`",),
        help=("PROMPT into a string variable, and look at it with VAL",),
    )
