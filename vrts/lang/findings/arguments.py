"""Arguments of CALL beside what the program takes: how many, of which types, in which order."""

from typing import NamedTuple

from vrts.base.diagnostic import Fix, Label, Rule, Severity
from vrts.ir.values import Type
from vrts.lang.decimal_commas import likeliest
from vrts.lang.findings.mixed_kinds import kind_of_number
from vrts.lang.meaning.agreement import type_of_argument
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.roles import role_of
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.meaning.type_mistakes import NAME, NUMBER
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Element, Item, Name, Number, Parenthesised, Text
from vrts.lang.syntax.program import Formal, ProgramText
from vrts.lang.syntax.statements import CallStatement

ARGUMENT_COUNT = Rule("V207", "argument-count")
ARGUMENT_TYPE = Rule("V208", "argument-type")
VALUE_LOST = Rule("V269", "value-lost")

_MISMATCH = "VAL-II says *Program argument mismatch*"
_WORDS = {
    Type.REAL: "a number",
    Type.STRING: "a string",
    Type.POSE: "a location",
    Type.JOINTS: "a precision point",
    Type.DYNAMIC: "a number or a location",
}


class _Wrong(NamedTuple):
    """What is wrong with an argument."""

    headline: str
    help: tuple[str, ...]
    fix: Fix | None
    secondary: tuple[Label, ...]


def check_arguments(
    resolver: Resolver,
    caller: ProgramText,
    node: CallStatement,
    program: ProgramText,
    decided: dict[int, Place],
) -> None:
    """Report arguments that a program does not take, at most one of each call."""
    if not program.sound:
        return  # which arguments it takes is not known
    problems = resolver.problems
    if len(node.arguments) > len(program.formals):
        _too_many(resolver, node, program)
        return
    for place, (argument, formal) in enumerate(zip(node.arguments, program.formals, strict=False)):
        if argument is None or not formal.name.text:
            continue
        wrong = _array(resolver, program, place, argument, formal) or _type(
            resolver, caller, node, program, place, argument, decided
        )
        if wrong is not None:
            problems.error(
                ARGUMENT_TYPE,
                wrong.headline,
                argument.start,
                argument.end,
                secondary=wrong.secondary,
                notes=(_MISMATCH,),
                help=wrong.help,
                fix=wrong.fix,
            )
            return
    _by_value(resolver, caller, node, program)
    few = len(node.arguments) < len(program.formals)
    if few and (problems.dialect.is_as or not problems.dialect.tolerant):
        _too_few(resolver, node, program)


def _by_value(
    resolver: Resolver, caller: ProgramText, node: CallStatement, program: ProgramText
) -> None:
    """Warn of `CALL measure((h))`, where the program gives its argument a value."""
    if resolver.dialect.tolerant:
        return  # there it is the way to protect a variable
    formals = resolver.scope.formals[program.name]
    for argument, formal in zip(node.arguments, program.formals, strict=False):
        inner = argument
        while isinstance(inner, Parenthesised):
            inner = inner.inner
        if inner is argument or not isinstance(inner, Name | Element) or not formal.name.text:
            continue
        entry = formals[key(formal.name.text)]
        if not entry.writes or _reads_first(resolver.problems, entry):
            continue  # that it may change for itself
        name = inner if isinstance(inner, Name) else inner.name
        kept = resolver.scope.entry(caller.name, key(name.text))
        if kept.passed or not any(start > node.end for start, _ in kept.reads):
            continue  # nothing waits for it
        problems = resolver.problems
        written = problems.source.text[inner.start : inner.end]
        assert argument is not None
        resolver.bad_names.add(kept.name)  # this is why it has no value
        problems.warning(
            VALUE_LOST,
            f"`{written}` does not get the value that `{program.name}` gives to its argument",
            argument.start,
            argument.end,
            "in parentheses its value is passed, and not the variable",
            secondary=(problems.label(*min(entry.writes), "given a value here"),),
            help=(f"leave the parentheses out: write `{written}`",),
            fix=problems.replace(argument.start, argument.end, written),
        )


