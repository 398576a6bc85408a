"""One line of the monitor to a command: its word, and its operands as far as grammar tells.

What the operands mean, and whether the controller can do it now, is the monitor's business.
"""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.lang.dialect import VAL2, Dialect, titles
from vrts.lang.grammar.build import builders
from vrts.lang.grammar.lalr import Failure, TableParser
from vrts.lang.problems import Problems
from vrts.lang.reading.classify import is_assigned
from vrts.lang.reading.nesting import MAX_NESTING, too_deep
from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.reading.tokeniser import tokenise
from vrts.lang.spelling import nearest
from vrts.lang.steps.mistakes import explain
from vrts.lang.steps.step_parser import operands_only
from vrts.lang.syntax.expressions import Item
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.commands import COMMANDS, look_up_command
from vrts.lang.vocabulary.lookup import spellings
from vrts.lang.vocabulary.relatives_commands import commands_of, languages_of
from vrts.lang.vocabulary.word import Word

INVALID_COMMAND = Rule("V153", "invalid-command")
UNKNOWN_COMMAND = Rule("V520", "unknown-command")
AMBIGUOUS_COMMAND = Rule("V521", "ambiguous-command")

MAX_LINE = 255  # characters [manual language/monitor#line]
_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_FILE = re.compile(r'[ \t]*(?:"(?P<quoted>[^"]*)"|(?P<bare>[^\s="]+))')
_ILLEGAL_SAYS = "VAL-II says *Illegal monitor command*"


class FileName(NamedTuple):
    """A file that a command names."""

    text: str
    start: int
    end: int


class CommandLine(NamedTuple):
    """A command as typed. Ranges are offsets in the line."""

    word: Word
    operands: tuple[Item | FileName | None, ...]  # None where one is left out
    values: tuple[Item | FileName | None, ...] | None  # behind `=`; None: there is no `=`
    rest: str  # all that follows the word, without the comment
    start: int  # of the word
    rest_start: int
    end: int


@deep_stack()
def read_command(
    source: SourceFile, dialect: Dialect = VAL2
) -> tuple[CommandLine | None, tuple[Diagnostic, ...]]:
    """Return the command of a line; None for an empty one, and with what is wrong. Never raises."""
    problems = Problems(source, dialect)
    text = source.text
    cut = comment_start(text)
    body = (text if cut < 0 else text[:cut]).rstrip()
    if len(body) > MAX_LINE:
        problems.error(
            INVALID_COMMAND,
            f"this line has {len(body):,} characters; a command has at most {MAX_LINE}",
            0,
            40,
            notes=(_ILLEGAL_SAYS,),
        )
        return None, problems.in_order()
    found = _command(problems, body) if body.strip() else None
    return (None if problems.any_error else found), problems.in_order()


def _command(problems: Problems, body: str) -> CommandLine | None:
    start = len(body) - len(body.lstrip())
    match = _WORD.match(body, start)
    if match is None:
        _unknown(problems, start, len(body))
        return None
    if _assigns(problems, body, start):
        return _assignment(problems, body, start)
    found = look_up_command(match.group())
    if found.word is None:
        if found.candidates:
            _ambiguous(problems, match, [word.text for word in found.candidates])
        else:
            _unknown(problems, start, match.end())
        return None
    at = match.end()
    rest = body[at:].lstrip()
    rest_start = len(body) - len(rest) if rest else at
    bare = CommandLine(found.word, (), None, rest, start, rest_start, len(body))
    match found.word.terminal:
        case "NONE":
            if rest:
                _takes_none(problems, found.word, rest_start, len(body))
            return bare
        case "LIST":
            return _operands(problems, bare, body)
        case "FILE":
            return _files(problems, bare, body)
        case _:  # an instruction follows, or what is not read at all
            return bare


def _assigns(problems: Problems, body: str, start: int) -> bool:
    """Whether a line gives a variable a value."""
    quiet = Problems(problems.source, problems.dialect)
    tokens = tokenise(body[start:], start, quiet) if "=" in body else None
    return is_assigned(tokens) if tokens else False


def _assignment(problems: Problems, body: str, start: int) -> CommandLine | None:
    """`n = 5` without DO: VAL-II does not take it [manual language/monitor#assignment]."""
    if not problems.dialect.tolerant:
        problems.error(
            UNKNOWN_COMMAND,
            "an assignment is no command",
            start,
            len(body),
            notes=(_ILLEGAL_SAYS,),
            help=(f"write `DO {body[start:]}`",),
            fix=problems.replace(start, start, "DO "),
        )
        return None
    return CommandLine(COMMANDS["DO"], (), None, body[start:], start, start, len(body))


