"""Types of expressions and uses of names.

The walk records how every unprefixed name is used and checks every other type; conflicts between
uses are reported afterwards (usage.py), once a name, with both places.
"""

import re
from collections.abc import Collection
from typing import TypeAlias

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.dialect import Angles
from vrts.lang.grammar.build import PRECEDENCE
from vrts.lang.meaning import type_mistakes
from vrts.lang.meaning.forms import is_text, with_start
from vrts.lang.meaning.functions import arguments, unknown
from vrts.lang.meaning.instead.inputs_by_index import asked_as_string
from vrts.lang.meaning.name_uses import Asked, NameUses, NoText
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import IN_WORDS, MAX_SUBSCRIPTS
from vrts.lang.names import key
from vrts.lang.steps.advising.adviser import OTHER_LANGUAGE
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
    Prefix,
    Text,
    Variable,
)
from vrts.lang.vocabulary.functions import CONSTANTS, Signature, has_more_axes
from vrts.lang.vocabulary.lookup import hardly_a_name, instructions_of

FORMAT = re.compile(r"/[DFIGEHOCXUBSJKLN](\d{0,3}(\.\d{1,2})?)?", re.IGNORECASE)
_OF_ARRAYS = frozenset({"last", "$unpack"})  # functions that a whole array is given to
_SWAPS = frozenset({"tas", "cas"})  # functions that give their variable a value

Wanted: TypeAlias = Type | None  # None: any type; POSE also takes joints where `joints` is True
_CODES = {"r": Type.REAL, "s": Type.STRING, "p": Type.POSE, "l": Type.POSE, "$": Type.STRING}
_DIVISIONS = frozenset({"/", "MOD"})  # operators whose right operand matters
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
_COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})


