"""Statements: which types each wants, and which names each gives a value."""

from vrts.base.diagnostic import Rule, Severity
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.instead.outputs_by_index import switched_output
from vrts.lang.meaning.name_uses import Asked, TextGiven
from vrts.lang.meaning.operands import OperandTypes
from vrts.lang.meaning.scope import Passed
from vrts.lang.meaning.set_or_equals import equals_behind_word, set_of_no_location
from vrts.lang.meaning.type_mistakes import MAX_SUBSCRIPTS, WRONG_TYPE
from vrts.lang.names import key
from vrts.lang.steps.advising.adviser import OTHER_LANGUAGE
from vrts.lang.steps.kawasaki_forms import BLOCK_WORD
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Variable,
)
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
    Statement,
    Structure,
    Until,
    ValueGroup,
    While,
)
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import hardly_a_name

ASSIGNED_LOCATION = Rule("V203", "assigned-location")


_LOOKED_AT = frozenset(  # instructions whose operands matter
    {
        "SIGNAL",
        "WAIT",
        "DELAY",
        "DRAW",
        "DRIVE",
        "LOCK",
        "APPRO",
        "APPROS",
        "PULSE",
        "DEPART",
        "DEPARTS",
        "MOVE",
        "MOVES",
    }
)


class Resolver(OperandTypes):
    """Walks the statements of one program after the other."""

    def statement(self, node: Statement) -> None:
        """Record and check one statement of the current program."""
        self.step = node.start
        if isinstance(node, Simple):
            if node.word in _LOOKED_AT:
                self._ask(node)
            self.simple(node)
            return
        match node:
            case Assignment(target, value):
                self._assignment(node, target, value)
            case SetLocation() if set_of_no_location(self.problems, node, self.functions):
                self._plain(node)
            case SetLocation(target, value):
                self._write(target, Type.POSE, "SET gives a value to a location", value)
                self._location(value, "SET gives a value to a location")
                if isinstance(value, Application):
                    self._ask(node)
            case HereStatement(target):
                self._here(target)
            case ShiftStatement(target, offsets):
                self._write(target, Type.POSE, "SHIFT moves a location", None)
                self._items(offsets, Type.REAL)
            case SpeedStatement(word, levels, _, profile):
                self._ask(node)
                for level in levels:
                    self.check(level.value, Type.REAL, f"{word} takes a number")
                if profile is not None:
                    self.profile(node, profile)
            case Setting(("CPON" | "CPOFF") as word, _, False):
                self.warn_not_simulated(word, node.start, node.end)
            case Setting(word) if INSTRUCTIONS[word].opaque:
                self.warn_not_simulated(word, node.start, node.end)
            case Setting(word, value):
                if value is not None:
                    self.check(value, Type.REAL, f"{word} takes a number")
            case Give(word):
                if word == "PARAMETER":
                    self._ask(node)
                self.give(node)
            case Put(word, target, count, value):
                self._ask(node)
                for part in (target, count, value):
                    if part is not None:
                        self.check(part, Type.REAL, f"{word} takes numbers")
                if word == "IOPUT":
                    self.warn_not_simulated(word, node.start, node.end)
            case PackStatement(target, first, count, value):
                self._write(target, Type.STRING, "PACK changes a string", None)
                self.check(first, Type.REAL, "PACK takes a position")
                self.check(count, Type.REAL, "PACK takes a number of characters")
                self.check(value, Type.STRING, "PACK puts a string in")
            case ReactStatement():
                self._ask(node)
                self.react(node)
            case Device():
                self.device(node)
            case Rest(word, names):
                self.bad_names.update(names)
                if word == "MC" and not (self.dialect.is_as or self.dialect.is_vplus):
                    self.refuse_monitor_command(node.start, node.end)
                elif word != BLOCK_WORD:  # said once, by the parser of steps
                    self.warn_not_simulated(word, node.start, node.start + len(word))
            case Goto(_, condition):
                if condition is not None:
                    self.check(condition, Type.REAL, "IF takes a condition")
            case If(condition) | While(condition) | Until(condition):
                if isinstance(condition, Number | Prefix | Application | Parenthesised):
                    self._ask(node)
                self.check(condition, Type.REAL, "a condition is a number")
            case Case(selector):
                self.text_case = is_text(selector)
                if self.text_case and not self.dialect.tolerant:
                    self._case_of_text(selector)
                else:
                    self._selector(selector)
            case ValueGroup(values):
                for value in values:
                    if value is not None and is_text(value) and self._is_of_text(node):
                        self._type(value, Type.STRING)  # told at its CASE
                    elif value is not None:
                        self.check(value, Type.REAL, "CASE compares numbers")
            case For(target, first, last, increment):
                self._ask(node)
                self._write(target, Type.REAL, "FOR counts a number", None)
                for part in (first, last, increment):
                    if part is not None:
                        self.check(part, Type.REAL, "FOR counts with numbers")
            case CallStatement(program, arguments):
                self._call(program, arguments)
            case CallNamed(program, arguments):
                self.check(program, Type.STRING, "CALLS takes the name of a program in a string")
                self._call(Name("", node.start, node.start), arguments)
            case Bad(word, names):
                self.text_case |= word in ("CASE", "SCASE")  # it may compare either
                self.bad_names.update(names)
            case Declare(word, _, names):
                self._declared(word, names)
            case Structure():
                pass

    def _ask(self, node: Statement) -> None:
        """Have the numbers of a step looked at when all is known."""
        self.asked.append(Asked(self.program, node.start, node))

    # --- statements -----------------------------------------------------------------------------

    def _plain(self, node: SetLocation) -> None:
        """Take `SET n = 5`, which was reported, for `n = 5`."""
        self.wrong_lines.add(self.problems.source.line_of(node.start))
        name = node.target if isinstance(node.target, Name) else node.target.name
        kind = Type.STRING if name.text[0] == "$" or is_text(node.value) else Type.REAL
        if (name.text[0] == "$") is (kind is Type.STRING):
            self._write(node.target, kind, "", node.value)
        else:
            self.bad_names |= {key(name.text), f"${key(name.text)}"}
        self.check(node.value, kind, "")

    def _declared(self, word: str, names: tuple[Expression, ...]) -> None:
        for name in names:
            if not isinstance(name, Name | Element):
                self.problems.error(
                    WRONG_TYPE,
                    f"{word} declares variables",
                    name.start,
                    name.end,
                    "this is none",
                    help=(f"write `{word} a, b`",),
                )

    def _assignment(self, node: Assignment, target: Variable, value: Expression) -> None:
        name = target if isinstance(target, Name) else target.name
        if equals_behind_word(self.problems, node):
            self._type(value, Type.POSE)
            if isinstance(value, Name | Element):  # HERE gives it a value, so it has one
                self._write(value, Type.POSE, "", None)
            return
        if type(target) is Element and switched_output(self.problems, OTHER_LANGUAGE, node):
            return
        if name.text[0] == "$":
            self._write(target, Type.STRING, "`=` keeps the type", value)
            self.check(value, Type.STRING, f"`{name.text}` holds a string")
            return
        if name.text[0] == "#" and not self.dialect.tolerant and _is_number(value):
            self._number_with_sign(name)
            self.check(value, Type.REAL, f"`{name.text[1:]}` holds a number")
            return
        if name.text[0] == "#" or self.is_location(value) or self._joined(value):
            self.assigned_location(node)
            if self.dialect.tolerant:
                self._location(value, "a location is given a location")
            else:
                self._type(value, Type.POSE)
            if name.text[0] != "#" or self.dialect.tolerant:
                self._write(target, Type.POSE, "", value)
            return
        if isinstance(value, Name | Element) and self._open_type(value):
            self.moves.append(node)
            self.program_of[node.start] = self.program
            self._write(target, Type.REAL, "", value)
            entry = self.scope.entry(self.program, key(name.text))
            for noted in (entry.types, entry.given):
                if noted.get(Type.REAL) == (name.start, name.end):
                    del noted[Type.REAL]
            self._type(value, None)
            return
        if is_text(value) and self._open_type(target):
            self._text_given(target, name, value)
            return
        self._write(target, Type.REAL, "`=` gives a value to a number", value)
        self.check(value, Type.REAL, f"`{name.text}` holds a number")

    def _joined(self, value: Expression) -> bool:
        """Whether a value of AS is a location by what is added: `pallet+TRANS(60, 0, 0)`."""
        if not self.dialect.is_as or not isinstance(value, Infix) or value.operator not in "+-":
            return False
        return any(
            self.is_location(part) or self._joined(part) for part in (value.left, value.right)
        )

    def _text_given(self, target: Variable, name: Name, value: Expression) -> None:
        """Keep `name = "Ada"` for when it is known what else the name holds."""
        before = len(self.no_texts)
        found = self._type(value, Type.STRING)
        self.wrong_lines.add(self.problems.source.line_of(target.start))
        del self.no_texts[before:]  # told together with the name
        entry = self._use(name, None)
        entry.writes.append((name.start, name.end))
        if isinstance(target, Element):
            self._subscripts(entry, target, target.subscripts)
        else:
            self._once(entry, name, array=False)
        if found is Type.STRING:
            self.texts_given.append(TextGiven(self.program, target, name, value))

    def _number_with_sign(self, name: Name) -> None:
        """Report `#n = 3`."""
        self.bad_names |= {key(name.text), key(name.text[1:])}
        self.problems.error(
            ASSIGNED_LOCATION,
            f"`{name.text}` is a precision point, and a number is given to it",
            name.start,
            name.end,
            notes=("`#` begins the name of a precision point", "VAL-II says *Illegal assignment*"),
            help=(f"leave the `#` out: write `{name.text[1:]} = ...`",),
            fix=self.problems.replace(name.start, name.end, name.text[1:]),
        )

    def _open_type(self, node: Name | Element) -> bool:
        name = node if isinstance(node, Name) else node.name
        return name.text[0] not in "$#" and name.text.lower() not in self.predefined

    def _selector(self, node: Item) -> None:
        """CASE compares numbers; the relatives also compare strings."""
        if self.dialect.tolerant and is_text(node):
            self._type(node, Type.STRING)
        else:
            self.check(node, Type.REAL, "CASE compares numbers")

    def _is_of_text(self, node: ValueGroup) -> bool:
        """Whether a group may hold texts: of the CASE that was read last, or by its own word."""
        word = self.problems.source.text[node.start : node.start + len("SVALUE")]
        return self.text_case or word.upper() == "SVALUE"

    def _case_of_text(self, selector: Expression) -> None:
        """Report `CASE $a OF`, once with its values."""
        written = self.problems.source.text[selector.start : selector.end]
        self._type(selector, Type.STRING)
        self.problems.error(
            WRONG_TYPE,
            "CASE compares numbers, not a string",
            selector.start,
            selector.end,
            "this is a string",
            notes=("VAL-II says *Illegal operator*",),
            help=(
                f'compare strings by IF, one after the other: `IF {written} == "text" THEN`',
                f"if they are numbers, write `CASE VAL({written}) OF`, and values without quotes",
            ),
        )

    def assigned_location(self, node: Assignment) -> None:
        """Report `a = b` between locations."""
        if isinstance(node.value, Element) and len(node.value.subscripts) > MAX_SUBSCRIPTS:
            return  # `a = p[0.5, 0.2, 0.1, 0, 3.14, 0]`: what is said of the list says it all
        verb = "POINT" if self.dialect.is_as else "SET"
        self.problems.error(
            ASSIGNED_LOCATION,
            f"a location is given a value by {verb}",
            node.start,
            node.target.end,
            notes=("`=` is for numbers and strings", "VAL-II says *Illegal assignment*"),
            help=(f"write `{verb} {self.problems.source.text[node.start : node.end]}`",),
            fix=self.problems.replace(node.start, node.start, f"{verb} "),
            severity=Severity.WARNING if self.dialect.tolerant else Severity.ERROR,
        )

    def _here(self, target: Expression) -> None:
        last = target
        joint = "+" if self.dialect.is_as else ":"
        if isinstance(target, Infix) and target.operator == joint:
            self.check(target.left, Type.POSE, f"`{joint}` joins locations")
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
                help=(f"write `HERE part`, or `HERE frame{joint}part`",),
            )

    def _call(self, program: Name, arguments: tuple[Item | None, ...]) -> None:
        callee = key(program.text) if program.text else ""
        for i, argument in enumerate(arguments):
            if isinstance(argument, Element) and not argument.subscripts:
                entry = self._use(argument.name, None)
                self._once(entry, argument.name, array=True)
                entry.passed.append(Passed(callee, i, True))
            elif isinstance(argument, Name) and self._takes_array(callee, i):
                self._use(argument, None).passed.append(Passed(callee, i, True))  # told at the call
            elif isinstance(argument, Name | Element):
                name = argument if isinstance(argument, Name) else argument.name
                self._type(argument, None)
                reserved = self.dialect.is_as and hardly_a_name(name.text, self.dialect)
                if name.text.lower() not in self.predefined and not reserved:
                    entry = self.scope.entry(self.program, key(name.text))
                    at = (argument.start, argument.end)
                    entry.passed.append(Passed(callee, i, False, at))
                    entry.written_in.add(self.program)
                    entry.reads.pop()
            elif argument is not None:
                self.argument_types[id(argument)] = self._type(argument, None)

    def _takes_array(self, callee: str, place: int) -> bool:
        program = self.scope.programs.get(callee)
        formals = program.formals[place : place + 1] if program is not None else ()
        return any(formal.array for formal in formals)


def _is_number(node: Expression) -> bool:
    """Return whether an expression is a number by its form alone."""
    if isinstance(node, Infix):
        return node.operator != ":" and _is_number(node.left) and _is_number(node.right)
    return isinstance(node, Number) or (isinstance(node, Prefix) and _is_number(node.operand))
