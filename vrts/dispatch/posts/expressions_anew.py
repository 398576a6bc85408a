"""Expressions of a program written anew: names, functions, angles, and joints of another arm."""

import re
from collections.abc import Callable
from typing import ClassVar, NamedTuple

from vrts.base.oat import components, plain_angles
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.dispatch.posts.other_arm import SAME, OtherArm
from vrts.ir.values import Type
from vrts.lang.compiler import Resolved
from vrts.lang.dialect import Angles, Dialect, Precedence
from vrts.lang.grammar.operators import TABLE_A, TABLE_B
from vrts.lang.names import key
from vrts.lang.syntax import expressions, statements
from vrts.lang.syntax.program import Formal
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions, bare_functions
from vrts.lang.vocabulary.lookup import reserved_words

# from O, A, T to yaw, pitch, roll [manual language/locations#yaw-pitch-roll]
OFFSETS = (-90.0, 90.0, 0.0)
TIGHTEST = 100  # as an operand, an expression that needs no parentheses
_FIRST_ANGLE = 3  # of the arguments of TRANS
_PLAIN_NUMBER = re.compile(r"[\d.]+(?:[eE][+-]?\d+)?", re.ASCII)


class CannotWrite(Exception):  # noqa: N818 -- names the situation
    """The language has nothing that means the same as a part of a program."""

    def __init__(self, start: int, end: int, headline: str, remedy: str) -> None:
        """Keep the place in the source, what is missing, and what helps."""
        super().__init__(headline)
        self.start, self.end, self.headline, self.remedy = start, end, headline, remedy


class Start(NamedTuple):
    """With which frames the program begins that is executed."""

    program: str
    X_FT: Pose  # the tool; the base is the robot's own


class Settled(NamedTuple):
    """What a post asks about the robot."""

    ready_deg: tuple[float, ...]  # joints of READY
    start: Start | None = None  # None: frames are not set where the program begins
    arm: OtherArm | None = SAME  # that the text is for; None: nobody knows how it counts its joints


