"""Types of expressions and uses of names.

The walk records how every unprefixed name is used and checks every other type; conflicts between
uses are reported afterwards (usage.py), once a name, with both places.
"""

import re
from collections.abc import Collection
from typing import TypeAlias

from vrts.base.diagnostic import Label, Rule
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.dialect import Angles
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.scope import Entry, Scope
from vrts.lang.names import key
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.steps.other_forms import INVALID_FORMAT
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
from vrts.lang.syntax.statements import Assignment
from vrts.lang.vocabulary.functions import (
    CONSTANTS,
    FOREIGN_FUNCTIONS,
    Signature,
    applied_functions,
    bare_functions,
)
from vrts.lang.vocabulary.lookup import instructions_of, reserved_words

KEYWORD_AS_NAME = Rule("V160", "keyword-as-name")
WRONG_TYPE = Rule("V202", "wrong-type")
UNKNOWN_FUNCTION = Rule("V209", "unknown-function")
FUNCTION_ARGUMENTS = Rule("V210", "function-arguments")
RESERVED_NAME = Rule("V211", "reserved-name")
SUBSCRIPTS = Rule("V214", "subscripts")
DEFAULT_ANGLES = Rule("V215", "default-angles")
INVALID_SWITCH = Rule("V218", "invalid-switch")
INVALID_PARAMETER = Rule("V219", "invalid-parameter")
NOT_SIMULATED = Rule("V161", "not-simulated")

MAX_SUBSCRIPTS = 3  # [manual language/numbers#dimensions]
FORMAT = re.compile(r"/[DFIGEHOCXUBSJKLN](\d{0,3}(\.\d{1,2})?)?", re.IGNORECASE)
_WORD = re.compile(r"[$#]?[\w.]+")
TYPES_SAY = "VAL-II says *Illegal operator*"
_ANGLES = 3
_OF_ARRAYS = frozenset({"last", "$unpack"})  # functions that a whole array is given to

Wanted: TypeAlias = Type | None  # None: any type; POSE also takes joints where `joints` is True
_WORDS = {
    Type.REAL: "a number",
    Type.STRING: "a string",
    Type.POSE: "a location",
    Type.JOINTS: "a precision point",
    Type.DYNAMIC: "a value",
}
_CODES = {"r": Type.REAL, "s": Type.STRING, "p": Type.POSE, "l": Type.POSE, "$": Type.STRING}
_COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})


