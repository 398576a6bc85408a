"""Questions about names that only the whole compilation answers."""

import re
from bisect import bisect_right
from collections.abc import Callable

from vrts.base.diagnostic import Fix, Rule, Severity
from vrts.ir.values import Type
from vrts.lang.findings.calls import (
    ARGUMENT_COUNT,
    as_header,
    check_error_returns,
    named_as_word,
    swapped,
    too_few,
)
from vrts.lang.findings.clashes import clash
from vrts.lang.meaning.agreement import settle_types, type_of_argument
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.no_texts import report_no_texts
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import NAME_TRUNCATED, SIGNIFICANT, is_truncated, key
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.syntax.expressions import Element, Item, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import CallStatement
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import never_names

UNDEFINED_LOCATION = Rule("V204", "undefined-location")
UNDEFINED_VARIABLE = Rule("V205", "undefined-variable")
UNDEFINED_PROGRAM = Rule("V206", "undefined-program")
ARGUMENT_TYPE = Rule("V208", "argument-type")
UNUSED_NAME = Rule("V225", "unused-name")

MOST_NAMES = 2000  # with more names than this none is suggested
_HAND = re.compile(
    r"[ \t]*(?:\d+[ \t]+)?(?P<word>OPEN|CLOSE|RELAX)[ \t]+I[ \t]*(?:;.*)?", re.IGNORECASE
)
_MISMATCH = "VAL-II says *Program argument mismatch*"


def check_usage(resolver: Resolver, programs: list[ProgramText]) -> None:
    """Report what the uses of each name do not agree on, and what is never given a value."""
    decided = settle_types(resolver, programs)
    report_no_texts(resolver)
    suggestions = _Suggestions(resolver)
    bodies = sorted((p.start, p.finish[1]) for p in programs)
    clashes: set[int] = set()
    for entry in resolver.scope.all_entries():
        if clash(resolver, entry):
            clashes.add(id(entry))
        _truncated(resolver, entry)
    for entry in resolver.scope.all_entries():
        if id(entry) not in clashes and entry.name not in resolver.bad_names:
            _without_value(resolver, entry, suggestions)
            if not resolver.problems.any_error:
                _without_use(resolver, entry, suggestions, bodies)
    for program in programs:
        for step in program.steps:
            if isinstance(step.statement, CallStatement):
                _call(resolver, program, step.statement, suggestions, decided)
        named_as_word(resolver, program)
    check_error_returns(resolver.problems, programs)
    for name in resolver.called:
        if key(name.text) not in resolver.scope.programs:
            _undefined_program(resolver, name, suggestions)


class _Suggestions:
    """Did you mean: for as many names as are shown, and among not too many others."""

    def __init__(self, resolver: Resolver) -> None:
        self.entries = resolver.scope.all_entries()
        self.programs = list(resolver.scope.programs)
        self.left = LIMIT

    def name(self, entry: Entry, among: Callable[[Entry], bool]) -> str | None:
        """Return the name most like that of an entry."""
        if not self._may_ask(len(self.entries)):
            return None
        return nearest(entry.name, [other.name for other in self.entries if among(other)])

    def program(self, name: str) -> str | None:
        """Return the program whose name is most like another."""
        return nearest(name, self.programs) if self._may_ask(len(self.programs)) else None

    def _may_ask(self, count: int) -> bool:
        self.left -= 1
        return self.left >= 0 and count <= MOST_NAMES


def _truncated(resolver: Resolver, entry: Entry) -> None:
    text = resolver.problems.source.text
    used: dict[str, Place] = {}  # where a program uses each spelling first
    for place in sorted(entry.reads):
        used.setdefault(text[place[0] : place[1]].lower(), place)
    spelled = {**entry.spellings, **used}
    long = [(at, name) for name, at in spelled.items() if is_truncated(name)]
    if not long:
        return
    long.sort()
    at, name = long[0]
    problems = resolver.problems
    if len(long) > 1:
        problems.warning(
            NAME_TRUNCATED,
            f"`{name}` and `{long[1][1]}` are the same variable",
            *at,
            secondary=(problems.label(*long[1][0], "the other name"),),
            notes=(f"only the first {SIGNIFICANT} characters of a name count",),
            help=(f"make them differ in their first {SIGNIFICANT} characters",),
        )
    else:
        problems.warning(
            NAME_TRUNCATED,
            f"only `{entry.name}` counts of `{name}`",
            *at,
            notes=(f"only the first {SIGNIFICANT} characters of a name count",),
            help=("choose a shorter name",),
        )


