"""Statements: which types each wants, and which names each gives a value."""

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.expression_types import FUNCTION_ARGUMENTS, TYPES_SAY, WRONG_TYPE, ExpressionTypes
from vrts.lang.functions import CONSTANTS, FUNCTIONS
from vrts.lang.names import key
from vrts.lang.scope import Passed
from vrts.lang.syntax import (
    Application,
    Assignment,
    Bad,
    CallStatement,
    Case,
    Element,
    Expression,
    For,
    Goto,
    HereStatement,
    If,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    SetLocation,
    ShiftStatement,
    Simple,
    SpeedStatement,
    Statement,
    Until,
    ValueGroup,
    Variable,
    While,
)

ASSIGNED_LOCATION = Rule("V203", "assigned-location")

_LOCATION_WORDS = frozenset({"MOVE", "MOVES", "APPRO", "APPROS"})
_TEXT_WORDS = frozenset({"STOP", "HALT", "PAUSE"})


class Resolver(ExpressionTypes):
    """Walks the statements of one program after the other."""

    def statement(self, node: Statement) -> None:
        """Record and check one statement of the current program."""
        match node:
            case Assignment(target, value):
                self._assignment(node, target, value)
            case SetLocation(target, value):
                self._write(target, Type.POSE, "SET gives a value to a location", value)
                self._location(value, "SET gives a value to a location")
            case HereStatement(target):
                self._here(target)
            case ShiftStatement(target, offsets):
                self._write(target, Type.POSE, "SHIFT moves a location", None)
                self._items(offsets, Type.REAL)
            case Simple():
                self._simple(node)
            case SpeedStatement(value):
                self.check(value, Type.REAL, "SPEED takes a number")
            case Goto(_, condition):
                if condition is not None:
                    self.check(condition, Type.REAL, "IF takes a condition")
            case If(condition) | While(condition) | Until(condition) | Case(condition):
                self.check(condition, Type.REAL, "a condition is a number")
            case ValueGroup(values):
                self._items(values, Type.REAL)
            case For(target, first, last, increment):
                self._write(target, Type.REAL, "FOR counts a number", None)
                for part in (first, last, increment):
                    if part is not None:
                        self.check(part, Type.REAL, "FOR counts with numbers")
            case CallStatement(program, arguments):
                self._call(program, arguments)
            case Bad(_, names):
                self.bad_names.update(names)
            case _:
                pass

    # --- statements -----------------------------------------------------------------------------

    def _assignment(self, node: Assignment, target: Variable, value: Expression) -> None:
        name = target if isinstance(target, Name) else target.name
        if name.text[0] == "$":
            self._write(target, Type.STRING, "`=` keeps the type", value)
            self.check(value, Type.STRING, f"`{name.text}` holds a string")
            return
        if name.text[0] == "#" or self._is_location(value):
            self._type(value, Type.POSE)
            self.assigned_location(node)
            if name.text[0] != "#":
                self._write(target, Type.POSE, "", value)
            return
        if isinstance(value, Name | Element) and self._open_type(value):
            self.moves.append(node)
            self.program_of[node.start] = self.program
            self._write(target, Type.REAL, "", value)
            entry = self.scope.entry(self.program, key(name.text))
            if entry.types.get(Type.REAL) == (name.start, name.end):
                del entry.types[Type.REAL]
            self._type(value, None)
            return
        self._write(target, Type.REAL, "`=` gives a value to a number", value)
        self.check(value, Type.REAL, f"`{name.text}` holds a number")

    def _open_type(self, node: Name | Element) -> bool:
        name = node if isinstance(node, Name) else node.name
        lower = name.text.lower()
        known = lower in CONSTANTS or (lower in FUNCTIONS and FUNCTIONS[lower].bare)
        return name.text[0] not in "$#" and not known

    def _is_location(self, node: Expression) -> bool:
        while isinstance(node, Parenthesised):
            node = node.inner
        if isinstance(node, Infix):
            return node.operator == ":"
        if isinstance(node, Element):
            return node.name.text[0] == "#"
        name = node.name if isinstance(node, Application) else node
        if not isinstance(name, Name):
            return False
        signature = FUNCTIONS.get(name.text.lower())
        if signature is None:
            return name.text[0] == "#"
        usable = signature.bare or isinstance(node, Application)
        return usable and signature.result in (Type.POSE, Type.JOINTS)

    def assigned_location(self, node: Assignment) -> None:
        """Report `a = b` between locations."""
        self.problems.error(
            ASSIGNED_LOCATION,
            "a location is given a value by SET",
            node.start,
            node.target.end,
            notes=("`=` is for numbers and strings", "VAL-II says *Illegal assignment*"),
            help=(f"write `SET {self.problems.source.text[node.start : node.end]}`",),
            fix=self.problems.replace(node.start, node.start, "SET "),
        )

    def _here(self, target: Expression) -> None:
        last = target
        if isinstance(target, Infix) and target.operator == ":":
            self.check(target.left, Type.POSE, "`:` joins locations")
            last = target.right
        if isinstance(last, Name | Element):
            self._write(last, Type.POSE, "HERE gives a value to a location", None)
        else:
            self.problems.error(
                WRONG_TYPE,
                "HERE takes the name of a location",
                last.start,
                last.end,
                notes=("VAL-II says *Illegal assignment*",),
                help=("write `HERE part`, or `HERE frame:part`",),
            )

    def _simple(self, node: Simple) -> None:
        word, operands = node.word, node.operands
        if word in _LOCATION_WORDS:
            first, *rest = operands
            if isinstance(first, Number) and rest and isinstance(rest[0], Name):
                self._swapped(node, first, rest[0])
            elif first is not None:
                self._location(first, f"{word} goes to a location")
            self._items(tuple(rest), Type.REAL)
        elif word == "TOOL":
            for operand in operands:
                if operand is not None:
                    self.check(operand, Type.POSE, "TOOL takes a location")
        elif word in _TEXT_WORDS:
            self._items(operands, Type.STRING)
        elif word == "TYPE":
            self.items_of_type(operands)
        else:
            self._items(operands, Type.REAL)
            if word == "BASE" and len(operands) > 4:
                self.problems.error(
                    FUNCTION_ARGUMENTS,
                    f"BASE takes at most 4 operands, {len(operands)} given",
                    node.start,
                    node.end,
                    help=("write `BASE dx, dy, dz, rotation`",),
                )

    def _swapped(self, node: Simple, distance: Number, location: Name) -> None:
        """`APPRO 50, part`."""
        text = self.problems.source.text[distance.start : distance.end]
        self.wrong_lines.add(self.problems.source.line_of(node.start))
        self.problems.error(
            WRONG_TYPE,
            f"the location comes first in {node.word}",
            distance.start,
            location.end,
            notes=(TYPES_SAY,),
            help=(f"write `{node.word} {location.text}, {text}`",),
            fix=self.problems.replace(distance.start, location.end, f"{location.text}, {text}"),
        )

    def _location(self, node: Item, why: str) -> None:
        self.check(node, Type.POSE, why, joints=True)

    def _call(self, program: Name, arguments: tuple[Item | None, ...]) -> None:
        callee = key(program.text)
        for i, argument in enumerate(arguments):
            if isinstance(argument, Element) and not argument.subscripts:
                entry = self._use(argument.name, None)
                self._once(entry, argument.name, array=True)
                entry.passed.append(Passed(callee, i, True))
            elif isinstance(argument, Name | Element):
                name = argument if isinstance(argument, Name) else argument.name
                self._type(argument, None)
                lower = name.text.lower()
                if lower not in CONSTANTS and not (lower in FUNCTIONS and FUNCTIONS[lower].bare):
                    entry = self.scope.entry(self.program, key(name.text))
                    entry.passed.append(Passed(callee, i, False))
                    entry.reads.pop()
            elif argument is not None:
                self.argument_types[id(argument)] = self._type(argument, None)