class ExpressionTypes:
    """Checks the expressions of one program after the other."""

    def __init__(self, problems: Problems, scope: Scope) -> None:
        self.problems = problems
        self.dialect = problems.dialect
        self.scope = scope
        self.functions = applied_functions(self.dialect)
        self.bare_functions = bare_functions(self.dialect)
        self.words = reserved_words(self.dialect)
        self.predefined = CONSTANTS.keys() | self.bare_functions.keys()
        self.composing: set[int] = set()  # offsets of `+` and `-` of AS that join locations
        self.called: list[Name] = []  # programs named by REACT and its like
        self.not_simulated: set[str] = set()  # words reported, each once
        self.program: str | None = None
        self.moves: list[Assignment] = []  # `a = b`, types unknown till the end
        self.program_of: dict[int, str | None] = {}  # of each of `moves`, by offset
        self.argument_types: dict[int, Type] = {}  # of expressions passed by value, by identity
        self.bad_names: set[str] = set()
        self.wrong_lines: set[int] = set()  # lines where a type did not fit
        self.reserved: set[str] = set()  # keywords used as names, each said once

    def type_of_name(self, program: str | None, name: Name) -> Type:
        """Return the type of a name as all its uses tell."""
        lower = name.text.lower()
        if lower in CONSTANTS:
            return Type.REAL
        signature = self.bare_functions.get(lower)
        if signature is not None:
            return signature.result
        return self.scope.entry(program, key(name.text)).type

    # --- expressions ----------------------------------------------------------------------------

    def check(self, node: Item, wanted: Wanted, why: str, *, joints: bool = False) -> Type:
        """Return the type of an expression, and report it where it is not the one wanted."""
        found = self._type(node, wanted)
        if wanted is None or found is wanted or found is Type.DYNAMIC:
            return found
        if joints and wanted is Type.POSE and found is Type.JOINTS:
            return found
        if not isinstance(node, FormatItem):
            self._wrong(node, found, wanted, why)
        return Type.DYNAMIC

    def _type(self, node: Item, wanted: Wanted) -> Type:
        match node:
            case Number():
                return Type.REAL
            case Text():
                return Type.STRING
            case Name():
                return self._name(node, wanted)
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
            case Infix():
                return self._infix(node, wanted)
            case Application():
                return self._application(node, wanted)
            case FormatItem():
                self.problems.error(
                    INVALID_FORMAT,
                    f"the format `{node.text}` does not belong here",
                    node.start,
                    node.end,
                    notes=("VAL-II says *Invalid format specifier*",),
                    help=("formats stand in TYPE and $ENCODE",),
                )
                return Type.DYNAMIC

    def _infix(self, node: Infix, wanted: Wanted) -> Type:
        operator = node.operator
        if operator == ":":
            for part in (node.left, node.right):
                self.check(part, Type.POSE, "`:` joins locations")
            return Type.POSE
        if operator in "+-" and self.dialect.is_as and self._locations(wanted, node.left):
            self.composing.add(node.operator_start)
            for part in (node.left, node.right):
                self.check(part, Type.POSE, f"`{operator}` joins locations")
            return Type.POSE
        if operator == "+":
            return self._sum(node, wanted)
        if operator in _COMPARISONS:
            text = is_text(node.left) or is_text(node.right)
            kind = Type.STRING if text else Type.REAL
            why = f"`{operator}` takes two strings or two numbers"
            self.check(node.left, kind, why)
            self.check(node.right, kind, why)
            return Type.REAL
        for part in (node.left, node.right):
            self.check(part, Type.REAL, f"`{operator}` takes numbers")
        return Type.REAL

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
            return self._added_locations(node)
        kind = Type.STRING if text else Type.REAL
        for operand in reversed(operands):
            self.check(operand, kind, "`+` takes two strings or two numbers")
        return kind

    def _locations(self, wanted: Wanted, node: Expression) -> bool:
        """Return whether `+` and `-` before or after an operand join locations in AS."""
        return wanted is Type.POSE or (wanted is None and self.is_location(node))

    def is_location(self, node: Expression) -> bool:
        """Return whether an expression is a location by its form alone."""
        while isinstance(node, Parenthesised):
            node = node.inner
        if isinstance(node, Infix):
            return node.operator == ":" or node.operator_start in self.composing
        if isinstance(node, Element):
            return node.name.text[0] == "#"
        name = node.name if isinstance(node, Application) else node
        if not isinstance(name, Name):
            return False
        known = self.functions if isinstance(node, Application) else self.bare_functions
        signature = known.get(name.text.lower())
        if signature is None:
            return name.text[0] == "#"
        return signature.result in (Type.POSE, Type.JOINTS)

    def _added_locations(self, node: Infix) -> Type:
        self._type(node.left, Type.POSE)
        self._type(node.right, Type.POSE)
        self.problems.error(
            WRONG_TYPE,
            "locations are not added",
            node.operator_start,
            node.operator_start + 1,
            notes=(TYPES_SAY,),
            help=("join a frame and a location in it by `:`, or shift by `SHIFT(a BY x, y, z)`",),
        )
        return Type.DYNAMIC

    def _name(self, node: Name, wanted: Wanted) -> Type:
        lower = node.text.lower()
        if lower in CONSTANTS:
            return Type.REAL
        signature = self.bare_functions.get(lower)
        if signature is not None:
            if signature.opaque:
                self.warn_not_simulated(node.text.upper(), node.start, node.end)
            return signature.result
        entry = self._use(node, wanted)
        entry.reads.append((node.start, node.end))
        self._once(entry, node, array=False)
        return _as_used(entry, wanted)

    def _element(
        self, node: Element, name: Name, subscripts: tuple[Item | None, ...], wanted: Wanted
    ) -> Type:
        entry = self._use(name, wanted)
        entry.reads.append((node.start, node.end))
        self._subscripts(entry, node, subscripts)
        return _as_used(entry, wanted)

    def _subscripts(self, entry: Entry, node: Element, subscripts: tuple[Item | None, ...]) -> None:
        self._once(entry, node.name, array=True)
        if not subscripts:
            self.problems.error(
                SUBSCRIPTS,
                f"`{node.name.text}[]` is a whole array",
                node.start,
                node.end,
                help=("write an index: a whole array can only be passed by CALL",),
                notes=("VAL-II says *Missing argument*",),
            )
        if len(subscripts) > MAX_SUBSCRIPTS:
            self.problems.error(
                SUBSCRIPTS,
                f"an array has at most {MAX_SUBSCRIPTS} subscripts",
                node.start,
                node.end,
            )
        self._items(subscripts, Type.REAL)

    def _application(self, node: Application, wanted: Wanted) -> Type:
        lower = node.name.text.lower()
        signature = self.functions.get(lower)
        if signature is None:
            self._unknown_function(node, lower)
            return Type.DYNAMIC
        if signature.opaque:
            self.warn_not_simulated(node.name.text.upper(), node.name.start, node.name.end)
            self._loose(node)
        elif signature.parameters and signature.parameters[0][0] == "v":
            self._defined(node, signature)
        elif signature.parameters and signature.parameters[0][0] == "n":
            self._named(node, signature)
        elif signature.name == "$encode":
            self.items_of_type(node.arguments)
            self._count(node, signature)
        elif self._count(node, signature):
            for i, argument in enumerate(node.arguments):
                code = signature.parameters[min(i, len(signature.parameters) - 1)]
                if code[0] == "$" and argument is not None:
                    self._changed(argument, node)
                if argument is not None:
                    why = f"{node.name.text.upper()} takes {_taken(code)} here"
                    self.check(argument, _CODES[code[0]], why, joints=code[0] == "l")
            if signature.name == "trans" and self.dialect.angles is Angles.OAT:
                self._default_angles(node)
        return signature.result

    def _count(self, node: Application, signature: Signature) -> bool:
        given = len(node.arguments)
        most = signature.most
        omitted = [
            i
            for i, argument in enumerate(node.arguments)
            if argument is None and i < signature.required
        ]
        name = node.name.text.upper()
        if signature.by is not None and node.by != signature.by:
            headline = f"{name} without BY"
            help_ = f"write `{name}(location BY ...)`"
        elif given < signature.required or omitted:
            headline = f"{name} needs {_arguments(signature.required)}, {given} given"
            help_ = ""
        elif most is not None and given > most:
            headline = f"{name} takes {_arguments(most)}, {given} given"
            help_ = ""
        else:
            return True
        self.problems.error(
            FUNCTION_ARGUMENTS,
            headline,
            node.start,
            node.end,
            notes=("VAL-II says *Missing argument*",),
            help=(help_,) if help_ else (),
        )
        self._loose(node)
        return False

    def _defined(self, node: Application, signature: Signature) -> None:
        if not node.arguments or node.arguments[0] is None:
            self._count(node._replace(arguments=()), signature)
            return
        first = node.arguments[0]
        if not isinstance(first, Name | Element) or not self._count(node, signature):
            self.problems.error(
                FUNCTION_ARGUMENTS,
                f"{node.name.text.upper()} takes a variable",
                first.start,
                first.end,
                notes=("VAL-II says *Illegal assignment*",),
            )
            return
        name = first if isinstance(first, Name) else first.name
        entry = self._use(name, Type.REAL if signature.name == "tas" else None)
        entry.asked = True
        if signature.name == "tas":
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
        shown = len(self.problems.found) < LIMIT
        meant = nearest(text, known) if text and shown else None
        rule = INVALID_SWITCH if what == "switch" else INVALID_PARAMETER
        written = self.problems.source.text[node.start : node.end]
        self.problems.error(
            rule,
            f"there is no {what} `{written}`",
            node.start,
            node.end,
            notes=("VAL-II says *Invalid switch*",) if what == "switch" else (),
            help=(f"did you mean `{meant}`?" if meant else f"known are {', '.join(known)}",),
            fix=self.problems.replace(node.start, node.end, meant) if meant else None,
        )
        return None

    def _changed(self, argument: Item, node: Application) -> None:
        """$DECODE takes what it returns from its variable."""
        name = argument.name if isinstance(argument, Element) else argument
        if isinstance(name, Name) and name.text[0] == "$":
            entry = self.scope.entry(self.program, key(name.text))
            entry.values.append(Text("", 0, 0))
            return
        self.problems.error(
            FUNCTION_ARGUMENTS,
            f"{node.name.text.upper()} takes a string variable first",
            argument.start,
            argument.end,
            notes=("it takes the piece that it returns out of the variable",),
            help=("assign the text to a variable: `$s = ...`",),
        )

    def warn_not_simulated(self, word: str, start: int, end: int) -> None:
        """Say once of each word that the run stops where it is reached."""
        if word in self.not_simulated:
            return
        self.not_simulated.add(word)
        written = _WORD.match(self.problems.source.text, start, end)  # it may be abbreviated
        self.problems.warning(
            NOT_SIMULATED,
            f"{word} is not simulated",
            start,
            written.end() if written else end,
            "a run stops when it gets here",
            notes=("VAL-II says *Option not installed*",),
            data={"word": word},
        )

    def items_of_type(self, items: tuple[Item | None, ...]) -> None:
        """Check the items of TYPE and $ENCODE."""
        for item in items:
            if isinstance(item, FormatItem):
                if FORMAT.fullmatch(item.text) is None:
                    self.problems.error(
                        INVALID_FORMAT,
                        f"`{item.text}` is not a format",
                        item.start,
                        item.end,
                        notes=("VAL-II says *Invalid format specifier*",),
                        help=("formats are /D /F8.2 /I4 /G8.2 /E10.2 /H /O /C /X /U /B /S",),
                    )
            elif item is not None:
                kind = Type.STRING if is_text(item) else Type.REAL
                self.check(item, kind, "TYPE writes numbers and strings")

    def _items(self, items: tuple[Item | None, ...], wanted: Type) -> None:
        for item in items:
            if item is not None:
                self.check(item, wanted, f"{_WORDS[wanted]} belongs here")

    def _loose(self, node: Application) -> None:
        """Note the names in arguments that cannot be told apart."""
        for argument in node.arguments:
            if isinstance(argument, Name):
                self.bad_names.add(key(argument.text))

    # --- names ----------------------------------------------------------------------------------

    def _use(self, node: Name, wanted: Wanted) -> Entry:
        entry = self.scope.entry(self.program, key(node.text))
        entry.spellings.setdefault(node.text.lower(), (node.start, node.end))
        if wanted is not None and node.text[0] not in "$#":
            entry.types.setdefault(wanted, (node.start, node.end))
        self._reserved(node)
        return entry

    def _reserved(self, node: Name) -> None:
        upper = node.text.upper()
        if upper not in self.words or upper in self.reserved or self.dialect.tolerant:
            return
        self.reserved.add(upper)
        self.problems.warning(
            KEYWORD_AS_NAME,
            f"{upper} is a word of the language, here it names a variable",
            node.start,
            node.end,
            help=("choose another name",),
        )

    def _once(self, entry: Entry, node: Name, *, array: bool) -> None:
        if array and entry.array is None:
            entry.array = (node.start, node.end)
        elif not array and entry.scalar is None:
            entry.scalar = (node.start, node.end)

    def _write(self, target: Variable, kind: Type, why: str, value: Expression | None) -> None:
        name = target if isinstance(target, Name) else target.name
        lower = name.text.lower()
        if lower in self.predefined:
            self.problems.error(
                RESERVED_NAME,
                f"{name.text.upper()} cannot be given a value",
                name.start,
                name.end,
                notes=("VAL-II says *Illegal assignment*",),
                help=(f"write `{lower.upper()} ...` without `=`, or choose another name",)
                if lower.upper() in instructions_of(self.dialect)
                else ("choose another name",),
            )
            return
        sigil = {"$": Type.STRING, "#": Type.JOINTS}.get(name.text[0])
        location = kind is Type.POSE and sigil is Type.JOINTS
        if sigil is not None and sigil is not kind and not location:
            self._wrong(target, sigil, kind, why)
            return
        entry = self._use(name, None if sigil else kind)
        entry.writes.append((name.start, name.end))
        if value is not None and isinstance(target, Name):
            entry.values.append(value)
        elif isinstance(target, Name):
            entry.values.append(Text("", 0, 0))  # changes in ways not followed
            entry.changed = True
        if isinstance(target, Element):
            self._subscripts(entry, target, target.subscripts)
        else:
            self._once(entry, name, array=False)

    # --- wording --------------------------------------------------------------------------------

    def _wrong(self, node: Expression, found: Type, wanted: Type, why: str) -> None:
        self.wrong_lines.add(self.problems.source.line_of(node.start))
        secondary: tuple[Label, ...] = ()
        help_: tuple[str, ...] = ()
        if wanted is Type.POSE and isinstance(node, Infix) and node.operator == "-":
            text = self.problems.source.text[node.start : node.end]
            joined = text.replace(" ", "").replace("-", "_")
            help_ = (f"`-` subtracts; if this is meant as one name, write `{joined}`",)
        elif wanted is Type.POSE and found is Type.JOINTS:
            help_ = ("a precision point cannot stand in a compound: `SET p = #point` first",)
        elif wanted is Type.POSE and found is Type.REAL:
            help_ = ("name a location, or write `TRANS(x, y, z, o, a, t)`",)
            if why.startswith("SET"):
                help_ = ("a number is given a value by `=`, without SET",)
        elif wanted is Type.REAL and found is Type.STRING:
            help_ = ("a string variable begins with `$`; VAL($s) turns a string into a number",)
        elif wanted is Type.STRING and found is Type.REAL:
            help_ = ("put text between double quotes; $ENCODE(x) turns a number into a string",)
        elif wanted is Type.REAL and found in (Type.POSE, Type.JOINTS):
            help_ = ("DX(l), DY(l) and DZ(l) are the coordinates of a location",)
        self.problems.error(
            WRONG_TYPE,
            f"{why}, not {_WORDS[found]}",
            node.start,
            node.end,
            f"this is {_WORDS[found]}",
            secondary=secondary,
            notes=(TYPES_SAY,),
            help=help_,
        )

    def _unknown_function(self, node: Application, lower: str) -> None:
        shown = len(self.problems.found) < LIMIT  # what is not shown needs no suggestion
        meant = nearest(lower, self.functions) if shown else None
        if lower in FOREIGN_FUNCTIONS:
            help_ = (FOREIGN_FUNCTIONS[lower],)
        elif meant is not None:
            help_ = (f"did you mean `{meant.upper()}`?",)
        elif lower in self.scope.programs:
            help_ = ("a program is called by CALL and yields no value",)
        else:
            help_ = ("an element of an array is written with brackets: `a[1]`",)
        self.problems.error(
            UNKNOWN_FUNCTION,
            f"there is no function `{node.name.text}`",
            node.name.start,
            node.name.end,
            notes=("VAL-II says *Illegal expression syntax*",),
            help=help_,
        )
        self._loose(node)

    def _default_angles(self, node: Application) -> None:
        given = node.arguments[_ANGLES:]
        if any(argument is not None for argument in given) or not node.arguments:
            return
        self.problems.warning(
            DEFAULT_ANGLES,
            "TRANS without angles",
            node.start,
            node.end,
            "taken as 90, -90, 0: not turned",
            notes=("other controllers take omitted angles as 0, 0, 0: the hand level",),
            help=("write all six: `TRANS(x, y, z, 90, -90, 0)`",),
        )


def _as_used(entry: Entry, wanted: Wanted) -> Type:
    if entry.name[0] in "$#":
        return entry.type
    return wanted or Type.DYNAMIC


def _arguments(count: int) -> str:
    return f"{count} argument" if count == 1 else f"{count} arguments"


def _taken(code: str) -> str:
    return _WORDS[_CODES[code[0]]]
