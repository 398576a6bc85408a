"""Commands that execute programs and single instructions [manual language/monitor#execution]."""

from vrts.engine.programs.signals import INTERNAL, OUTPUTS
from vrts.ir.commands import (
    Abort,
    AbortProcess,
    Command,
    Do,
    EndCycle,
    EndProcess,
    Execute,
    ForceSignals,
    Kill,
    MonitorSpeed,
    Panic,
    Proceed,
    ProceedProcess,
    Retry,
    RetryProcess,
    RunSteps,
    StartProcess,
)
from vrts.lang.typed.commands import CommandLine
from vrts.lang.typed.entry import check_alone
from vrts.monitor import words
from vrts.monitor.commands.questions import sure
from vrts.monitor.desk import (
    Desk,
    Refused,
    Situation,
    Turn,
    one_step,
    program_name,
    real,
    whole,
)
from vrts.monitor.programs import StoredProgram

_MOST_CYCLES = 32767
_MOST_SPEED = 100.0  # %; V+ clips there [manual language/settings#monitor-limit]

PLAIN: dict[str, Command] = {
    "ABORT": Abort(),
    "CYCLE.END": EndCycle(),
    "KILL": Kill(),
    "PANIC": Panic(),
    "PCABORT": AbortProcess(),
    "PCPROCEED": ProceedProcess(),
    "PCRETRY": RetryProcess(),
    "PROCEED": Proceed(),
    "RETRY": Retry(),
}


def plain(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """Issue a command that takes no operand."""
    return Turn(commands=(PLAIN[line.word.text],))


def execute(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """EXECUTE [program] [, cycles [, step]]."""
    name, cycles, step = _program_and_counts(line, desk.last_executed, desk, now)
    desk.last_executed = name
    return Turn(commands=(Execute(name, cycles, step),))


def execute_process(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """PCEXECUTE [program] [, cycles [, step]]."""
    name, cycles, step = _program_and_counts(line, desk.last_process, desk, now)
    desk.last_process = name
    return Turn(commands=(StartProcess(name, cycles, step),))


def _program_and_counts(
    line: CommandLine, last: str | None, desk: Desk, now: Situation
) -> tuple[str, int, int]:
    first, *counts = line.operands or (None,)
    if len(counts) > 2 or line.values is not None:
        raise Refused(words.starred(words.UNEXPECTED_TEXT, f"write `{line.word.usage}`"))
    name = last if first is None else program_name(first)
    if name is None:
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    program = desk.program(name)
    if program.program is None:
        raise Refused(words.starred(words.NOT_EXECUTABLE, _why(program)))
    cycles, step = (*(whole(line, c, 1, desk, now) for c in counts), 1, 1)[:2]
    if not -_MOST_CYCLES - 1 <= cycles <= _MOST_CYCLES:
        raise Refused(words.starred(words.ILLEGAL_VALUE, "cycles are from -32768 to 32767"))
    if not 1 <= step <= max(len(program.lines), 1):
        raise Refused(words.starred(words.ILLEGAL_VALUE, f"`{name}` has no step {step}"))
    return name, cycles, step


def _why(program: StoredProgram) -> str:
    """Return the first reason why a program is not executable."""
    first = program.faults[0]
    if first.primary is None:
        return first.headline
    return f"step {first.primary.span.line - 1}: {first.headline}"


def steps(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """NEXT [n], SSTEP, XSTEP."""
    if len(line.operands) > 1 or (line.operands and line.word.text != "NEXT"):
        raise Refused(words.starred(words.UNEXPECTED_TEXT, f"write `{line.word.usage}`"))
    count = whole(line, line.operands[0] if line.operands else None, 1, desk, now)
    if not 1 <= count <= _MOST_CYCLES:
        raise Refused(words.starred(words.ILLEGAL_VALUE, "steps are from 1 to 32767"))
    return Turn(commands=(RunSteps(count, line.word.text == "SSTEP"),))


def end_process(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """PCEND [1 | -1]."""
    sign = whole(line, line.operands[0] if line.operands else None, 1, desk, now)
    return Turn(commands=(EndProcess(sign >= 0),))


def do(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """DO [instruction]: without one the last one again."""
    text = line.rest or desk.last_do
    if text is None:
        raise Refused(words.starred(words.MISSING_ARGUMENT, "write `DO instruction`"))
    refused = words.first_refusal(check_alone(text, desk.dialect))
    if refused is not None:
        raise Refused(refused)
    module = one_step(text, desk, now)
    desk.last_do = text
    return Turn(commands=(Do(module),))


def as_instruction(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """Carry out a command that is an instruction too: BASE, ENABLE, RESET, SIGNAL, TOOL ..."""
    text = f"{line.word.text} {line.rest}".rstrip()
    refused = words.first_refusal(check_alone(text, desk.dialect))
    if refused is not None:
        raise Refused(refused)
    return Turn(commands=(Do(one_step(text, desk, now)),))


def signal(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """SIGNAL number, number: also while a program executes."""
    if not now.executing:
        return as_instruction(line, desk, now)
    numbers = tuple(whole(line, operand, 0, desk, now) for operand in line.operands)
    bad = next((n for n in numbers if n and abs(n) not in (*OUTPUTS, *INTERNAL)), None)
    if bad is not None or not numbers:
        raise Refused(words.starred("Illegal digital signal", f"there is no output {bad}"))
    return Turn(commands=(ForceSignals(tuple(n for n in numbers if n)),))


def reset(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """RESET: all outputs off, also while a program executes."""
    if not now.executing:
        return as_instruction(line, desk, now)
    on = sorted(number for number in now.state.signals if number in OUTPUTS)
    return Turn(commands=(ForceSignals(tuple(-number for number in on)),) if on else ())


def speed(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """SPEED percent: of the monitor, at once; more than 100 counts as 100."""
    percent = real(line, line.operands[0] if line.operands else None, desk, now)
    if not percent > 0.0:
        raise Refused(words.starred(words.ILLEGAL_VALUE, "a speed is more than 0 percent"))
    return Turn(commands=(MonitorSpeed(min(percent, _MOST_SPEED)),))


def calibrate(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """CALIBRATE: asks; the simulated arm always knows where it is."""
    return sure(desk, now, lambda desk, now: Turn())
