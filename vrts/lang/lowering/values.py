"""Expressions to the IR."""

from vrts.base.made import made
from vrts.base.numbers import single
from vrts.base.source import SourceFile, Span
from vrts.ir import expressions as x
from vrts.ir.values import Type
from vrts.lang.dialect import Angles
from vrts.lang.joined import Joined, span_in
from vrts.lang.meaning.forms import with_start
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.meaning.scope import Scope, location_name
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
    Variable,
)
from vrts.lang.vocabulary.functions import CONSTANTS, Signature, has_more_axes

_BINARY = {operator.value.upper(): operator for operator in x.BinaryOperator}
_NO_TURN = (90.0, -90.0, 0.0)  # O, A, T of TRANS without angles [manual language/locations#trans]


class ValueLowering:
    """Lowers the expressions of one program."""

    def __init__(self, source: SourceFile, scope: Scope, types: NameUses, program: str) -> None:
        self.source = source
        self.joined = isinstance(source, Joined)
        self.scope = scope
        self.dialect = types.dialect
        self.functions = types.functions
        self.bare_functions = types.bare_functions
        self.composing = types.composing
        self.located = types.located
        self.program_name = program
        self.variables: dict[str, x.Variable] = {}  # by names as written
        self.plain: dict[str, x.Variable] = {}  # those that are no constants and no functions

    def _span(self, node: Item) -> Span:
        if self.joined:
            return span_in(self.source, node.start, node.end)
        return made(Span, (self.source, node.start, node.end))

    def variable(self, name: Name) -> x.Variable:
        """Return the variable of a name as the program sees it."""
        known = self.variables.get(name.text)
        if known is not None:
            return known
        entry = self.scope.entry(self.program_name, key(name.text))
        if entry.both and entry.slot is None:
            located = name.start in self.located
            return x.Global(
                location_name(entry.name) if located else entry.name,
                Type.POSE if located else Type.REAL,
            )
        found: x.Variable = x.Global(entry.stored or entry.name, entry.type)
        if entry.slot is not None:
            found = x.Slot(entry.slot, entry.name, entry.type)
        self.variables[name.text] = found
        return found

    def place(self, node: Variable) -> x.Place:
        """Return what a name or element stands for when assigned."""
        if isinstance(node, Name):
            return made(x.Place, (self.variable(node), (), self._span(node)))
        subscripts = tuple(
            self.value(s) if s is not None else x.Constant(0.0) for s in node.subscripts
        )
        return x.Place(self.variable(node.name), subscripts, self._span(node))

    def value(self, node: Item) -> x.Expression:
        """Return an expression."""
        if isinstance(node, Name):
            variable = self.plain.get(node.text)
            if variable is None:
                return self._name(node)
            return made(x.Load, (made(x.Place, (variable, (), self._span(node))),))
        if isinstance(node, (Number, Text)):
            return made(x.Constant, (node.value, self._span(node)))
        if isinstance(node, Infix):
            return self._infix(node)
        span = self._span(node)
        match node:
            case Parenthesised(inner):
                return self.value(inner)
            case Element():
                return x.Load(self.place(node))
            case Prefix("-", operand) if node.start in self.composing:
                return x.Apply(x.Function.INVERSE, (self.value(operand),), span)
            case Prefix(operator, operand):
                if operator == "+":
                    return self.value(operand)
                return x.Unary(x.UnaryOperator(operator.lower()), self.value(operand), span)
            case Application():
                return self._application(node, span)
            case FormatItem():
                raise AssertionError("a format is no expression")

    def _optional(self, node: Item | None) -> x.Expression | None:
        return None if node is None else self.value(node)

    def _infix(self, node: Infix) -> x.Expression:
        left, right = self.value(node.left), self.value(node.right)
        if node.operator != ":" and node.operator_start not in self.composing:
            operator = _BINARY[node.operator]
            return made(x.Binary, (operator, left, right, self._span(node)))
        span = self._span(node)
        if node.operator == "-":
            right = x.Apply(x.Function.INVERSE, (right,), span)
        parts = left.parts if isinstance(left, x.Compose) else (left,)
        return x.Compose((*parts, right), span)

    def _name(self, node: Name) -> x.Expression:
        lower, span = node.text.lower(), self._span(node)
        if lower in CONSTANTS:
            return x.Constant(single(CONSTANTS[lower]), span)
        signature = self.bare_functions.get(lower)
        if signature is not None:
            value = x.Apply(signature.function, _named(signature), span)
            if signature.function is x.Function.BASE and self.dialect.is_as:
                return x.Apply(x.Function.INVERSE, (value,), span)  # the opposite sense
            return value
        place = self.place(node)
        if node.text in self.variables:
            self.plain[node.text] = place.variable
        return x.Load(place)

    def _application(self, node: Application, span: Span) -> x.Expression:
        signature = self.functions[node.name.text.lower()]
        function = signature.function
        given = node.arguments
        arguments: tuple[x.Argument, ...]
        if self.dialect.is_as and has_more_axes(signature.name, len(given)):
            return x.Apply(x.Function.OPAQUE, (x.Constant(signature.name.upper()),), span)
        match function:
            case x.Function.TRANS if self.dialect.angles is Angles.ZYZ:
                function = x.Function.TRANS_ZYZ
                arguments = self._filled(given, (0.0,) * 6)
            case x.Function.TRANS:
                arguments = self._trans(given)
            case x.Function.SHIFT:
                pose = given[0]
                assert pose is not None
                arguments = (self.value(pose), *self._three(given[1:]))
            case x.Function.PPOINT:
                arguments = self._filled(given, (0.0,) * 6)
            case (
                x.Function.DEFINED
                | x.Function.LAST
                | x.Function.TAS
                | x.Function.CAS
                | x.Function.UNPACK
            ):
                first = given[0]
                assert isinstance(first, Name | Element)
                rest = (self._optional(a) for a in given[1:])
                arguments = (self._variable_argument(first), *rest)
            case x.Function.SWITCH | x.Function.PARAMETER:
                name, index = _name_and_index(given[0])
                more = (index, *given[1:]) if index is not None else given[1:]
                arguments = (x.Constant(name), *(self._optional(a) for a in more))
            case x.Function.ENCODE:
                arguments = self.written(given)
            case x.Function.INSTR:  # the start comes first
                start, *texts = with_start(given)
                arguments = tuple(self._optional(a) for a in (*texts, start))
            case x.Function.MID if signature.name == "$left":
                text, count = map(self._optional, given)
                arguments = (text, x.Constant(1.0), count)
            case x.Function.OPAQUE:
                arguments = _named(signature)
            case _:
                arguments = tuple(self._optional(a) for a in given)
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

    def written(self, items: tuple[Item | None, ...]) -> tuple[x.Expression | x.Format, ...]:
        """Return the items of TYPE and $ENCODE."""
        return tuple(
            format_of(item.text) if isinstance(item, FormatItem) else self.value(item)
            for item in items
            if item is not None and not (isinstance(item, FormatItem) and item.text[1] in "Nn")
        )

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


def format_of(text: str) -> x.Format:
    """Return a format control as written, `/F8.2`."""
    width, _, decimals = text[2:].partition(".")
    return x.Format(
        x.FormatKind(text[1].upper()),
        int(width) if width else None,
        int(decimals) if decimals else None,
    )


def _named(signature: Signature) -> tuple[x.Expression, ...]:
    """Return the argument of a function that is never carried out: its name."""
    if not signature.opaque:
        return ()
    return (x.Constant(signature.name.upper()),)


def _name_and_index(node: Item | None) -> tuple[str, Item | None]:
    """Return the name of a switch or parameter in upper case, and its index in brackets."""
    if isinstance(node, Element):
        return node.name.text.upper(), node.subscripts[0] if node.subscripts else None
    assert isinstance(node, Name)
    return node.text.upper(), None
