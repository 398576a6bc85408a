"""Syntax trees without faults to the flat IR."""

from typing import assert_never

from vrts.base.numbers import single
from vrts.base.source import SourceFile, Span
from vrts.ir import expressions as x
from vrts.ir import instructions as i
from vrts.ir.module import Origin, Program
from vrts.ir.values import Type
from vrts.lang.functions import CONSTANTS, FUNCTIONS
from vrts.lang.names import key
from vrts.lang.scope import Scope
from vrts.lang.structure import Block
from vrts.lang.syntax import (
    Application,
    Assignment,
    Bad,
    CallStatement,
    Case,
    Element,
    Expression,
    For,
    FormatItem,
    Goto,
    HereStatement,
    If,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    ProgramText,
    SetLocation,
    ShiftStatement,
    Simple,
    SpeedStatement,
    Step,
    Structure,
    Text,
    Until,
    ValueGroup,
    Variable,
    While,
)

_UNITS = {None: i.SpeedUnit.PERCENT, "MMPS": i.SpeedUnit.MM_PER_S, "IPS": i.SpeedUnit.INCH_PER_S}
_NO_TURN = (90.0, -90.0, 0.0)  # O, A, T of TRANS without angles [val2.md 4.6 note 1]


class Lowering:
    """Lowers one program."""

    def __init__(
        self,
        source: SourceFile,
        scope: Scope,
        program: ProgramText,
        blocks: list[Block],
        labels: dict[int, int],
    ) -> None:
        self.source = source
        self.scope = scope
        self.program = program
        self.labels = labels
        self.code: list[i.Instruction] = []
        self.origins: list[Origin] = []
        self.opened = {block.opener: block for block in blocks}
        self.ended = {block.end: block for block in blocks}
        self.middle = {at: block for block in blocks for at in block.middles}
        self.numbers: dict[int, int] = {}  # loop or case of a block, by its opener
        self.tests: dict[int, int] = {}  # index of the test of a loop, or of the last VALUE
        self.leaving: dict[int, list[int]] = {}  # jumps to behind a block, by its opener
        self.gotos: list[tuple[int, int]] = []  # instruction, label
        self.loops = 0
        self.cases = 0
        self.origin = Origin(1, Span(source, program.start, program.end))

    def run(self) -> Program:
        """Return the program."""
        for at, step in enumerate(self.program.steps):
            if step.statement is not None:
                self._step(at, step)
        start, end = self.program.finish
        self.origin = Origin(self.program.step_count + 1, Span(self.source, start, end))
        self._emit(i.Return())
        steps = self._steps()
        for at, label in self.gotos:
            target = steps[self.labels[label] - 1]
            jump = self.code[at]
            assert isinstance(jump, i.Jump | i.JumpIf)
            self.code[at] = jump._replace(target=target)
        formals = self.program.formals
        names = [key(formal.name.text) if formal.name.text else "" for formal in formals]
        slots = tuple(x.Slot(n, name, self._formal_type(name)) for n, name in enumerate(names))
        return Program(
            self.program.name,
            slots,
            frozenset(n for n, formal in enumerate(formals) if formal.array),
            tuple(self.code),
            tuple(self.origins),
            steps,
            self.loops,
            self.cases,
            Span(self.source, self.program.start, self.program.end),
        )

    def _formal_type(self, name: str) -> Type:
        return self.scope.entry(self.program.name, name).type if name else Type.DYNAMIC

    def _steps(self) -> tuple[int, ...]:
        first: list[int] = []
        for at, origin in enumerate(self.origins):
            first.extend([at] * (origin.step - len(first)))
        return tuple(first[: self.program.step_count])

    def _emit(self, instruction: i.Instruction) -> int:
        self.code.append(instruction)
        self.origins.append(self.origin)
        return len(self.code) - 1

    def _span(self, node: Item) -> Span:
        return Span(self.source, node.start, node.end)

    # --- statements -----------------------------------------------------------------------------

    def _step(self, at: int, step: Step) -> None:
        node = step.statement
        assert node is not None
        self.origin = Origin(step.number, Span(self.source, node.start, node.end))
        match node:
            case Assignment(target, value) | SetLocation(target, value):
                self._emit(i.Assign(self.place(target), self.value(value)))
            case HereStatement(target):
                self._here(target)
            case ShiftStatement(target, offsets):
                place = self.place(target)
                arguments = (x.Load(place), *self._three(offsets))
                shifted = x.Apply(x.Function.SHIFT, arguments, self.origin.span)
                self._emit(i.Assign(place, shifted))
            case SpeedStatement(value, unit, always):
                scope = i.Scope.ALWAYS if always else i.Scope.NEXT_MOTION
                self._emit(i.SetSpeed(self.value(value), _UNITS[unit], scope))
            case Goto(label, condition):
                jump = i.Jump(0) if condition is None else i.JumpIf(self.value(condition), True, 0)
                self.gotos.append((self._emit(jump), int(label.value)))
            case If(condition):
                self.leaving[at] = [self._emit(i.JumpIf(self.value(condition), False, 0))]
            case While(condition):
                self.tests[at] = self._emit(i.JumpIf(self.value(condition), False, 0))
                self.leaving[at] = [self.tests[at]]
            case Until(condition):
                top = self.tests[self.ended[at].opener]
                self._emit(i.JumpIf(self.value(condition), False, top))
            case For():
                self._for(at, node)
            case Case(selector):
                self.numbers[at] = self.cases
                self.leaving[at] = []
                self._emit(i.BeginCase(self.value(selector), self.cases))
                self.cases += 1
            case ValueGroup(values):
                block = self._next_group(at)
                case = self.numbers[block.opener]
                tested = tuple(self.value(v) for v in values if v is not None)
                self.tests[block.opener] = self._emit(i.TestCase(case, tested, 0))
            case Structure():
                self._structure(at, node)
            case CallStatement(program, arguments):
                passed = tuple(self._argument(argument) for argument in arguments)
                self._emit(i.Call(key(program.text), passed, self._span(program)))
            case Simple():
                self._simple(node)
            case Bad():
                raise AssertionError("a program with a bad step is not lowered")
            case _:
                assert_never(node)

    def _for(self, at: int, node: For) -> None:
        place = self.place(node.target)
        increment = self.value(node.increment) if node.increment is not None else None
        loop = self.numbers[at] = self.loops
        self.loops += 1
        self._emit(
            i.BeginFor(place, self.value(node.first), self.value(node.last), increment, loop)
        )
        self.tests[at] = self._emit(i.TestFor(place, loop, 0))
        self.leaving[at] = [self.tests[at]]

    def _structure(self, at: int, node: Structure) -> None:
        match node.word:
            case "DO":
                self.tests[at] = len(self.code)
            case "ELSE":
                opener = self.middle[at].opener
                test = self.leaving[opener].pop()
                self.leaving[opener].append(self._emit(i.Jump(0)))
                self._aim(test, len(self.code))
            case "ANY":
                self._next_group(at)
            case _:
                self._end(self.ended[at])

    def _next_group(self, at: int) -> Block:
        """Close the group before a VALUE or ANY: who comes from above leaves the CASE."""
        block = self.middle[at]
        if block.middles[0] != at:
            self.leaving[block.opener].append(self._emit(i.Jump(0)))
            self._aim(self.tests.pop(block.opener), len(self.code))
        return block

    def _end(self, block: Block) -> None:
        at = block.opener
        if block.word == "FOR":
            test = self.code[self.tests[at]]
            assert isinstance(test, i.TestFor)
            self._emit(i.NextFor(test.place, test.loop, self.tests[at]))
        elif block.word == "WHILE":
            self._emit(i.Jump(self.tests[at]))
        elif block.word == "CASE" and at in self.tests:
            self._aim(self.tests.pop(at), len(self.code))
        for jump in self.leaving[at]:
            self._aim(jump, len(self.code))

    def _aim(self, at: int, target: int) -> None:
        match instruction := self.code[at]:
            case i.Jump() | i.JumpIf():
                self.code[at] = instruction._replace(target=target)
            case i.TestFor():
                self.code[at] = instruction._replace(leave=target)
            case i.TestCase():
                self.code[at] = instruction._replace(otherwise=target)
            case _:
                raise AssertionError("only jumps are aimed")

    def _here(self, target: Expression) -> None:
        frame = None
        if isinstance(target, Infix):
            frame, target = self.value(target.left), target.right
        assert isinstance(target, Name | Element)
        self._emit(i.AssignHere(self.place(target), frame))

    def _simple(self, node: Simple) -> None:
        word = node.word
        values = [self._optional(v) for v in node.operands if not isinstance(v, FormatItem)]
        first = values[0] if values else None
        joint, linear = i.Interpolation.JOINT, i.Interpolation.LINEAR
        match word:
            case "MOVE" | "MOVES" | "APPRO" | "APPROS":
                assert first is not None
                retreat = values[1] if len(values) > 1 else None
                self._emit(i.Move(linear if word[-1] == "S" else joint, first, retreat))
            case "DEPART" | "DEPARTS":
                assert first is not None
                self._emit(i.Depart(linear if word[-1] == "S" else joint, first))
            case "DRIVE":
                change = values[1]
                assert first is not None
                assert change is not None
                self._emit(i.Drive(first, change, values[2] if len(values) > 2 else None))
            case "READY":
                self._emit(i.Ready())
            case "DELAY":
                assert first is not None
                self._emit(i.Delay(first))
            case "BREAK":
                self._emit(i.Break())
            case "RETURN":
                self._emit(i.Return())
            case "RIGHTY" | "LEFTY" | "ABOVE" | "BELOW" | "FLIP" | "NOFLIP":
                self._emit(i.RequestBranch(i.BranchRequest(word.lower())))
            case "OPEN" | "CLOSE" | "RELAX" | "OPENI" | "CLOSEI" | "RELAXI":
                action = i.HandAction(word.removesuffix("I").lower())
                self._emit(i.MoveHand(action, word[-1] == "I", first))
            case "TOOL":
                self._emit(i.SetTool(first))
            case "BASE":
                self._emit(i.SetBase(*(values + [None] * 4)[:4]))
            case "STOP":
                self._emit(i.Stop(first))
            case "HALT":
                self._emit(i.Halt(first))
            case "PAUSE":
                self._emit(i.Pause(first))
            case "SIGNAL":
                self._emit(i.Signal(tuple(v for v in values if v is not None)))
            case "WAIT":
                self._emit(i.Wait(first))
            case "TYPE":
                self._emit(i.Type(self._written(node.operands)))
            case _:
                raise AssertionError(f"no lowering for {word}")

    def _written(self, items: tuple[Item | None, ...]) -> tuple[x.Expression | i.Format, ...]:
        return tuple(
            _format(item.text) if isinstance(item, FormatItem) else self.value(item)
            for item in items
            if item is not None
        )

    # --- expressions ----------------------------------------------------------------------------

    def variable(self, name: Name) -> x.Variable:
        """Return the variable of a name as the program sees it."""
        entry = self.scope.entry(self.program.name, key(name.text))
        if entry.formal is not None:
            return x.Slot(entry.formal, entry.name, entry.type)
        return x.Global(entry.name, entry.type)

    def place(self, node: Variable) -> x.Place:
        """Return what a name or element stands for when assigned."""
        if isinstance(node, Name):
            return x.Place(self.variable(node), (), self._span(node))
        subscripts = tuple(
            self.value(s) if s is not None else x.Constant(0.0) for s in node.subscripts
        )
        return x.Place(self.variable(node.name), subscripts, self._span(node))

    def value(self, node: Item) -> x.Expression:
        """Return an expression."""
        span = self._span(node)
        match node:
            case Number(value):
                return x.Constant(value, span)
            case Text(value):
                return x.Constant(value, span)
            case Parenthesised(inner):
                return self.value(inner)
            case Element():
                return x.Load(self.place(node))
            case Name():
                return self._name(node, span)
            case Prefix(operator, operand):
                if operator == "+":
                    return self.value(operand)
                return x.Unary(x.UnaryOperator(operator.lower()), self.value(operand), span)
            case Infix(operator, left, right):
                if operator == ":":
                    a, b = self.value(left), self.value(right)
                    parts = a.parts if isinstance(a, x.Compose) else (a,)
                    return x.Compose((*parts, b), span)
                return x.Binary(
                    x.BinaryOperator(operator.lower()), self.value(left), self.value(right), span
                )
            case Application():
                return self._application(node, span)
            case FormatItem():
                raise AssertionError("a format is no expression")

    def _optional(self, node: Item | None) -> x.Expression | None:
        return None if node is None else self.value(node)

    def _name(self, node: Name, span: Span) -> x.Expression:
        lower = node.text.lower()
        if lower in CONSTANTS:
            return x.Constant(single(CONSTANTS[lower]), span)
        signature = FUNCTIONS.get(lower)
        if signature is not None and signature.bare:
            assert signature.function is not None
            return x.Apply(signature.function, (), span)
        return x.Load(self.place(node))

    def _application(self, node: Application, span: Span) -> x.Expression:
        function = FUNCTIONS[node.name.text.lower()].function
        assert function is not None
        match function:
            case x.Function.TRANS:
                arguments = self._trans(node.arguments)
            case x.Function.SHIFT:
                pose = node.arguments[0]
                assert pose is not None
                arguments = (self.value(pose), *self._three(node.arguments[1:]))
            case x.Function.PPOINT:
                arguments = self._filled(node.arguments, (0.0,) * 6)
            case x.Function.DEFINED:
                first = node.arguments[0]
                assert isinstance(first, Name | Element)
                arguments = (self._variable_argument(first),)
            case _:
                arguments = tuple(self._optional(a) for a in node.arguments)
        return x.Apply(function, arguments, span)

    def _variable_argument(self, node: Variable) -> x.Place | x.WholeArray:
        if isinstance(node, Element) and not node.subscripts:
            return x.WholeArray(self.variable(node.name), self._span(node))
        return self.place(node)

    def _argument(self, node: Item | None) -> x.Expression | x.Place | x.WholeArray | None:
        if node is None:
            return None
        if isinstance(node, Element):
            return self._variable_argument(node)
        if isinstance(node, Name):
            value = self.value(node)
            return value.place if isinstance(value, x.Load) else value
        return self.value(node)

    def _trans(self, arguments: tuple[Item | None, ...]) -> tuple[x.Expression, ...]:
        angles = arguments[3:]
        turned = any(a is not None for a in angles)
        return self._filled(arguments, (0.0, 0.0, 0.0, *((0.0,) * 3 if turned else _NO_TURN)))

    def _three(self, offsets: tuple[Item | None, ...]) -> tuple[x.Expression, ...]:
        return self._filled(offsets, (0.0, 0.0, 0.0))

    def _filled(
        self, arguments: tuple[Item | None, ...], defaults: tuple[float, ...]
    ) -> tuple[x.Expression, ...]:
        padded = (*arguments, *(None for _ in defaults))
        return tuple(
            x.Constant(default) if argument is None else self.value(argument)
            for argument, default in zip(padded, defaults, strict=False)
        )


def _format(text: str) -> i.Format:
    width, _, decimals = text[2:].partition(".")
    return i.Format(
        i.FormatKind(text[1].upper()),
        int(width) if width else None,
        int(decimals) if decimals else None,
    )
