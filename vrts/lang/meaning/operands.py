"""Operands of the instructions that are a word and a list: which types they want."""

from collections.abc import Sequence

from vrts.base.diagnostic import Fix, Rule
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.decimal_commas import likeliest
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.meaning.expression_types import ExpressionTypes
from vrts.lang.meaning.forms import device_is_opaque, prompt_parts
from vrts.lang.meaning.functions.arguments import FUNCTION_ARGUMENTS
from vrts.lang.meaning.instead.numbers_of_base import base_of_location
from vrts.lang.meaning.type_mistakes import TYPES_SAY, WRONG_TYPE, not_read_into
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    FormatItem,
    Item,
    Name,
    Number,
    Prefix,
    Text,
)
from vrts.lang.syntax.statements import Device, Give, ReactStatement, Simple, SpeedStatement
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

WITHOUT_EFFECT = Rule("V229", "without-effect")

_LOCATION_WORDS = frozenset(
    {"MOVE", "MOVES", "APPRO", "APPROS", "MOVET", "MOVEST", "C1MOVE", "C2MOVE"}
)
_TEXT_WORDS = frozenset({"STOP", "HALT", "PAUSE"})
_PROGRAM_WORDS = frozenset({"REACTE", "PCEXECUTE"})  # their first operand names a program
_HAND_WORDS = frozenset({"OPEN", "CLOSE", "RELAX", "OPENI", "CLOSEI", "RELAXI"})
_FRAME_POINTS = 4  # FRAME f = a, b, c, d


