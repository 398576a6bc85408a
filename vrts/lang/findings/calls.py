"""Programs and their calls: names that are words, arguments left out, and in another order."""

from collections.abc import Iterator

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.agreement import type_of_argument
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import CallNamed, CallStatement, Rest, Simple, Statement
from vrts.lang.vocabulary.lookup import instructions_of

ARGUMENT_COUNT = Rule("V207", "argument-count")
NO_ERROR_PROGRAM = Rule("V244", "no-error-program")


def named_as_word(resolver: Resolver, program: ProgramText) -> None:
    """Warn of a program with the name of an instruction."""
    upper = program.name.upper()
    words = instructions_of(resolver.dialect)
    if resolver.dialect.tolerant or upper not in words or not program.sound:
        return
    resolver.problems.warning(
        KEYWORD_AS_NAME,
        f"{upper} is a word of the language, here it names a program",
        program.start,
        program.end,
        help=("choose another name",),
    )


def too_few(resolver: Resolver, node: CallStatement, program: ProgramText) -> None:
    """Warn of arguments left out that the program needs: it neither asks for them nor sets them."""
    formals = resolver.scope.formals[program.name]
    names = [f.name.text for f in program.formals[len(node.arguments) :] if f.name.text]
    entries = [formals[key(name)] for name in names]
    if not any(e.reads and not e.writes and not e.asked for e in entries):
        return
    problems = resolver.problems
    given, taken = len(node.arguments), len(program.formals)
    problems.warning(
        ARGUMENT_COUNT,
        f"`{program.name}` takes {taken} argument{'' if taken == 1 else 's'}, {given} given",
        node.start,
        node.end,
        secondary=(problems.label(program.start, program.end, "the program begins here"),),
        notes=("an argument left out has no value: the controller stops where it is used",),
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
        if formals[key(formal.name.text)].type is not type_of_argument(
            resolver, caller.name, argument
        ):
            return ""
    first, second = (text[a.start : a.end] for a in node.arguments if a is not None)
    return f"CALL {node.program.text}({second}, {first})"


def check_error_returns(problems: Problems, programs: list[ProgramText]) -> None:
    """Warn of RETURNE in a program that is called, where no REACTE names a program for errors."""
    called: set[str] = set()
    for node in _statements(programs):
        if isinstance(node, Rest | CallNamed) or (
            isinstance(node, Simple) and node.word == "REACTE"
        ):
            return
        if isinstance(node, CallStatement):
            called.add(key(node.program.text))
    for program in programs:
        if program.name not in called:
            continue
        for node in _statements([program]):
            if isinstance(node, Simple) and node.word == "RETURNE":
                problems.warning(
                    NO_ERROR_PROGRAM,
                    "RETURNE ends a program that REACTE names, and this one is called",
                    node.start,
                    node.end,
                    notes=("VAL-II says *Illegal RETURNE*",),
                    help=("write RETURN to go back to the CALL",),
                    fix=problems.replace(node.start, node.end, "RETURN"),
                )


def _statements(programs: list[ProgramText]) -> Iterator[Statement]:
    return (s.statement for p in programs for s in p.steps if s.statement is not None)
