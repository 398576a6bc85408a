"""Single steps, as they are typed at the editor or after DO, and what programs refer to."""

from functools import lru_cache
from typing import Any, NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.lang.dialect import Dialect
from vrts.lang.meaning.structure import word_of
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.pasted_characters import report_pasted_characters
from vrts.lang.reading.sections.lines import Line, comment_start
from vrts.lang.reading.splitter import LINE_TOO_LONG
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.expressions import Name, Text
from vrts.lang.syntax.program import Step
from vrts.lang.syntax.statements import (
    Bad,
    CallNamed,
    CallStatement,
    Goto,
    ReactStatement,
    Rest,
    Simple,
    Structure,
)

NOT_ALONE = Rule("V522", "not-alone")

_RETURNS = frozenset({"RETURN", "RETURNE", "EXIT", "NEXT"})
_PROGRAM_WORDS = frozenset({"PCEXECUTE", "REACTE"})


class References(NamedTuple):
    """Names in a program, as far as its lines can be read."""

    variables: frozenset[str]  # as Global.name
    programs: frozenset[str]


@deep_stack()
def check_step(
    text: str, dialect: Dialect, program_names: frozenset[str] = frozenset()
) -> tuple[Diagnostic, ...]:
    """Return what is wrong with the form of one step; names and structure are not looked at."""
    problems = Problems(SourceFile("step", text), dialect)
    _step(_parser(problems, program_names), text, 0)
    report_pasted_characters(problems)
    return problems.in_order()


@deep_stack()
def check_alone(text: str, dialect: Dialect) -> tuple[Diagnostic, ...]:
    """Return what is wrong with the form of an instruction that is carried out by itself."""
    problems = Problems(SourceFile("DO", text), dialect)
    step = _step(_parser(problems, frozenset()), text, 0)
    report_pasted_characters(problems)
    if step is None or problems.any_error:
        return problems.in_order()
    node = step.statement
    wordy = isinstance(node, Goto | Structure) or word_of(step) is not None
    leaves = isinstance(node, Simple) and node.word in _RETURNS
    if step.label is not None or wordy or leaves:
        problems.error(
            NOT_ALONE,
            "a label has no place here" if step.label is not None else "this needs its program",
            0,
            len(text),
            notes=("VAL-II says *Illegal in DO*",),
            help=("write it in a program, with EDIT",),
        )
    return problems.in_order()


@deep_stack()
def bad_steps(
    lines: tuple[str, ...], dialect: Dialect, program_names: frozenset[str]
) -> frozenset[int]:
    """Return the numbers, from 1, of the steps whose form is wrong."""
    bad: set[int] = set()
    problems = Problems(SourceFile("steps", "\n".join(lines)), dialect)
    parser = _parser(problems, program_names)
    at = 0
    for number, text in enumerate(lines, 1):
        before = len(problems.found), len(problems.look_alikes)
        _step(parser, text, at)
        fresh = problems.found[before[0] :]
        if any(d.is_error for d in fresh) or len(problems.look_alikes) > before[1]:
            bad.add(number)
        at += len(text) + 1
    return frozenset(bad)


@lru_cache(256)
@deep_stack()
def references(lines: tuple[str, ...], dialect: Dialect) -> References:
    """Return the variables and programs that the lines of a program name."""
    variables: set[str] = set()
    programs: set[str] = set()
    parser = _parser(Problems(SourceFile("steps", "\n".join(lines)), dialect), frozenset())
    at = 0
    for text in lines:
        step = _step(parser, text, at)
        at += len(text) + 1
        node = step.statement if step is not None else None
        if isinstance(node, Bad | Rest):
            variables.update(node.names)
            programs.update(node.names)
        elif isinstance(node, CallStatement):
            programs.add(key(node.program.text))
            variables.update(_names(node.arguments))
        elif isinstance(node, CallNamed):
            programs.update([key(node.program.value)] if isinstance(node.program, Text) else ())
            variables.update(_names(node))
        elif node is not None:
            names = _names(node)
            variables.update(names)
            reacts = isinstance(node, ReactStatement)
            if reacts or (isinstance(node, Simple) and node.word in _PROGRAM_WORDS):
                programs.update(names)
    return References(frozenset(variables), frozenset(programs))


def _parser(problems: Problems, program_names: frozenset[str]) -> StepParser:
    parser = StepParser(problems)
    parser.program_names = program_names
    return parser


def _step(parser: StepParser, text: str, at: int) -> Step | None:
    """Return the step of a line that begins at an offset; None when there is none, or a bad one."""
    problems, dialect = parser.problems, parser.dialect
    cut = comment_start(text)
    body = text if cut < 0 else text[:cut]
    bare = body.strip()
    start = at + len(body) - len(body.lstrip())
    if len(bare) > dialect.max_line:
        problems.error(
            LINE_TOO_LONG,
            f"this line has {len(bare):,} characters; a line has at most {dialect.max_line}",
            start,
            start + 40,
        )
        return None
    if not bare:
        return None
    if bare.startswith(".") and not dialect.has("a"):
        problems.error(
            NOT_ALONE,
            "a step begins with no period",
            start,
            start + len(bare),
            notes=("VAL-II says *Unknown instruction*",),
            help=("the editor writes `.PROGRAM` and `.END` itself; E leaves it",),
        )
        return None
    return parser.step(Line(1, bare, start, start + len(bare)))


def _names(node: Any) -> set[str]:
    """Return every name in a node, as the controller keeps names."""
    found: set[str] = set()
    waiting: list[Any] = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Name):
            found.update([key(part.text)] if part.text else ())
        else:
            waiting += [inner for inner in part if isinstance(inner, tuple)]
    return found
