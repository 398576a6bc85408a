"""How the names of a program are used: what is noted of each while its statements are read."""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Fix, Rule
from vrts.base.source import Span
from vrts.ir.values import Type
from vrts.lang.meaning.scope import Entry, Scope
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.steps.unknown_words import KEYWORD_AS_NAME
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    Infix,
    Item,
    Name,
    Parenthesised,
    Variable,
)
from vrts.lang.syntax.statements import Assignment, Statement
from vrts.lang.vocabulary.functions import CONSTANTS, applied_functions, bare_functions
from vrts.lang.vocabulary.lookup import look_up, reserved_words

NOT_SIMULATED = Rule("V161", "not-simulated")
MONITOR_COMMAND = Rule("V199", "monitor-command")

SAME_AS_COMMANDS = frozenset(  # SPEED is none: as a command it is the speed of the monitor
    {"BASE", "DISABLE", "ENABLE", "HERE", "PARAMETER", "RESET", "SIGNAL", "TOOL"}
    | {"PCABORT", "PCEND", "PCEXECUTE"}
)

_WORD = re.compile(r"[$#]?[\w.]+")


class NoText(NamedTuple):
    """A number in a place of a string, or a name without `$`: a number or a location."""

    name: Name | None
    node: Expression  # the name, the element of it, or a number
    program: str | None
    why: str  # a string belongs there
    item: Item | None  # of TYPE, that it stands in


class TextGiven(NamedTuple):
    """A name without `$` that is given a string."""

    program: str | None
    target: Variable
    name: Name
    value: Expression


class Asked(NamedTuple):
    """A place whose numbers are to be looked at when all is known."""

    program: str | None
    step: int  # offset of the step that it stands in
    node: Item | Statement


class NameUses:
    """Notes of one compilation, one program after the other."""

    def __init__(self, problems: Problems, scope: Scope) -> None:
        self.problems = problems
        self.dialect = problems.dialect
        self.scope = scope
        self.functions = applied_functions(self.dialect)
        self.bare_functions = bare_functions(self.dialect)
        self.words = reserved_words(self.dialect)
        self.predefined = CONSTANTS.keys() | self.bare_functions.keys()
        self.composing: set[int] = set()  # offsets of `+` and `-` of AS that join locations
        self.located: set[int] = set()  # offsets of names without prefix that are locations
        self.called: list[Name] = []  # programs named by REACT and its like
        self.not_simulated: set[str] = set()  # words reported, each once
        self.program: str | None = None
        self.moves: list[Assignment] = []  # `a = b`, types unknown till the end
        self.program_of: dict[int, str | None] = {}  # of each of `moves`, by offset
        self.argument_types: dict[int, Type] = {}  # of expressions passed by value, by identity
        self.bad_names: set[str] = set()
        self.wrong_lines: set[int] = set()  # lines where a type did not fit
        self.no_texts: list[NoText] = []  # names without `$` where a string belongs
        self.text_case = False  # whether the CASE above compares strings
        self.texts_given: list[TextGiven] = []
        self.asked: list[Asked] = []
        self.parts: set[str] = set()  # locations behind `:`, by their keys
        self.step = 0  # offset of the step that is looked at
        self.item_of_type: Item | None = None  # mixed sum of TYPE that is looked at
        self.reserved: set[str] = set()  # keywords used as names, each said once
        self.profiles = False  # whether it was said that profiles have no effect
        self.used: dict[tuple[str | None, str], Entry] = {}  # by program and name as written
        self.variables: set[str] = set()  # names as written that are no constants, no functions

    def type_of_name(self, program: str | None, name: Name) -> Type:
        """Return the type of a name as all its uses tell."""
        lower = name.text.lower()
        if lower in CONSTANTS:
            return Type.REAL
        signature = self.bare_functions.get(lower)
        if signature is not None:
            return signature.result
        return self.scope.entry(program, key(name.text)).type

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

    def refuse_monitor_command(self, start: int, end: int) -> None:
        """Refuse `MC command`: what is simulated has no operator at whose terminal it would act."""
        source = self.problems.source
        first, _, command = source.text[start:end].partition(" ")
        at = end - len(command.lstrip())
        word = _WORD.match(source.text, at, end)
        known = None if word is None else look_up(word.group(), self.dialect).word
        help_ = "let the operator give the command, with `vrts monitor`"
        fix = None
        if known is not None and known.text in SAME_AS_COMMANDS:
            help_ = f"leave MC out: {known.text} is an instruction too"
            fix = Fix(Span(source, start, at), "")
        self.problems.error(
            MONITOR_COMMAND,
            "a program cannot give the monitor commands here",
            start,
            start + len(first),
            "a command of the monitor follows",
            help=(help_,),
            fix=fix,
        )

    def _use(self, node: Name, wanted: Type | None) -> Entry:
        text = node.text
        entry = self.used.get((self.program, text))
        if entry is None:
            entry = self._first_use(node)
        if (wanted is Type.REAL or wanted is Type.POSE) and text[0] not in "$#":
            if wanted not in entry.types:
                entry.types[wanted] = (node.start, node.end)
            if wanted is Type.POSE:
                self.located.add(node.start)
        return entry

    def _first_use(self, node: Name) -> Entry:
        """Note that a program uses a name, written like this for the first time in it."""
        entry = self.scope.entry(self.program, key(node.text))
        self.used[self.program, node.text] = entry
        entry.spellings.setdefault(node.text.lower(), (node.start, node.end))
        if self._is_reserved(node):  # told once of each word: seldom looked for
            self._reserved(self._formal_name(entry, node))
        return entry

    def _formal_name(self, entry: Entry, node: Name) -> Name:
        """Return where a formal is named first, in the line of its program; else the use."""
        if entry.slot is None or entry.automatic:
            return node
        for program in self.scope.programs.values():
            named = [f.name for f in program.formals if f.name.text.upper() == node.text.upper()]
            if named and program.start <= node.start <= program.finish[1]:
                return named[0]
        return node

    def _is_reserved(self, node: Name) -> bool:
        """Whether a word of the language is used as a name, and that was not told yet."""
        upper = node.text.upper()
        return upper in self.words and upper not in self.reserved and not self.dialect.tolerant

    def _reserved(self, node: Name) -> None:
        if not self._is_reserved(node):
            return
        upper = node.text.upper()
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

    def _loose(self, node: Application) -> None:
        """Note the names in arguments that cannot be told apart."""
        for argument in node.arguments:
            if isinstance(argument, Name):
                self.bad_names.add(key(argument.text))