def _without_value(resolver: Resolver, entry: Entry, suggestions: _Suggestions) -> None:
    if not entry.reads or resolver.scope.may_have_value(entry):
        return
    problems = resolver.problems
    if {problems.source.line_of(start) for start, _ in entry.reads} <= resolver.wrong_lines:
        return  # the lines were reported
    location = entry.type in (Type.POSE, Type.JOINTS)
    at = min(entry.reads)
    kind = "location" if location else "string" if entry.type is Type.STRING else "variable"
    meant = suggestions.name(entry, lambda other: _could_be(other, entry))
    upper = entry.name.upper()
    declared = entry.automatic or bool(entry.stored)
    if resolver.dialect.is_vplus and not declared and upper in never_names(resolver.dialect):
        for at in entry.reads:
            _keyword(resolver, at, upper, "a value")
        return
    other = _other_sign(resolver, entry)
    hand = _HAND.fullmatch(problems.source.line_text(problems.source.line_of(at[0])))
    if hand is not None:
        start, end = _span_of(problems, hand, at)
        word = hand["word"].upper() + "I"
        meant, at = word, (start, end)
        help_ = f"did you mean `{word}`? It is one word, and acts at once"
    elif other:
        meant = other
        help_ = f"did you mean `{meant}`? `{entry.name}` and `{meant}` are two locations"
    elif entry.name in resolver.scope.programs:
        meant = None
        help_ = f"`{entry.name}` is a program: write `CALL {entry.name}` on a line of its own"
    elif meant is not None:
        help_ = f"did you mean `{meant}`?"
    elif (
        location and upper in INSTRUCTIONS and INSTRUCTIONS[upper].terminal in ("WORD0", "SETTING0")
    ):
        help_ = f"{upper} is an instruction: write it alone"
    elif location:
        help_ = "give it a value in a .LOCATIONS section, or by SET or HERE"
    elif _is_typed(problems, at) and entry.type is not Type.STRING:
        help_ = f'for text write `"{entry.name}"`, between double quotes; '
        help_ += "else give it a value before it is used"
    else:
        help_ = "give it a value before it is used"
    more = len(entry.reads) - 1
    problems.warning(
        UNDEFINED_LOCATION if location else UNDEFINED_VARIABLE,
        f"the {kind} `{entry.name}` is never given a value in this file",
        *at,
        notes=(
            *((f"used {more} more {'time' if more == 1 else 'times'}",) if more else ()),
            "the controller stops here with *Undefined value* unless it has one from before",
        ),
        help=(help_,),
        fix=problems.replace(*at, meant) if meant else None,
        data={"name": entry.name},
    )


def _span_of(problems: Problems, hand: re.Match[str], at: Place) -> Place:
    """Return where a word of the hand and the `I` behind it stand."""
    source = problems.source
    begin = source.line_starts[source.line_of(at[0]) - 1]
    return begin + hand.start("word"), at[1]


def _keyword(resolver: Resolver, at: Place, upper: str, wanted: str) -> None:
    """Report a keyword where a name belongs, and nothing says that it is one."""
    resolver.problems.error(
        KEYWORD_AS_NAME,
        f"{upper} is a word of the language, and no name",
        *at,
        f"{wanted} belongs here",
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"a step may begin with {upper}; variables and programs have other names",),
    )


def _without_use(
    resolver: Resolver, entry: Entry, suggestions: _Suggestions, bodies: list[tuple[int, int]]
) -> None:
    """Note a number or string that only ever gets values, by `=`."""
    if entry.reads or entry.passed or entry.asked or entry.slot is not None or not entry.writes:
        return
    if entry.type not in (Type.REAL, Type.STRING) or entry.changed or not entry.values:
        return
    if not all(_inside(bodies, at) for at, _ in entry.writes):
        return  # data that stands ready
    problems = resolver.problems
    meant = suggestions.name(entry, lambda other: other is not entry and bool(other.reads))
    problems.note(
        UNUSED_NAME,
        f"`{entry.name}` is given a value and never used in this file",
        *min(entry.writes),
        help=(f"did you mean `{meant}`?",) if meant else (),
        data={"name": entry.name},
    )


def _inside(bodies: list[tuple[int, int]], at: int) -> bool:
    """Return whether an offset lies in one of the programs, which are in order."""
    number = bisect_right(bodies, (at, at)) - 1
    return number >= 0 and bodies[number][0] <= at < bodies[number][1]


def _other_sign(resolver: Resolver, entry: Entry) -> str:
    """Return `#safe` for `safe`, or the other way round, where only that has a value."""
    name = entry.name[1:] if entry.name[0] == "#" else f"#{entry.name}"
    found = resolver.scope.entries.get(name)
    location = entry.type in (Type.POSE, Type.JOINTS)
    fits = found is not None and found.writes and found.type in (Type.POSE, Type.JOINTS)
    return name if location and fits else ""


def _is_typed(problems: Problems, place: Place) -> bool:
    """Return whether a name stands alone among what TYPE writes, as a word of a text would."""
    line = problems.source.line_text(problems.source.line_of(place[0]))
    return re.match(r"[ \t]*(\d+[ \t]+)?TYPE[ \t]", line, re.IGNORECASE) is not None


def _could_be(other: Entry, entry: Entry) -> bool:
    if other is entry or not (other.writes or other.slot is not None):
        return False
    return other.type is entry.type or Type.DYNAMIC in (other.type, entry.type)


