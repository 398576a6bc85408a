"""Programs and who calls them: names that are words, and ends that go nowhere."""

from collections.abc import Iterator

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.name_uses import KEYWORD_AS_NAME
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import CallNamed, CallStatement, Rest, Simple, Statement
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