def _reads_first(problems: Problems, entry: Entry) -> bool:
    """Whether a program reads its argument before it gives it a value, as in `n = n+1`."""
    text = problems.source.text
    end = text.find("\n", min(entry.writes)[0])
    return any(start < (end if end >= 0 else len(text)) for start, _ in entry.reads)


def _too_many(resolver: Resolver, node: CallStatement, program: ProgramText) -> None:
    problems = resolver.problems
    given, taken = len(node.arguments), len(program.formals)
    text = problems.source.text
    kept = ", ".join(text[a.start : a.end] if a is not None else "" for a in node.arguments[:taken])
    call = f"CALL {node.program.text}({kept})" if taken else f"CALL {node.program.text}"
    help_ = f"leave {given - taken} of them out: write `{call}`"
    pointed = likeliest(text[node.start : node.end], given - taken)
    if pointed:
        help_ = f"a comma is no decimal sign: write a point, as in `{pointed.text}`"
    problems.error(
        ARGUMENT_COUNT,
        f"`{program.name}` takes {taken or 'no'} argument{'' if taken == 1 else 's'}, "
        f"{given} given",
        node.start,
        node.end,
        secondary=(_header(resolver, program),),
        notes=(_MISMATCH,),
        help=(help_,),
        fix=problems.replace(node.start, node.end, pointed.text, sure=pointed.sure)
        if pointed
        else None,
        severity=_at_the_call(resolver),
    )


def _header(resolver: Resolver, program: ProgramText) -> Label:
    return resolver.problems.label(program.start, program.end, "the program begins here")


def _array(
    resolver: Resolver, program: ProgramText, place: int, argument: Item, formal: Formal
) -> _Wrong | None:
    """A single value where a whole array belongs, and the other way round."""
    problems = resolver.problems
    header = (_header(resolver, program),)
    if formal.array and not isinstance(argument, Element):
        shown = argument.text if isinstance(argument, Name) else "a"
        return _Wrong(
            f"argument {place + 1} of `{program.name}` is a whole array",
            (f"write the name of an array with empty brackets: `{shown}[]`",),
            problems.replace(argument.end, argument.end, "[]")
            if isinstance(argument, Name)
            else None,
            header,
        )
    if isinstance(argument, Element) and not argument.subscripts and not formal.array:
        return _Wrong(
            f"argument {place + 1} of `{program.name}` is not an array",
            (f"name one element: `{argument.name.text}[1]`",),
            None,
            header,
        )
    return None


def _type(
    resolver: Resolver,
    caller: ProgramText,
    node: CallStatement,
    program: ProgramText,
    place: int,
    argument: Item,
    decided: dict[int, Place],
) -> _Wrong | None:
    """An argument of another type than its program takes."""
    problems = resolver.problems
    formal = program.formals[place]
    entry = resolver.scope.formals[program.name][key(formal.name.text)]
    wanted, found = entry.type, type_of_argument(resolver, caller.name, argument)
    if formal.array or wanted is found or not _differ(wanted, found, argument):
        return None
    secondary: tuple[Label, ...] = (_header(resolver, program),)
    if id(entry) in decided:
        first = problems.label(*decided[id(entry)], f"{_WORDS[wanted]} here")
        secondary = (first, problems.label(program.start, program.end, "it is open here"))
    headline = f"argument {place + 1} of `{program.name}` is {_WORDS[wanted]}"
    other = swapped(resolver, caller, node, program)
    if other:
        return _Wrong(
            headline,
            (f"write the arguments in the order of the program: `{other}`",),
            problems.replace(node.start, node.end, other),
            secondary,
        )
    instead = _instead(resolver, argument, wanted, found)
    text = problems.source.text
    if instead:
        call = text[node.start : argument.start] + instead + text[argument.end : node.end]
        return _Wrong(
            f"{headline}, not {_WORDS[found]}",
            (f"write a string there: `{call}`" if instead[0] == '"' else f"write `{call}`",),
            problems.replace(argument.start, argument.end, instead),
            secondary,
        )
    what = _meaning(resolver, wanted, entry)
    help_ = f"`{formal.name.text}` of `{as_header(program)}` is {what}"
    if wanted is Type.REAL and found in (Type.POSE, Type.JOINTS):
        call = text[node.start : argument.start] + "50" + text[argument.end : node.end]
        help_ += f": write a number there, as in `{call}`"
    elif wanted is Type.REAL and found is Type.STRING:
        help_ += f": write one there, or name it `${formal.name.text}` to take a string"
    else:
        help_ += ": write one there"
    return _Wrong(f"{headline}, not {_WORDS[found]}", (help_,), None, secondary)