def _call(
    resolver: Resolver,
    caller: ProgramText,
    node: CallStatement,
    suggestions: _Suggestions,
    decided: dict[int, Place],
) -> None:
    problems, scope = resolver.problems, resolver.scope
    name = node.program
    program = scope.programs.get(key(name.text))
    if program is None:
        _undefined_program(resolver, name, suggestions)
        return
    if not program.sound:
        return  # which arguments it takes is not known
    header = problems.label(program.start, program.end, "the program begins here")
    if len(node.arguments) > len(program.formals):
        given, taken = len(node.arguments), len(program.formals)
        problems.error(
            ARGUMENT_COUNT,
            f"`{program.name}` takes {taken or 'no'} argument{'' if taken == 1 else 's'}, "
            f"{given} given",
            node.start,
            node.end,
            secondary=(header,),
            notes=(_MISMATCH,),
            help=(f"leave {given - taken} of them out: write `CALL {as_header(program)}`",),
            severity=_at_the_call(resolver),
        )
        return
    before = len(problems.found)
    for i, argument in enumerate(node.arguments):
        if len(problems.found) > before:
            break  # the call was told to be wrong
        formal = program.formals[i]
        if argument is None or not formal.name.text:
            continue
        secondary = (header,)
        fix: Fix | None = None
        whole = isinstance(argument, Element) and not argument.subscripts
        if formal.array and not isinstance(argument, Element):
            problem = f"argument {i + 1} of `{program.name}` is a whole array"
            shown = argument.text if isinstance(argument, Name) else "a"
            help_ = f"write the name of an array with empty brackets: `{shown}[]`"
            if isinstance(argument, Name):
                fix = problems.replace(argument.end, argument.end, "[]")
        elif whole and not formal.array:
            problem = f"argument {i + 1} of `{program.name}` is not an array"
            help_ = "name one element: `a[1]`"
        else:
            entry = scope.formals[program.name][key(formal.name.text)]
            wanted, found = entry.type, type_of_argument(resolver, caller.name, argument)
            if wanted is found or not _differ(wanted, found, argument):
                continue
            problem = f"argument {i + 1} of `{program.name}` is {_WORDS[wanted]}"
            help_ = f"this argument is {_WORDS[found]}; write the arguments in the order of "
            help_ += f"`{as_header(program)}`"
            other = swapped(resolver, caller, node, program)
            if other:
                help_ = f"write the arguments in the order of the program: `{other}`"
                fix = problems.replace(node.start, node.end, other)
            if id(entry) in decided:
                first = problems.label(*decided[id(entry)], f"{_WORDS[wanted]} here")
                header = problems.label(program.start, program.end, "it is open here")
                secondary = (first, header)
        problems.error(
            ARGUMENT_TYPE,
            problem,
            argument.start,
            argument.end,
            secondary=secondary,
            notes=(_MISMATCH,),
            help=(help_,),
            fix=fix,
        )
    few = len(node.arguments) < len(program.formals) and not problems.dialect.tolerant
    if few and len(problems.found) == before:
        too_few(resolver, node, program)


def _differ(wanted: Type, found: Type, argument: Item) -> bool:
    """Return whether a formal surely cannot take an argument of another type.

    What is open is a number or a location: a name without prefix.
    """
    if wanted is Type.DYNAMIC:
        return found in (Type.STRING, Type.JOINTS)
    if found is Type.DYNAMIC:
        return wanted in (Type.STRING, Type.JOINTS) and isinstance(argument, Name | Element)
    return True


def _at_the_call(resolver: Resolver) -> Severity:
    """Return how bad too many arguments are: AS takes the program, and stops at the call."""
    return Severity.WARNING if resolver.dialect.is_as else Severity.ERROR


def _undefined_program(resolver: Resolver, name: Name, suggestions: _Suggestions) -> None:
    problems = resolver.problems
    if "" in resolver.scope.programs:
        return  # it may be the one whose header has no name
    if resolver.dialect.is_vplus and name.text.upper() in never_names(resolver.dialect):
        _keyword(resolver, (name.start, name.end), name.text.upper(), "the name of a program")
        return
    meant = suggestions.program(key(name.text))
    entry = resolver.scope.entries.get(key(name.text))
    help_ = f"did you mean `{meant}`?" if meant else f"write `.PROGRAM {name.text}`"
    if entry is not None and entry.writes and entry.type is Type.POSE:
        meant, help_ = None, f"`{name.text}` is a location: write `MOVE {name.text}`"
    problems.warning(
        UNDEFINED_PROGRAM,
        f"there is no program `{name.text}` in this file",
        name.start,
        name.end,
        notes=("the controller says *Undefined program or variable name* when it gets here",),
        help=(help_,),
        fix=problems.replace(name.start, name.end, meant) if meant else None,
        data={"name": name.text.lower()},
    )


_WORDS = {
    Type.REAL: "a number",
    Type.STRING: "a string",
    Type.POSE: "a location",
    Type.JOINTS: "a precision point",
    Type.DYNAMIC: "a number or a location",
}
