"""Types of expressions and uses of names.

The walk records how every unprefixed name is used and checks every other type; conflicts between
uses are reported afterwards (usage.py), once a name, with both places.
"""

from vrts.ir.values import Type
from vrts.lang.grammar.build import PRECEDENCE
from vrts.lang.meaning import type_mistakes
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.functions.applications import ApplicationTypes, Wanted
from vrts.lang.meaning.instead import formats
from vrts.lang.meaning.instead.inputs_by_index import asked_as_string
from vrts.lang.meaning.name_uses import Asked, NoText
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import MAX_SUBSCRIPTS
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
from vrts.lang.vocabulary.functions import CONSTANTS
from vrts.lang.vocabulary.lookup import hardly_a_name, instructions_of

_DIVISIONS = frozenset({"/", "MOD"})  # operators whose right operand matters
_COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})


class ExpressionTypes(ApplicationTypes):
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
                formats.format_here(self.problems, node)
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
