"""Which steps a program has, and the words they begin with: comments and blank lines are none."""

from typing import NamedTuple

from vrts.base.remembered import remembered
from vrts.base.source import SourceFile, Span
from vrts.base.stack import deep_stack
from vrts.lang.problems import Problems
from vrts.lang.reading.detection import detect
from vrts.lang.reading.headers import is_remarks, read_header
from vrts.lang.reading.splitter import split
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax import statements


class WrittenStep(NamedTuple):
    """A step that is more than a comment."""

    program: str  # lower case
    number: int  # as the controller numbers lines
    words: tuple[str, ...]  # instructions in it, written in full: ("IF", "GOTO")
    span: Span


def written_steps(source: SourceFile) -> tuple[WrittenStep, ...]:
    """Return the steps of every program of a file that compiles, in the order of the text."""
    return remembered((written_steps, source.name, source.text), lambda: _read(source))


@deep_stack()
def _read(source: SourceFile) -> tuple[WrittenStep, ...]:
    problems = Problems(source, detect(source)[0])
    sections = [s for s in split(problems) if s.kind == "program"]
    sections = [s for s in sections if not is_remarks(s, problems.dialect)]
    names = [read_header(section, problems)[0] for section in sections]
    parser = StepParser(problems)
    parser.program_names = frozenset(names)
    return tuple(
        WrittenStep(name, step.number, _words(node), problems.span(node.start, node.end))
        for name, section in zip(names, sections, strict=True)
        for step in map(parser.step, section.lines)
        if (node := step.statement) is not None
    )


def _words(node: statements.Statement) -> tuple[str, ...]:
    match node:
        case statements.Assignment():
            return ()
        case statements.Goto(condition=condition):
            return ("GOTO",) if condition is None else ("IF", "GOTO")
        case (
            statements.SetLocation()
            | statements.HereStatement()
            | statements.ShiftStatement()
            | statements.PackStatement()
            | statements.If()
            | statements.While()
            | statements.Until()
            | statements.For()
            | statements.Case()
            | statements.ValueGroup()
            | statements.CallStatement()
            | statements.CallNamed()
        ):
            return (_OWN_WORD[type(node)],)
        case statements.Bad(word=None):
            return ()
        case _:
            return (str(node.word),)


_OWN_WORD: dict[type[statements.Statement], str] = {
    statements.SetLocation: "SET",
    statements.HereStatement: "HERE",
    statements.ShiftStatement: "SHIFT",
    statements.PackStatement: "PACK",
    statements.If: "IF",
    statements.While: "WHILE",
    statements.Until: "UNTIL",
    statements.For: "FOR",
    statements.Case: "CASE",
    statements.ValueGroup: "VALUE",
    statements.CallStatement: "CALL",
    statements.CallNamed: "CALLS",
}
