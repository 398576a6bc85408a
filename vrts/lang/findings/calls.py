"""Programs and who calls them: names that are words, and ends that go nowhere."""

from collections.abc import Iterator

from vrts.base.diagnostic import Rule
from vrts.lang.findings.arguments import ARGUMENT_COUNT
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    CallNamed,
    CallStatement,
    ReactStatement,
    Rest,
    Simple,
    Statement,
)
from vrts.lang.vocabulary.lookup import instructions_of

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


def check_reactions(problems: Problems, scope: Scope) -> None:
    """Warn of programs with arguments that REACT or REACTI names: nothing gives them values."""
    if problems.dialect.tolerant:
        return
    for node in _statements(list(scope.programs.values())):
        if not isinstance(node, ReactStatement):
            continue
        name = node.operands[1] if node.operands[1:] else None
        program = scope.programs.get(key(name.text)) if isinstance(name, Name) else None
        if program is None or not program.formals or not program.sound:
            continue
        assert isinstance(name, Name)
        formals = [scope.formals[program.name].get(key(f.name.text)) for f in program.formals]
        if not any(f is not None and f.reads and not f.writes and not f.asked for f in formals):
            continue
        problems.warning(
            ARGUMENT_COUNT,
            f"{node.word} calls `{program.name}` without arguments, and it takes some",
            name.start,
            name.end,
            secondary=(problems.label(program.start, program.end, "the program begins here"),),
            notes=("an argument left out has no value: the controller stops where it is used",),
            help=(
                f"leave the arguments out of its header: `.PROGRAM {program.name}()`",
                "all programs know the same variables: give one a value before, and use it there",
            ),
        )


def check_error_returns(problems: Problems, programs: list[ProgramText]) -> None:
    """Warn of RETURNE in a program that is called, where no REACTE names a program for errors."""
    returning = [program for program in programs if _returns_error(program)]
    if not returning:
        return
    called: set[str] = set()
    for node in _statements(programs):
        if isinstance(node, Rest | CallNamed) or (
            isinstance(node, Simple) and node.word == "REACTE"
        ):
            return
        if isinstance(node, CallStatement):
            called.add(key(node.program.text))
    for program in returning:
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


def _returns_error(program: ProgramText) -> bool:
    nodes = [step.statement for step in program.steps]
    return any(isinstance(node, Simple) and node.word == "RETURNE" for node in nodes)


def _statements(programs: list[ProgramText]) -> Iterator[Statement]:
    return (s.statement for p in programs for s in p.steps if s.statement is not None)
