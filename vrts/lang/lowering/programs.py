"""Syntax trees without faults to the flat IR."""

from typing import assert_never

from vrts.base.made import made
from vrts.base.source import SourceFile, Span
from vrts.ir import expressions as x
from vrts.ir import instructions as i
from vrts.ir.module import Origin, Program
from vrts.ir.values import Type
from vrts.lang.joined import span_in
from vrts.lang.lowering.instructions import InstructionLowering
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.meaning.scope import Scope
from vrts.lang.meaning.structure import Block, exits, label_key
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Expression, Infix, Name
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import (
    Assignment,
    Bad,
    CallNamed,
    CallStatement,
    Case,
    Declare,
    Device,
    For,
    Give,
    Goto,
    HereStatement,
    If,
    PackStatement,
    Put,
    ReactStatement,
    Rest,
    SetLocation,
    Setting,
    ShiftStatement,
    Simple,
    SpeedStatement,
    Structure,
    Until,
    ValueGroup,
    While,
)


class Lowering(InstructionLowering):
    """Lowers one program."""

    def __init__(
        self,
        source: SourceFile,
        scope: Scope,
        types: NameUses,
        program: ProgramText,
        blocks: list[Block],
        labels: dict[int | str, int],
    ) -> None:
        super().__init__(source, scope, types, program)
        self.program = program
        self.labels = labels
        self.opened = {block.opener: block for block in blocks}
        self.ended = {block.end: block for block in blocks}
        self.middle = {at: block for block in blocks for at in block.middles}
        self.numbers: dict[int, int] = {}  # loop or case of a block, by its opener
        self.tests: dict[int, int] = {}  # index of the test of a loop, or of the last VALUE
        self.leaving: dict[int, list[int]] = {}  # jumps to behind a block, by its opener
        self.continuing: dict[int, list[int]] = {}  # jumps to the next pass of a loop
        self.exits = exits(program, blocks)
        self.loops = 0
        self.cases = 0

    def run(self) -> Program:
        """Return the program."""
        for at, step in enumerate(self.program.steps):
            if step.statement is not None:
                self._step(at, step)
        start, end = self.program.finish
        self.origin = Origin(self.program.step_count + 1, span_in(self.source, start, end))
        self._emit(i.Return())
        steps = self._steps()
        for at, label in self.gotos:
            target = steps[self.labels[label] - 1]
            jump = self.code[at]
            if isinstance(jump, i.Grasp):
                self.code[at] = jump._replace(missing=target)
            else:
                assert isinstance(jump, i.Jump | i.JumpIf)
                self.code[at] = jump._replace(target=target)
        formals = self.program.formals
        names = [key(formal.name.text) if formal.name.text else "" for formal in formals]
        slots = tuple(x.Slot(n, name, self._formal_type(name)) for n, name in enumerate(names))
        automatics = self.scope.automatics(self.program.name)
        arrays = {n for n, formal in enumerate(formals) if formal.array}
        arrays |= {e.slot for e in automatics if e.array is not None and e.slot is not None}
        return Program(
            self.program.name,
            slots,
            frozenset(arrays),
            tuple(self.code),
            tuple(self.origins),
            steps,
            self.loops,
            self.cases,
            span_in(self.source, self.program.start, self.program.end),
            tuple(x.Slot(e.slot or 0, e.name, e.type) for e in automatics),
        )

    def _formal_type(self, name: str) -> Type:
        return self.scope.entry(self.program.name, name).type if name else Type.DYNAMIC

    def _steps(self) -> tuple[int, ...]:
        first: list[int] = []
        for at, origin in enumerate(self.origins):
            first.extend([at] * (origin.step - len(first)))
        return tuple(first[: self.program.step_count])

    # --- statements -----------------------------------------------------------------------------

    def _step(self, at: int, step: Step) -> None:
        node = step.statement
        assert node is not None
        span = (
            span_in(self.source, node.start, node.end)
            if self.joined
            else made(Span, (self.source, node.start, node.end))
        )
        self.origin = made(Origin, (step.number, span))
        if isinstance(node, Simple):
            if node.word in ("EXIT", "NEXT"):
                self._leave(at, node)
            else:
                self.simple(node)
            return
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
            case SpeedStatement():
                self.speed(node)
            case Setting():
                self.setting(node)
            case Give():
                self.give(node)
            case Put():
                self.put(node)
            case PackStatement(target, first, count, value):
                part = (self.value(first), self.value(count), self.value(value))
                self._emit(i.Pack(self.place(target), *part))
            case ReactStatement():
                self.react(node)
            case Device():
                self.device(node)
            case Rest():
                self.opaque(node)
            case Declare():
                pass
            case CallNamed(name, arguments):
                passed = tuple(self._argument(argument) for argument in arguments)
                self._emit(i.CallNamed(self.value(name), passed))
            case Goto(label, condition):
                jump = i.Jump(0) if condition is None else i.JumpIf(self.value(condition), True, 0)
                self.gotos.append((self._emit(jump), label_key(label)))
            case If(condition):
                self.leaving[at] = [self._emit(i.JumpIf(self.value(condition), False, 0))]
            case While(condition):
                self.tests[at] = self._emit(i.JumpIf(self.value(condition), False, 0))
                self.leaving[at] = [self.tests[at]]
            case Until(condition):
                opener = self.ended[at].opener
                self._aim_all(self.continuing, opener)
                self._emit(i.JumpIf(self.value(condition), False, self.tests[opener]))
                self._aim_all(self.leaving, opener)
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
                self.leaving[at] = []
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
        self._aim_all(self.continuing, at)
        if block.word == "FOR":
            test = self.code[self.tests[at]]
            assert isinstance(test, i.TestFor)
            self._emit(i.NextFor(test.place, test.loop, self.tests[at]))
        elif block.word == "WHILE":
            self._emit(i.Jump(self.tests[at]))
        elif block.word == "CASE" and at in self.tests:
            self._aim(self.tests.pop(at), len(self.code))
        self._aim_all(self.leaving, at)

    def _leave(self, at: int, node: Simple) -> None:
        """EXIT and NEXT: jump behind a loop around, or to the end of its body."""
        block = self.exits[at]
        assert block is not None
        opener = block.opener
        jumps = self.leaving if node.word == "EXIT" else self.continuing
        jumps.setdefault(opener, []).append(self._emit(i.Jump(0)))

    def _aim_all(self, jumps: dict[int, list[int]], opener: int) -> None:
        for jump in jumps.get(opener, ()):
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