def _operands(problems: Problems, bare: CommandLine, body: str) -> CommandLine | None:
    tokens = tokenise(body[bare.rest_start :], bare.rest_start, problems) if bare.rest else []
    if tokens is None or problems.any_error:
        return None
    word = Token("COMMAND", bare.word.text, bare.start, bare.rest_start)
    tokens = [word, *(operands_only(tokens) if tokens else [])]
    parts = TableParser(builders(problems, problems.dialect.precedence)).parse("command", tokens)
    if isinstance(parts, Failure):
        explain(problems, tokens, parts, None)
        return None
    if len(tokens) > MAX_NESTING:
        for node in (*parts[0], *(parts[1] or ())):
            if node is not None and too_deep(problems, node):
                return None
    return bare._replace(operands=parts[0], values=parts[1])


def _files(problems: Problems, bare: CommandLine, body: str) -> CommandLine | None:
    """`LOAD file`, `STORE file = program, program`, `FCOPY new = old`."""
    if not bare.rest:
        return bare
    first = _file(problems, body, bare.rest_start)
    if first is None:
        return None
    after = body[first.end :].lstrip(' \t"')
    at = len(body) - len(after)
    if not after:
        return bare._replace(operands=(first,))
    if not after.startswith("="):
        _takes_one(problems, bare.word, at, len(body))
        return None
    if bare.word.text.startswith("F"):
        second = _file(problems, body, at + 1)
        return None if second is None else bare._replace(operands=(first,), values=(second,))
    named = bare._replace(rest=after, rest_start=at)
    found = _operands(problems, named, body)
    return None if found is None else bare._replace(operands=(first,), values=found.values)


def _file(problems: Problems, body: str, at: int) -> FileName | None:
    match = _FILE.match(body, at)
    if match is None:
        problems.error(
            INVALID_COMMAND,
            "here the name of a file belongs",
            at,
            len(body),
            notes=("VAL-II says *Missing argument*",),
            help=('write it as in `LOAD pick` or `LOAD "pick it.v2"`',),
        )
        return None
    kind = "quoted" if match["quoted"] is not None else "bare"
    return FileName(match[kind], match.start(kind), match.end(kind))


# --- wording --------------------------------------------------------------------------------------


def _unknown(problems: Problems, start: int, end: int) -> None:
    written = problems.source.text[start:end][:40]
    upper = written.upper()
    close = nearest(upper, COMMANDS) if upper.isascii() else None
    if upper in commands_of(problems.dialect):
        _of_relatives(problems, start, end, upper)
        return
    if upper in spellings(problems.dialect):
        whole = problems.source.text[start:].strip()
        help_ = (f"this is an instruction: `DO {whole[:60]}` carries it out",)
    elif close is not None:
        help_ = (f"did you mean `{close}`?",)
    else:
        help_ = ("a command is a word such as `EXECUTE main`, `WHERE` or `LISTP`",)
    problems.error(
        UNKNOWN_COMMAND,
        f"`{written}` is not a command",
        start,
        end,
        notes=(_ILLEGAL_SAYS,),
        help=help_,
        fix=problems.replace(start, end, close) if close is not None else None,
        data={"word": written},
    )


def _of_relatives(problems: Problems, start: int, end: int, upper: str) -> None:
    """Report a command that only the monitors of V+ or AS have."""
    problems.error(
        UNKNOWN_COMMAND,
        f"{upper} is a command of {titles(languages_of(upper))}, and not simulated",
        start,
        end,
        f"there it serves to {commands_of(problems.dialect)[upper]}",
        notes=(_ILLEGAL_SAYS,),
        help=("`vrts support --kind command` lists the commands that are carried out",),
        data={"word": upper},
    )


def _ambiguous(problems: Problems, match: re.Match[str], texts: list[str]) -> None:
    shown = texts[:6] + (["others"] if len(texts) > 6 else [])
    problems.error(
        AMBIGUOUS_COMMAND,
        f"`{match.group()}` can be short for {', '.join(shown[:-1])} or {shown[-1]}",
        match.start(),
        match.end(),
        notes=("VAL-II says *Ambiguous keyword*",),
        help=("write more of the word",),
    )


def _takes_none(problems: Problems, word: Word, start: int, end: int) -> None:
    problems.error(
        INVALID_COMMAND,
        f"{word.text} takes no operand",
        start,
        end,
        notes=("VAL-II says *Unexpected text at end of line*",),
        help=(f"write `{word.text}` alone",),
    )


def _takes_one(problems: Problems, word: Word, start: int, end: int) -> None:
    problems.error(
        INVALID_COMMAND,
        f"{word.text} takes one file here",
        start,
        end,
        notes=("VAL-II says *Unexpected text at end of line*",),
        help=(f"write `{word.usage}`; a name with blanks stands in quotes",),
    )
