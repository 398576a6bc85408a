"""Types of the arguments of functions, and of the items that TYPE and $ENCODE write."""

import re
from collections.abc import Collection
from typing import TypeAlias

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.dialect import Angles
from vrts.lang.meaning import type_mistakes
from vrts.lang.meaning.forms import is_text, with_start
from vrts.lang.meaning.functions import arguments, unknown
from vrts.lang.meaning.instead import formats
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.meaning.type_mistakes import IN_WORDS
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
    Text,
)
from vrts.lang.vocabulary.functions import Signature, has_more_axes
from vrts.lang.vocabulary.lookup import hardly_a_name

FORMAT = re.compile(r"/[DFIGEHOCXUBSJKLN](\d{0,3}(\.\d{1,2})?)?", re.IGNORECASE)
_OF_ARRAYS = frozenset({"last", "$unpack"})  # functions that a whole array is given to
_SWAPS = frozenset({"tas", "cas"})  # functions that give their variable a value
_CODES = {"r": Type.REAL, "s": Type.STRING, "p": Type.POSE, "l": Type.POSE, "$": Type.STRING}
_LOOKED_INTO = frozenset(  # functions whose arguments matter
    {
        "sig",
        "bits",
        "timer",
        "sqrt",
        "sin",
        "cos",
        "tan",
        "trans",
        "#ppoint",
        "rx",
        "ry",
        "rz",
        "shift",
    }
)

Wanted: TypeAlias = Type | None  # None: any type; POSE also takes joints where `joints` is True