class OperandTypes(ExpressionTypes):
    """Checks the operands of instructions."""

    def simple(self, node: Simple) -> None:
        """Check an instruction with a plain list of operands."""
        word, operands = node.word, node.operands
        if INSTRUCTIONS[word].opaque:
            self.warn_not_simulated(word, node.start, node.start + len(word))
        if word in _LOCATION_WORDS:
            first, *rest = operands
            if isinstance(first, Number) and rest and isinstance(rest[0], Name):
                self._swapped(node, first, rest[0])
            elif first is not None:
                self._location(first, f"{word} goes to a location")
            self._items(tuple(rest), Type.REAL)
        elif word == "TOOL" or (word == "BASE" and self.dialect.is_as):
            for operand in operands:
                if operand is not None:
                    self.check(operand, Type.POSE, f"{word} takes a location")
        elif word in ("BASE", "DRAW"):
            given = base_of_location(self.problems, WRONG_TYPE, node, self._is_located)
            self._items(operands if given is None else given, Type.REAL)
        elif word in _TEXT_WORDS:
            self._items(operands, Type.STRING)
        elif word == "TYPE":
            self.items_of_type(operands)
        elif word == "TYPEI":
            self._items(operands, Type.REAL)
        elif word in ("ENABLE", "DISABLE"):
            for operand in operands:
                if operand is not None:
                    self.system_name(operand, SWITCHES.keys(), "switch")
        elif word == "PROMPT":
            self._prompt(operands)
        elif word in _PROGRAM_WORDS:
            if operands and operands[0] is not None:
                self.program_name(operands[0], word)
            self._items(operands[1:], Type.REAL)
        elif word == "GRASP":
            self._items(operands[:1], Type.REAL)
        elif word in _HAND_WORDS and self._is_step_behind(node, operands):
            pass
        else:
            self._items(operands, Type.REAL)

    def _is_located(self, node: Item) -> bool:
        return not isinstance(node, FormatItem) and self.is_location(node)

    def _is_step_behind(self, node: Simple, operands: tuple[Item | None, ...]) -> bool:
        """Report `OPENI READY`, two steps on a line; return whether it is that."""
        name = operands[0] if len(operands) == 1 else None
        if not isinstance(name, Name) or self.dialect.tolerant:
            return False
        word = INSTRUCTIONS.get(name.text.upper())
        if word is None or word.terminal != "WORD0":
            return False
        text = self.problems.source.text
        start = text.rfind("\n", 0, node.start) + 1
        before = text[start : node.start]
        margin = before if not before.strip() else " " * len(before)
        self.problems.error(
            UNEXPECTED_TEXT,
            "each step stands on a line of its own",
            name.start,
            name.end,
            "another step begins here",
            notes=("VAL-II says *Unexpected text at end of line*",),
            help=(f"give each a line of its own: `{node.word}`, `{word.text}`",),
            fix=self.problems.replace(node.start + len(node.word), name.start, f"\n{margin}"),
        )
        return True

    def _prompt(self, operands: tuple[Item | None, ...]) -> None:
        text, variables = prompt_parts(operands)
        if text is not None:
            self.check(text, Type.STRING, "PROMPT shows a text first")
        for variable in variables:
            if isinstance(variable, Name | Element):
                name = variable if isinstance(variable, Name) else variable.name
                kind = Type.STRING if name.text[0] == "$" else Type.REAL
                self._write(variable, kind, "PROMPT reads numbers and strings", None)
            elif variable is not None:
                not_read_into(self.problems, operands, variable)
                break

    def give(self, node: Give) -> None:
        """Check PARAMETER, DECOMPOSE and the assignments of VAL."""
        word, target, values = node.word, node.target, node.values
        match word:
            case "PARAMETER":
                self.system_name(target, PARAMETERS.keys(), "parameter")
                if isinstance(target, Element):
                    self._items(target.subscripts, Type.REAL)
                self._values(node, 1, Type.REAL)
            case "SWITCH":
                self.system_name(target, SWITCHES.keys(), "switch")
                if isinstance(target, Element):
                    self._items(target.subscripts, Type.REAL)
                self._values(node, 1, Type.REAL)
            case "DECOMPOSE":
                if self._reversed(node, target, values):
                    return
                if isinstance(target, Element) and not target.subscripts:
                    target = target._replace(subscripts=(Number(0.0, target.start, target.end),))
                self._write(target, Type.REAL, "DECOMPOSE stores numbers", None)
                if self._count_of(node, 1):
                    self._location(values[0], "DECOMPOSE takes a location")
            case "SETI":
                self._write(target, Type.REAL, "SETI gives a value to a number", values[0])
                self._values(node, 1, Type.REAL)
            case _:
                self._write(target, Type.POSE, f"{word} gives a value to a location", None)
                self._values(node, _FRAME_POINTS if word == "FRAME" else 1, Type.POSE)

    def _values(self, node: Give, count: int, wanted: Type) -> None:
        if self._count_of(node, count):
            self._items(node.values, wanted)

    def _count_of(self, node: Give, count: int) -> bool:
        if len(node.values) == count:
            return True
        written = self.problems.source.text[node.start : node.end]
        pointed = likeliest(written, len(node.values) - count)
        help_ = f"write `{INSTRUCTIONS[node.word].usage}`"
        if pointed:
            help_ = f"a comma is no decimal sign: write a point, as in `{pointed.text}`"
        self.problems.error(
            FUNCTION_ARGUMENTS,
            f"{node.word} takes {count} value{'' if count == 1 else 's'}, {len(node.values)} given",
            node.start,
            node.end,
            help=(help_,),
            fix=self.problems.replace(node.start, node.end, pointed.text, sure=pointed.sure)
            if pointed
            else None,
        )
        return False

    def react(self, node: ReactStatement) -> None:
        """Check REACT, REACTI, IGNORE, ON and ONI."""
        signal, program, priority = (*node.operands, None, None, None)[:3]
        if isinstance(signal, Name) and isinstance(program, Number | Prefix):
            self._swapped_program(node, signal, program)
            return
        if signal is None:
            self.problems.error(
                FUNCTION_ARGUMENTS,
                f"{node.word} needs a signal number",
                node.start,
                node.end,
                notes=("VAL-II says *Missing argument*",),
                help=(f"write `{INSTRUCTIONS[node.word].usage}`",),
            )
        else:
            self.check(signal, Type.REAL, f"{node.word} watches a signal")
        if program is not None:
            self.program_name(program, node.word)
        elif node.word == "REACT":
            self.problems.warning(
                WITHOUT_EFFECT,
                "REACT without a program does nothing",
                node.start,
                node.end,
                notes=("REACTI without a program stops the motion",),
                help=("name the program to call: `REACT signal, program`",),
            )
        if priority is not None:
            self.check(priority, Type.REAL, "a priority is a number")

    def _swapped_program(self, node: ReactStatement, name: Name, signal: Number | Prefix) -> None:
        """`REACTI intruder, 1003`."""
        text = self.problems.source.text
        self.called.append(name)
        written = f"{text[signal.start : signal.end]}, {name.text}"
        self.problems.error(
            WRONG_TYPE,
            f"the signal comes first in {node.word}, then the program",
            name.start,
            signal.end,
            notes=("VAL-II says *Invalid program or variable name*",),
            help=(f"write `{node.word} {written}`",),
            fix=self.problems.replace(
                name.start, signal.end, written, sure=key(name.text) in self.scope.programs
            ),
        )

    def program_name(self, node: Item, word: str) -> None:
        """Note that an operand names a program; report what cannot."""
        if isinstance(node, Name) and node.text[0] not in "$#":
            self.called.append(node)
            return
        headline, help_ = (
            f"{word} takes the name of a program",
            f"write `{INSTRUCTIONS[word].usage}`",
        )
        fix: Fix | None = None
        if isinstance(node, Application):
            headline += ", without arguments"
            help_ = f"leave the parentheses out: write `{node.name.text}`"
            fix = self.problems.replace(node.name.end, node.end, "")
        elif isinstance(node, Text):
            headline += ", without quotes"
            help_ = f"write the name alone: `{node.value}`"
        self.problems.error(
            WRONG_TYPE,
            headline,
            node.start,
            node.end,
            notes=("VAL-II says *Invalid program or variable name*",),
            help=(help_,),
            fix=fix,
        )

    def device(self, node: Device) -> None:
        """Check the instructions of V+ with a device: WRITE is TYPE on the terminal."""
        if node.word == "WRITE":
            self.items_of_type(node.operands)
            operands = node.unit or ()
        else:
            operands = (*(node.unit or ()), *node.operands, *(node.given or ()))
        for operand in operands:
            self.loosely(operand)
        if device_is_opaque(node):
            self.warn_not_simulated(node.word, node.start, node.start + len(node.word))

    def profile(self, node: SpeedStatement, numbers: tuple[Item | None, ...]) -> None:
        """Check the profile of ACCEL, and say once that the arm has but one."""
        self._items(numbers, Type.REAL)
        if not self.profiles:
            self.profiles = True
            self.problems.warning(
                WITHOUT_EFFECT,
                "the profile of an acceleration has no effect",
                node.start,
                node.end,
                notes=("the arm is simulated with one form of acceleration",),
            )

    def _reversed(self, node: Give, target: Item, values: Sequence[Item | None]) -> bool:
        """`DECOMPOSE part = x[0]`, where `part` is a location above."""
        array = values[0] if len(values) == 1 else None
        if not isinstance(target, Name) or not isinstance(array, Element):
            return False
        if Type.POSE not in self.scope.entry(self.program, key(target.text)).types:
            return False
        text = self.problems.source.text
        location, first = text[target.start : target.end], text[array.start : array.end]
        self._location(target, "DECOMPOSE takes a location")
        self._write(array, Type.REAL, "DECOMPOSE stores numbers", None)
        self.problems.error(
            WRONG_TYPE,
            "DECOMPOSE has the array before `=`, and the location behind it",
            target.start,
            array.end,
            help=(f"write `DECOMPOSE {first} = {location}`",),
            fix=self.problems.replace(target.start, array.end, f"{first} = {location}"),
        )
        return True

    def _swapped(self, node: Simple, distance: Number, location: Name) -> None:
        """`APPRO 50, part`."""
        text = self.problems.source.text[distance.start : distance.end]
        word = self.problems.source.text[node.start : distance.start].strip().upper()
        self.wrong_lines.add(self.problems.source.line_of(node.start))
        self.problems.error(
            WRONG_TYPE,
            f"the location comes first in {word}",
            distance.start,
            location.end,
            notes=(TYPES_SAY,),
            help=(f"write `{word} {location.text}, {text}`",),
            fix=self.problems.replace(distance.start, location.end, f"{location.text}, {text}"),
        )

    def _location(self, node: Item, why: str) -> None:
        self.check(node, Type.POSE, why, joints=True)