class Expressions:
    """Writes the expressions of resolved programs in another language."""

    dialect: ClassVar[Dialect]
    FUNCTIONS: ClassVar[dict[str, str]] = {}  # function, lower case: how it is spelt here
    LACKS_FUNCTIONS: ClassVar[frozenset[str]] = frozenset()

    def __init__(self, found: Resolved, settled: Settled) -> None:
        """Write programs of one source."""
        self.found = found
        self.settled = settled
        self.source = found.resolver.problems.source
        self.origin = found.resolver.dialect
        self.program = ""  # the one being written
        self.left_out: list[tuple[int, int, str]] = []  # ranges, and the words
        self._table = TABLE_B if self.dialect.precedence is Precedence.B else TABLE_A
        theirs = reserved_words(self.origin)
        self._reserved = reserved_words(self.dialect) - theirs
        own = applied_functions(self.dialect).keys() | bare_functions(self.dialect).keys()
        self._known = own | CONSTANTS.keys()
        self._functions = applied_functions(self.origin).keys() | bare_functions(self.origin).keys()

    def mapped(self, node: statements.Statement | expressions.Item | Span) -> OtherArm:
        """Return how the other arm counts its joints.

        Raises:
            CannotWrite: Nobody said so.
        """
        if self.settled.arm is None:
            headline = "how the other arm counts its joints is not known"
            remedy = "describe it and give the file to `--arm`; `--arm same` when it is the same"
            raise CannotWrite(node.start, node.end, headline, remedy)
        return self.settled.arm

    def _apply_ppoint(self, node: expressions.Application) -> str:
        arm = self.mapped(node)
        if arm.counts_alike:
            return f"{self.function(node.name)}({self.arguments(node)})"
        given = (*node.arguments, *(None for _ in range(6)))[:6]
        each = zip(arm.order, arm.sign, arm.zero_deg, strict=True)
        joints = [self.turned(given[k - 1], sign, zero) for k, sign, zero in each]
        return f"{self.function(node.name)}({', '.join(joints)})"

    def turned(self, item: expressions.Item | None, sign: int, zero: float) -> str:
        """Return `sign * item + zero`."""
        value = 0.0 if item is None else constant(item)
        if value is not None:
            return f"{sign * value + zero + 0.0:.9g}"
        assert item is not None
        if sign > 0:
            return self.shifted(item, zero)
        assert not isinstance(item, expressions.FormatItem)
        turned = f"-{self.operand(item, TIGHTEST)}"
        return f"{zero:.9g} {turned[0]} {turned[1:]}" if zero else turned

    def text(self, node: statements.Statement | expressions.Item) -> str:
        """Return a part of a program as it stands."""
        return self.source.text[node.start : node.end]

    def pose(self, pose: Pose) -> str:
        """Return a pose that is known, in the angles of this language."""
        x, y, z, *angles = components(pose)
        if self.dialect.angles is Angles.ZYZ:
            angles = list(plain_angles(*angles))
        return f"TRANS({', '.join(f'{round(value, 6) + 0.0:.9g}' for value in (x, y, z, *angles))})"

    def expression(self, node: expressions.Item) -> str:
        """Return an expression in this language."""
        match node:
            case expressions.Number():
                return self.number(node)
            case expressions.Text() | expressions.FormatItem():
                return self.text(node)
            case expressions.Name():
                return self.variable(node)
            case expressions.Element(name, subscripts):
                return f"{self.variable(name)}[{self.listed(subscripts)}]"
            case expressions.Application():
                return self.application(node)
            case expressions.Parenthesised(inner):
                return f"({self.expression(inner)})"
            case expressions.Prefix(operator, operand):
                blank = " " if operator.isalpha() else ""
                return f"{operator}{blank}{self.operand(operand, TIGHTEST)}"
            case expressions.Infix():
                return self.infix(node)

    def infix(self, node: expressions.Infix) -> str:
        """Return two operands and what stands between them."""
        level = self._table[node.operator]
        left = self.operand(node.left, level)
        right = self.operand(node.right, level + 1)
        tight = node.operator in (":", "**", "*", "/")
        return f"{left}{node.operator}{right}" if tight else f"{left} {node.operator} {right}"

    def operand(self, node: expressions.Expression, level: int) -> str:
        """Return an operand, in parentheses where it binds less than a level of the table."""
        text = self.expression(node)
        own = self._table[node.operator] if isinstance(node, expressions.Infix) else TIGHTEST
        return f"({text})" if own < level else text

    def number(self, node: expressions.Number) -> str:
        """Return a number as written, or in decimals what is octal or hexadecimal."""
        text = self.text(node)
        return text if _PLAIN_NUMBER.fullmatch(text) else f"{node.value:.9g}"

    def variable(self, node: expressions.Name) -> str:
        """Return a name; one that is a word of this language only is refused."""
        name = key(node.text)
        if name in CONSTANTS or name in self._functions:
            return self.function(node)
        if name.upper() in self._reserved:
            title = self.dialect.title
            raise CannotWrite(
                node.start,
                node.end,
                f"`{name}` is a word of {title}",
                "give the variable another name",
            )
        return name

    def formal(self, formal: Formal) -> str:
        """Return a formal argument as the header of its program has it."""
        return f"{formal.name.text.lower()}{'[]' if formal.array else ''}"

    def function(self, node: expressions.Name) -> str:
        """Return the name of a function or constant."""
        name = node.text.lower()
        spelt = self.FUNCTIONS.get(name, name.upper())
        if name in self.LACKS_FUNCTIONS or spelt.lower() not in self._known:
            headline = f"{self.dialect.title} has nothing that means {name.upper()}"
            raise CannotWrite(node.start, node.end, headline, "work the value out in another way")
        return spelt

    def application(self, node: expressions.Application) -> str:
        """Return a function with its arguments."""
        name = node.name.text.lower()
        own: Callable[[expressions.Application], str] | None = getattr(
            self, f"_apply_{name.lstrip('$#')}", None
        )
        if own is not None:
            return own(node)
        return f"{self.function(node.name)}({self.arguments(node)})"

    def arguments(self, node: expressions.Application) -> str:
        """Return what stands between the parentheses of a function."""
        if node.by is None:
            return self.listed(node.arguments)
        before, behind = node.arguments[: node.by], node.arguments[node.by :]
        return f"{self.listed(before)} BY {self.listed(behind)}"

    def listed(self, items: tuple[expressions.Item | None, ...]) -> str:
        """Return items between commas; what is left out stays left out."""
        return ", ".join("" if item is None else self.expression(item) for item in items)

    def _apply_trans(self, node: expressions.Application) -> str:
        """TRANS, its angles turned into those of this language."""
        given = node.arguments
        if self.dialect.angles is self.origin.angles or not any(given[_FIRST_ANGLE:]):
            return f"TRANS({self.listed(given)})"
        sign = 1.0 if self.dialect.angles is Angles.ZYZ else -1.0
        padded = (*given, *(None for _ in range(6)))[:6]
        lengths = [self.listed((item,)) for item in padded[:_FIRST_ANGLE]]
        angles = [
            self.shifted(item, sign * offset)
            for item, offset in zip(padded[_FIRST_ANGLE:], OFFSETS, strict=True)
        ]
        return f"TRANS({', '.join((*lengths, *angles))})"

    def shifted(self, item: expressions.Item | None, offset: float) -> str:
        """Return a number, or what is left out and means 0, with a constant added."""
        value = 0.0 if item is None else constant(item)
        if value is not None:
            return f"{value + offset:.9g}"
        assert item is not None
        assert not isinstance(item, expressions.FormatItem)
        if offset == 0.0:
            return self.expression(item)
        sign = "+" if offset > 0.0 else "-"
        return f"{self.operand(item, self._table['+'])} {sign} {abs(offset):g}"

    def type_of(self, node: expressions.Item | None) -> Type | None:
        """Return the type of a name or element in the program being written."""
        if isinstance(node, expressions.Element):
            node = node.name
        if not isinstance(node, expressions.Name):
            return None
        return self.found.resolver.scope.entry(self.program, key(node.text)).type


def constant(item: expressions.Item) -> float | None:
    """Return the value of a number, with its sign."""
    match item:
        case expressions.Number(value):
            return value
        case expressions.Prefix("-", expressions.Number(value)):
            return -value
        case _:
            return None
