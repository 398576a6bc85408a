"""Which steps a program has, and the words they begin with: comments and blank lines are none."""

from typing import NamedTuple

from vrts.base.source import SourceFile, Span
from vrts.base.stack import deep_stack
from vrts.lang.grammar import syntax
from vrts.lang.problems import Problems
from vrts.lang.reading.detection import detect
from vrts.lang.reading.headers import is_remarks, read_header
from vrts.lang.reading.splitter import split
from vrts.lang.steps.steps import StepParser


class WrittenStep(NamedTuple):
    """A step that is more than a comment."""

    program: str  # lower case
    number: int  # as the controller numbers lines
    words: tuple[str, ...]  # instructions in it, written in full: ("IF", "GOTO")
    span: Span


@deep_stack()
def written_steps(source: SourceFile) -> tuple[WrittenStep, ...]:
    """Return the steps of every program of a file that compiles, in the order of the text."""
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


def _words(node: syntax.Statement) -> tuple[str, ...]:
    match node:
        case syntax.Assignment():
            return ()
        case syntax.Goto(condition=condition):
            return ("GOTO",) if condition is None else ("IF", "GOTO")
        case (
            syntax.SetLocation()
            | syntax.HereStatement()
            | syntax.ShiftStatement()
            | syntax.PackStatement()
            | syntax.If()
            | syntax.While()
            | syntax.Until()
            | syntax.For()
            | syntax.Case()
            | syntax.ValueGroup()
            | syntax.CallStatement()
            | syntax.CallNamed()
        ):
            return (_OWN_WORD[type(node)],)
        case syntax.Bad(word=None):
            return ()
        case _:
            return (str(node.word),)


_OWN_WORD: dict[type[syntax.Statement], str] = {
    syntax.SetLocation: "SET",
    syntax.HereStatement: "HERE",
    syntax.ShiftStatement: "SHIFT",
    syntax.PackStatement: "PACK",
    syntax.If: "IF",
    syntax.While: "WHILE",
    syntax.Until: "UNTIL",
    syntax.For: "FOR",
    syntax.Case: "CASE",
    syntax.ValueGroup: "VALUE",
    syntax.CallStatement: "CALL",
    syntax.CallNamed: "CALLS",
}