class ExpressionTypes(NameUses):
    """Checks the expressions of one program after the other."""

    def check(self, node: Item, wanted: Wanted, why: str, *, joints: bool = False) -> Type:
        """Return the type of an expression, and report it where it is not the one wanted."""
        before = len(self.no_texts)
        if isinstance(node, Number):
            found = Type.REAL
        elif isinstance(node, Name):
            found = self._name(node, wanted)
        else:
            found = self._type(node, wanted)
        if wanted is Type.STRING and len(self.no_texts) > before:
            self._explain_no_texts(before, why)
        if found is wanted or wanted is None or found is Type.DYNAMIC:
            return found
        if joints and wanted is Type.POSE and found is Type.JOINTS:
            return found
        if not isinstance(node, FormatItem):
            self._wrong(node, found, wanted, why)
        return Type.DYNAMIC

    def _type(self, node: Item, wanted: Wanted) -> Type:
        if isinstance(node, Name):
            return self._name(node, wanted)
        if isinstance(node, Number):
            return Type.REAL
        if isinstance(node, Infix):
            return self._infix(node, wanted)
        match node:
            case Text():
                return Type.STRING
            case Element(name, subscripts):
                return self._element(node, name, subscripts, wanted)
            case Parenthesised(inner):
                return self._type(inner, wanted)
            case Prefix("-", operand) if self.dialect.is_as and self._locations(wanted, operand):
                self.composing.add(node.start)
                self.check(operand, Type.POSE, "`-` inverts a location")
                return Type.POSE
            case Prefix(operator, operand):
                self.check(operand, Type.REAL, f"`{operator}` takes a number")
                return Type.REAL
            case Application():
                return self._application(node, wanted)
            case FormatItem():
                type_mistakes.format_here(self.problems, node)
                return Type.DYNAMIC

    def _infix(self, node: Infix, wanted: Wanted) -> Type:
        operator = node.operator
        if operator == ":":
            if self.dialect.is_as:
                type_mistakes.joined_by_colon(self.problems, node)
            for part in (node.left, node.right):
                self.check(part, Type.POSE, "`:` joins locations")
                if isinstance(part, Name) and part.text[0] == "#":  # all is said of `rack` with it
                    self.bad_names.add(key(part.text)[1:])
            self._part(node.right)
            return Type.POSE
        if operator in "+-" and self.dialect.is_as and self._locations(wanted, node.left):
            self.composing.add(node.operator_start)
            for part in (node.left, node.right):
                self.check(part, Type.POSE, f"`{operator}` joins locations")
            self._part(node.right)
            return Type.POSE
        if operator == "+":
            return self._sum(node, wanted)
        if operator in _COMPARISONS:
            text = is_text(node.left) or is_text(node.right)
            if text and any(self._krl_input(part) for part in (node.left, node.right)):
                return Type.REAL
            kind = Type.STRING if text else Type.REAL
            why = f"`{operator}` takes two strings or two numbers"
            self.asked.append(Asked(self.program, self.step, node))
            self.check(node.left, kind, why)
            self.check(node.right, kind, why)
            return Type.REAL
        if is_text(node.left) and is_text(node.right):
            for part in (node.left, node.right):
                self.check(part, Type.STRING, "")
            type_mistakes.computed_strings(self.problems, node)
            self._only_this(node)
            return Type.DYNAMIC
        before = len(self.problems.found)
        if operator in ("AND", "OR"):
            self.asked.append(Asked(self.program, self.step, node))
        for part in (node.left, node.right):
            self.check(part, Type.REAL, f"`{operator}` takes numbers")
        if len(self.problems.found) > before:
            return Type.DYNAMIC  # said there
        if operator in _DIVISIONS and not (isinstance(node.right, Number) and node.right.value):
            self.asked.append(Asked(self.program, self.step, node))
        return Type.REAL

    def _krl_input(self, node: Expression) -> bool:
        """Report `$IN[3]` where a signal is asked for."""
        if not asked_as_string(self.problems, OTHER_LANGUAGE, node):
            return False
        self._only_this(node)
        return True

    def _only_this(self, node: Expression) -> None:
        """Say of a line nothing more, nor how it is read: mended it is another."""
        problems = self.problems
        line = problems.source.line_of(node.start)
        self.wrong_lines.add(line)
        problems.found[:] = [
            d
            for d in problems.found
            if d.rule is not PRECEDENCE or d.primary is None or d.primary.span.line != line
        ]

    def _part(self, node: Expression) -> None:
        """Note a location that is given within another one."""
        name = node.name if isinstance(node, Element) else node
        if isinstance(name, Name):
            self.parts.add(key(name.text))

    def _sum(self, node: Infix, wanted: Wanted) -> Type:
        """`a + b + c`: all numbers or all strings. Looked at from the left, each operand once."""
        operands = [node.right]
        left = node.left
        while isinstance(left, Infix) and left.operator == "+":
            operands.append(left.right)
            left = left.left
        operands.append(left)
        text = any(is_text(operand) for operand in operands)
        if wanted is Type.POSE and not text:
            self._type(node.left, Type.POSE)
            self._type(node.right, Type.POSE)
            type_mistakes.added_locations(self.problems, node)
            return Type.DYNAMIC
        kind = Type.STRING if text else Type.REAL
        for operand in reversed(operands):
            self.check(operand, kind, "`+` takes two strings or two numbers")
        return kind

    def _locations(self, wanted: Wanted, node: Expression) -> bool:
        """Return whether `+` and `-` before or after an operand join locations in AS."""
        return wanted is Type.POSE or (wanted is None and self.is_location(node))

    def _name(self, node: Name, wanted: Wanted) -> Type:
        if node.text not in self.variables:
            lower = node.text.lower()
            if lower in CONSTANTS:
                return Type.REAL
            signature = self.bare_functions.get(lower)
            if signature is not None:
                if signature.opaque:
                    self.warn_not_simulated(node.text.upper(), node.start, node.end)
                return signature.result
            self.variables.add(node.text)
        entry = self._use(node, wanted)
        place = (node.start, node.end)
        entry.reads.append(place)
        if entry.scalar is None:
            entry.scalar = place
        if wanted is not Type.STRING and node.text[0] not in "$#":
            return wanted or Type.DYNAMIC
        return self._as_used(node, node, wanted)

    def _element(
        self, node: Element, name: Name, subscripts: tuple[Item | None, ...], wanted: Wanted
    ) -> Type:
        if name.text[0] == "$" and len(subscripts) == 1 and _is_slice(subscripts[0]):
            type_mistakes.slice_of_string(self.problems, node)
            self.wrong_lines.add(self.problems.source.line_of(node.start))
            return Type.STRING
        entry = self._use(name, wanted)
        entry.reads.append((node.start, node.end))
        self._subscripts(entry, node, subscripts)
        if not 0 < len(subscripts) <= MAX_SUBSCRIPTS:
            return wanted or Type.DYNAMIC  # said there
        return self._as_used(name, node, wanted)

    def _subscripts(self, entry: Entry, node: Element, subscripts: tuple[Item | None, ...]) -> None:
        self._once(entry, node.name, array=True)
        if subscripts and isinstance(subscripts[0], Prefix):
            self.asked.append(Asked(self.program, self.step, node))
        if not 0 < len(subscripts) <= MAX_SUBSCRIPTS:
            type_mistakes.wrong_subscripts(self.problems, node)
            self.wrong_lines.add(self.problems.source.line_of(node.start))
            if len(subscripts) > MAX_SUBSCRIPTS:
                self.bad_names.add(key(node.name.text))  # hardly one of the program
        self._items(subscripts, Type.REAL)

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
                    type_mistakes.unknown_format(self.problems, item)
            elif isinstance(item, Infix) and item.operator == ":" and _is_width(item.right):
                type_mistakes.pascal_format(self.problems, item)
            elif item is not None:
                kind = Type.STRING if is_text(item) else Type.REAL
                self.item_of_type = item if writes and kind is Type.STRING else None
                self.check(item, kind, "TYPE writes numbers and strings")
        self.item_of_type = None

    def _items(self, items: tuple[Item | None, ...], wanted: Type) -> None:
        for item in items:
            if item is not None:
                self.check(item, wanted, f"{IN_WORDS[wanted]} belongs here")

    def _write(self, target: Variable, kind: Type, why: str, value: Expression | None) -> None:
        name = target if isinstance(target, Name) else target.name
        if name.text.lower() in self.predefined:
            type_mistakes.predefined_name(self.problems, name, instructions_of(self.dialect))
            return
        if self.dialect.is_as and hardly_a_name(name.text, self.dialect):
            type_mistakes.reserved_name(self.problems, name)
            return
        sigil = {"$": Type.STRING, "#": Type.JOINTS}.get(name.text[0])
        location = kind is Type.POSE and sigil is Type.JOINTS
        if sigil is not None and sigil is not kind and not location:
            self._wrong(target, sigil, kind, why)
            return
        entry = self._use(name, None if sigil else kind)
        entry.writes.append((name.start, name.end))
        entry.given.setdefault(kind, (name.start, name.end))
        entry.written_in.add(self.program)
        if value is not None and isinstance(target, Name):
            entry.values.append(value)
        elif isinstance(target, Name):
            entry.values.append(Text("", 0, 0))  # changes in ways not followed
            entry.changed = True
        if isinstance(target, Element):
            self._subscripts(entry, target, target.subscripts)
        else:
            self._once(entry, name, array=False)

    def _wrong(self, node: Expression, found: Type, wanted: Type, why: str) -> None:
        if found is Type.STRING and wanted is Type.REAL and self._krl_input(node):
            return
        self.wrong_lines.add(self.problems.source.line_of(node.start))
        if wanted is Type.STRING and found is Type.REAL and not isinstance(node, Variable):
            self.no_texts.append(NoText(None, node, self.program, why, self.item_of_type))
            return
        type_mistakes.wrong_type(self.problems, node, found, wanted, why)

    def _as_used(self, name: Name, node: Expression, wanted: Wanted) -> Type:
        """Return the type of a variable: a name without prefix is what its uses agree on.

        It never holds a string, whatever they say.
        """
        sigil = name.text[0]
        if sigil == "$":
            return Type.STRING
        if sigil == "#":
            return Type.JOINTS
        if wanted is Type.STRING:
            self.no_texts.append(NoText(name, node, self.program, "", self.item_of_type))
            return Type.DYNAMIC
        return wanted or Type.DYNAMIC

    def _explain_no_texts(self, first: int, why: str) -> None:
        """Say of the names without `$` just found why a string belongs there."""
        for at in range(first, len(self.no_texts)):
            found = self.no_texts[at]
            self.no_texts[at] = found._replace(why=found.why or why)
            self.wrong_lines.add(self.problems.source.line_of(found.node.start))


def _is_slice(node: Item | None) -> bool:
    """Whether a subscript is a range, as in `$s[0:3]`."""
    return isinstance(node, Infix) and node.operator == ":"


def _is_width(node: Expression) -> bool:
    """Whether this is a number that may tell how wide another is written."""
    return isinstance(node, Number) and node.value == round(node.value)


def _taken(code: str) -> str:
    return IN_WORDS[_CODES[code[0]]]
