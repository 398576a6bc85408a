"""Questions about names that only the whole compilation answers."""

from bisect import bisect_right
from collections.abc import Callable

from vrts.base.diagnostic import Rule, Severity
from vrts.ir.values import Type
from vrts.lang.meaning.agreement import settle_types, type_of_argument
from vrts.lang.meaning.no_texts import report_no_texts
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import NAME_TRUNCATED, SIGNIFICANT, is_truncated, key
from vrts.lang.problems import LIMIT
from vrts.lang.spelling import nearest
from vrts.lang.syntax.expressions import Element, Item, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import CallStatement
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

REAL_AND_LOCATION = Rule("V201", "real-and-location")
UNDEFINED_LOCATION = Rule("V204", "undefined-location")
UNDEFINED_VARIABLE = Rule("V205", "undefined-variable")
UNDEFINED_PROGRAM = Rule("V206", "undefined-program")
ARGUMENT_COUNT = Rule("V207", "argument-count")
ARGUMENT_TYPE = Rule("V208", "argument-type")
UNUSED_NAME = Rule("V225", "unused-name")
ARRAY_AND_SCALAR = Rule("V213", "array-and-scalar")

MOST_NAMES = 2000  # with more names than this none is suggested
_MISMATCH = "VAL-II says *Program argument mismatch*"


def check_usage(resolver: Resolver, programs: list[ProgramText]) -> None:
    """Report what the uses of each name do not agree on, and what is never given a value."""
    decided = settle_types(resolver, programs)
    report_no_texts(resolver)
    suggestions = _Suggestions(resolver)
    bodies = sorted((p.start, p.finish[1]) for p in programs)
    clashes: set[int] = set()
    for entry in resolver.scope.all_entries():
        if _clash(resolver, entry):
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


def _clash(resolver: Resolver, entry: Entry) -> bool:
    problems = resolver.problems
    if Type.REAL in entry.types and Type.POSE in entry.types:
        if resolver.dialect.is_as and entry.slot is None:
            entry.both = True  # numbers and locations of AS have names of their own
            return False
        lines = {problems.source.line_of(place[0]) for place in entry.types.values()}
        if lines & resolver.wrong_lines:
            return True  # said there
        (first_type, first), (_, second) = sorted(entry.types.items(), key=lambda item: item[1])[:2]
        words = {Type.REAL: "a number", Type.POSE: "a location"}
        other = words[Type.POSE if first_type is Type.REAL else Type.REAL]
        problems.error(
            REAL_AND_LOCATION,
            f"`{entry.name}` is used both as a number and as a location",
            *second,
            f"{other} here",
            secondary=(problems.label(*first, f"{words[first_type]} here"),),
            notes=("numbers and locations share their names", "VAL-II says *Mixing of types*"),
            help=("give one of them another name",),
            data={"name": entry.name},
        )
        return True
    if entry.array is not None and entry.scalar is not None:
        first, second = sorted((entry.array, entry.scalar))
        problems.error(
            ARRAY_AND_SCALAR,
            f"`{entry.name}` is used both with and without an index",
            *second,
            secondary=(problems.label(*first, "first used here"),),
            help=("give the array or the single variable another name",),
            data={"name": entry.name},
        )
        return True
    return False


def _truncated(resolver: Resolver, entry: Entry) -> None:
    long = [(at, name) for name, at in entry.spellings.items() if is_truncated(name)]
    if not long:
        return
    long.sort()
    at, name = long[-1]
    problems = resolver.problems
    if len(long) > 1:
        problems.warning(
            NAME_TRUNCATED,
            f"`{name}` and `{long[0][1]}` are the same variable",
            *at,
            secondary=(problems.label(*long[0][0], "first here"),),
            notes=(f"only the first {SIGNIFICANT} characters of a name count",),
            help=("make them differ in their first characters",),
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
    kind = "location" if location else "string" if entry.type is Type.STRING else "variable"
    meant = suggestions.name(entry, lambda other: _could_be(other, entry))
    upper = entry.name.upper()
    if meant is not None:
        help_ = f"did you mean `{meant}`?"
    elif (
        location and upper in INSTRUCTIONS and INSTRUCTIONS[upper].terminal in ("WORD0", "SETTING0")
    ):
        help_ = f"{upper} is an instruction: write it alone"
    elif location:
        help_ = "give it a value in a .LOCATIONS section, or by SET or HERE"
    else:
        help_ = "give it a value before it is used"
    at = min(entry.reads)
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
            severity=_at_the_call(resolver),
        )
        return
    for i, argument in enumerate(node.arguments):
        formal = program.formals[i]
        if argument is None or not formal.name.text:
            continue
        secondary = (header,)
        whole = isinstance(argument, Element) and not argument.subscripts
        if formal.array and not isinstance(argument, Element):
            problem = f"argument {i + 1} of `{program.name}` is a whole array"
            help_ = "write the name of an array with empty brackets: `a[]`"
        elif whole and not formal.array:
            problem = f"argument {i + 1} of `{program.name}` is not an array"
            help_ = "name one element: `a[1]`"
        else:
            entry = scope.formals[program.name][key(formal.name.text)]
            wanted, found = entry.type, type_of_argument(resolver, caller.name, argument)
            if wanted is found or not _differ(wanted, found, argument):
                continue
            problem = f"argument {i + 1} of `{program.name}` is {_WORDS[wanted]}"
            help_ = f"this is {_WORDS[found]}"
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
        )


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
    meant = suggestions.program(key(name.text))
    problems.warning(
        UNDEFINED_PROGRAM,
        f"there is no program `{name.text}` in this file",
        name.start,
        name.end,
        notes=("the controller says *Undefined program or variable name* when it gets here",),
        help=(f"did you mean `{meant}`?" if meant else f"write `.PROGRAM {name.text}`",),
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
