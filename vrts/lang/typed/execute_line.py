"""The command by which runs are started: EXECUTE, from its line to a value."""

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.ir.commands import Command, Execute
from vrts.lang.meaning.constants import number_of
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Item, Name
from vrts.lang.typed.commands import INVALID_COMMAND, CommandLine, FileName, read_command

_USAGE = "write EXECUTE program, cycles, step"


def parse_command(source: SourceFile) -> tuple[Command | None, tuple[Diagnostic, ...]]:
    """Return the command of a line, None with what is wrong with it; only EXECUTE is taken."""
    line, found = read_command(source)
    if line is None:
        return None, found
    problems = Problems(source)
    command = None
    if line.word.text == "EXECUTE":
        command = _execute(problems, line)
    else:
        _refuse(problems, line, f"{line.word.text} starts no program", "Illegal monitor command")
    return command, (*found, *problems.in_order())


def _execute(problems: Problems, line: CommandLine) -> Command | None:
    program, *operands = line.operands or (None,)
    numbers = [_number(operand) for operand in operands]
    fitting = [n is not None or o is None for n, o in zip(numbers, operands, strict=True)]
    fit = line.values is None and len(operands) <= 2 and all(fitting)
    if fit and isinstance(program, Name) and program.text[0] not in "$#":
        cycles, step = (*numbers, None, None)[:2]
        return Execute(key(program.text), 1 if cycles is None else cycles, step or 1)
    wrong = "the operands of EXECUTE do not fit" if line.operands else "EXECUTE needs a program"
    _refuse(problems, line, wrong, "Illegal value")
    return None


def _number(operand: Item | FileName | None) -> int | None:
    value = None if isinstance(operand, FileName) else number_of(operand)
    return None if value is None else round(value)


def _refuse(problems: Problems, line: CommandLine, headline: str, words: str) -> None:
    problems.error(
        INVALID_COMMAND,
        headline,
        line.start,
        line.end,
        notes=(f"VAL-II says *{words}*",),
        help=(_USAGE,),
    )
