"""Monitor commands and expressions through the same door as programs.

Of the commands, the one that the controller takes so far: EXECUTE.
"""

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.ir.commands import Command, Execute
from vrts.lang.build import builders
from vrts.lang.constants import number_of
from vrts.lang.lalr import Failure, TableParser
from vrts.lang.mistakes import explain
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax import Item, Token
from vrts.lang.tokens import tokenise

INVALID_COMMAND = Rule("V153", "invalid-command")

_USAGE = "write EXECUTE program, cycles, step"


def parse_command(source: SourceFile) -> tuple[Command | None, tuple[Diagnostic, ...]]:
    """Return the command of a line, None with what is wrong with it."""
    problems = Problems(source)
    command = None
    raw = tokenise(source.text, 0, problems)
    if raw:
        first = raw[0]
        if len(first.text) < 2 or not "EXECUTE".startswith(first.text.upper()):
            problems.error(
                INVALID_COMMAND,
                f"`{first.text}` is not a command",
                first.start,
                first.end,
                notes=("VAL-II says *Illegal monitor command*",),
                help=(_USAGE,),
            )
        else:
            command = _execute(problems, raw)
    return command, problems.in_order()


def _execute(problems: Problems, raw: list[Token]) -> Command | None:
    tokens = [t._replace(kind="NAME") if t.kind == "WORD" else t for t in raw]
    tokens[0] = tokens[0]._replace(kind="EXECUTE")
    parts = TableParser(builders(problems)).parse("command", tokens)
    if isinstance(parts, Failure):
        explain(problems, tokens, parts, None)
        return None
    operands: list[Item | None] = parts[3] if len(parts) > 3 else []
    numbers = [number_of(operand) for operand in operands]
    fitting = [n is not None or o is None for n, o in zip(numbers, operands, strict=True)]
    if len(parts) > 1 and len(operands) <= 2 and all(fitting):
        cycles, step = (*(n if n is None else round(n) for n in numbers), None, None)[:2]
        return Execute(key(parts[1].text), 1 if cycles is None else cycles, step or 1)
    problems.error(
        INVALID_COMMAND,
        "EXECUTE needs a program" if len(parts) == 1 else "the operands of EXECUTE do not fit",
        tokens[0].start,
        tokens[-1].end,
        notes=("VAL-II says *Illegal value*",),
        help=(_USAGE,),
    )
    return None