class ApplicationTypes(NameUses):
    """Checks functions with their arguments."""

    def check(self, node: Item, wanted: Wanted, why: str, *, joints: bool = False) -> Type:
        """Return the type of an expression, and report it where it is not the one wanted."""
        raise NotImplementedError

    def _application(self, node: Application, wanted: Wanted) -> Type:
        lower = node.name.text.lower()
        signature = self.functions.get(lower)
        if lower == "ppoint" and self.dialect.has("12") and not self.dialect.tolerant:
            unknown.joints_without_sign(self.problems, node)
            self._loose(node)
            return Type.DYNAMIC
        if signature is None:
            known, programs = self.functions, self.scope.programs
            place = wanted is Type.POSE
            unknown.unknown_function(self.problems, node, known, programs, is_place=place)
            self._loose(node)
            self.wrong_lines.add(self.problems.source.line_of(node.start))
            return Type.DYNAMIC
        if lower == "instr":
            node = node._replace(arguments=with_start(node.arguments))
        of_axes = self.dialect.is_as and has_more_axes(lower, len(node.arguments))
        if signature.opaque or of_axes:
            self.warn_not_simulated(node.name.text.upper(), node.name.start, node.name.end)
            if of_axes or self._count(node, signature):
                named = signature.parameters[:1] == ("n",)  # a word of the controller
                for argument in node.arguments[named:]:
                    self.loosely(argument)
        elif signature.parameters and signature.parameters[0][0] == "v":
            self._defined(node, signature)
        elif signature.parameters and signature.parameters[0][0] == "n":
            self._named(node, signature)
        elif signature.name == "$encode":
            self.items_of_type(node.arguments, writes=False)
            self._count(node, signature)
        elif self._count(node, signature):
            if arguments.number_of_text(self.problems, node):
                self._loose(node)
                return signature.result
            if lower in _LOOKED_INTO:
                self.asked.append(Asked(self.program, self.step, node))
            for i, argument in enumerate(node.arguments):
                code = signature.parameters[min(i, len(signature.parameters) - 1)]
                if code[0] == "$" and argument is not None:
                    self._changed(argument, node)
                if argument is not None and not (code[0] == "r" and isinstance(argument, Number)):
                    why = f"{node.name.text.upper()} takes {_taken(code)} here"
                    self.check(argument, _CODES[code[0]], why, joints=code[0] == "l")
            if signature.name == "trans" and self.dialect.angles is Angles.OAT:
                arguments.default_angles(self.problems, node)
        return signature.result

    def loosely(self, node: Item | None) -> None:
        """Check an operand of any type; a variable may be given a value, so all is right of it."""
        if isinstance(node, Element):
            self._items(node.subscripts, Type.REAL)
            node = node.name
        if isinstance(node, Name):
            if hardly_a_name(node.text, self.dialect):
                self._use(node, None).reads.append((node.start, node.end))
            else:
                self.bad_names.add(key(node.text))
        elif node is not None and not isinstance(node, FormatItem):
            self.check(node, None, "")

    def _count(self, node: Application, signature: Signature) -> bool:
        fits = arguments.arguments_fit(self.problems, node, signature)
        if not fits:
            self._loose(node)
        return fits

    def _defined(self, node: Application, signature: Signature) -> None:
        if not node.arguments or node.arguments[0] is None:
            self._count(node._replace(arguments=()), signature)
            return
        first = node.arguments[0]
        if not isinstance(first, Name | Element) or not self._count(node, signature):
            arguments.no_variable(self.problems, node, first)
            return
        name = first if isinstance(first, Name) else first.name
        entry = self._use(name, Type.REAL if signature.name in _SWAPS else None)
        entry.asked = True
        if signature.name in _SWAPS:
            entry.writes.append((name.start, name.end))
        whole_array = signature.name in _OF_ARRAYS
        if isinstance(first, Element):
            self._once(entry, name, array=True)
            self._items(first.subscripts, Type.REAL)
        else:
            self._once(entry, name, array=whole_array)
        for argument in node.arguments[1:]:
            if argument is not None:
                self.check(argument, Type.REAL, f"{node.name.text.upper()} takes numbers here")

    def _named(self, node: Application, signature: Signature) -> None:
        """SWITCH and PARAMETER take the name of something of the controller."""
        if self.dialect.is_as and signature.name == "switch" and len(node.arguments) == 2:
            robot = node.arguments[1]
            if robot is not None:
                self.check(robot, Type.REAL, "the number of a robot belongs here")
            node = node._replace(arguments=node.arguments[:1])  # `SWITCH(CS, 2)`
        if not self._count(node, signature):
            return
        first = node.arguments[0]
        assert first is not None
        table = SWITCHES if signature.name == "switch" else PARAMETERS
        self.system_name(first, table.keys(), signature.name)
        for argument in node.arguments[1:]:
            if argument is not None:
                self.check(argument, Type.REAL, "an index is a number")

    def system_name(self, node: Item, known: Collection[str], what: str) -> str | None:
        """Return the name of a switch or parameter in upper case; report one that is unknown."""
        name = node.name if isinstance(node, Element) else node
        text = name.text.upper() if isinstance(name, Name) else ""
        if text in known or (text and self.dialect.tolerant):
            return text
        type_mistakes.unknown_system_name(self.problems, node, text, known, what)
        return None

    def _changed(self, argument: Item, node: Application) -> None:
        """$DECODE takes what it returns from its variable."""
        name = argument.name if isinstance(argument, Element) else argument
        if isinstance(name, Name) and name.text[0] == "$":
            entry = self.scope.entry(self.program, key(name.text))
            entry.values.append(Text("", 0, 0))
            return
        arguments.no_string_variable(self.problems, node, argument)

    def items_of_type(self, items: tuple[Item | None, ...], *, writes: bool = True) -> None:
        """Check the items of TYPE, and of $ENCODE, which writes nothing."""
        for item in items:
            if isinstance(item, FormatItem):
                if FORMAT.fullmatch(item.text) is None:
                    formats.unknown_format(self.problems, item)
            elif isinstance(item, Infix) and item.operator == ":" and _is_width(item.right):
                formats.pascal_format(self.problems, item)
            elif item is not None:
                kind = Type.STRING if is_text(item) else Type.REAL
                self.item_of_type = item if writes and kind is Type.STRING else None
                self.check(item, kind, "TYPE writes numbers and strings")
        self.item_of_type = None

    def _items(self, items: tuple[Item | None, ...], wanted: Type) -> None:
        for item in items:
            if item is not None:
                self.check(item, wanted, f"{IN_WORDS[wanted]} belongs here")


def _is_width(node: Expression) -> bool:
    """Whether this is a number that may tell how wide another is written."""
    return isinstance(node, Number) and node.value == round(node.value)


def _taken(code: str) -> str:
    return IN_WORDS[_CODES[code[0]]]