def _instead(resolver: Resolver, argument: Item, wanted: Type, found: Type) -> str:
    """Return what to write for an argument, where its text tells; else nothing."""
    node = argument
    while isinstance(node, Parenthesised):
        node = node.inner
    written = resolver.problems.source.text[argument.start : argument.end]
    if wanted is Type.STRING and found is Type.REAL:
        return f'"{written}"' if isinstance(node, Number) else f"$ENCODE({written})"
    if found is not Type.STRING:
        return ""
    inner = node.value.strip() if isinstance(node, Text) else ""
    if wanted is Type.REAL:
        if isinstance(node, Text):
            return inner if NUMBER.fullmatch(inner) else ""
        return f"VAL({written})"
    return inner if NAME.fullmatch(inner) else ""


def _meaning(resolver: Resolver, wanted: Type, entry: Entry) -> str:
    """Return what a formal is for, by the first use that tells."""
    place = entry.types.get(wanted)
    role = role_of(resolver.scope.programs.values(), place) if place is not None else None
    if wanted is Type.REAL and role is not None:
        return kind_of_number(role)
    return _WORDS[wanted]


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


def _too_few(resolver: Resolver, node: CallStatement, program: ProgramText) -> None:
    """Warn of arguments left out that the program needs: it neither asks for them nor sets them.

    AS wants as many as the program takes [AS manual, appendix of error messages, P0137].
    """
    formals = resolver.scope.formals[program.name]
    names = [f.name.text for f in program.formals[len(node.arguments) :] if f.name.text]
    entries = [formals[key(name)] for name in names]
    problems = resolver.problems
    needed = any(e.reads and not e.writes and not e.asked for e in entries)
    if not needed and not problems.dialect.is_as:
        return
    lost = "an argument left out has no value: the controller stops where it is used"
    given, taken = len(node.arguments), len(program.formals)
    problems.warning(
        ARGUMENT_COUNT,
        f"`{program.name}` takes {taken} argument{'' if taken == 1 else 's'}, {given} given",
        node.start,
        node.end,
        secondary=(problems.label(program.start, program.end, "the program begins here"),),
        notes=(_MISMATCH if problems.dialect.is_as else lost,),
        help=(f"write the missing argument, too: `CALL {as_header(program)}`",),
    )


def as_header(program: ProgramText) -> str:
    """Return a program and its formals as a header writes them."""
    formals = ", ".join(f.name.text + "[]" * f.array for f in program.formals)
    return f"{program.name}({formals})" if formals else program.name


def swapped(
    resolver: Resolver, caller: ProgramText, node: CallStatement, program: ProgramText
) -> str:
    """Return a call of two arguments with these in the other order, if they fit then."""
    if len(node.arguments) != 2 or len(program.formals) != 2 or None in node.arguments:
        return ""
    text = resolver.problems.source.text
    formals = resolver.scope.formals[program.name]
    for formal, argument in zip(program.formals, reversed(node.arguments), strict=True):
        if argument is None or not formal.name.text or formal.array:
            return ""
        found = type_of_argument(resolver, caller.name, argument)
        wanted = formals[key(formal.name.text)].type
        open_ = found is Type.DYNAMIC and isinstance(argument, Name | Element)
        if wanted is not found and not (open_ and wanted in (Type.REAL, Type.POSE)):
            return ""
    first, second = (text[a.start : a.end] for a in node.arguments if a is not None)
    return f"CALL {node.program.text}({second}, {first})"
