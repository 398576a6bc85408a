"""Commands that show what is going on, and what is set [manual language/monitor#showing]."""

from vrts import __version__
from vrts.base.numbers import round_half_away
from vrts.engine.memory.records import ProgramState, ProgramStatus
from vrts.engine.programs.signals import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.lang.typed.commands import CommandLine
from vrts.monitor import words
from vrts.monitor.commands.execution import as_instruction
from vrts.monitor.commands.values import here_pose
from vrts.monitor.desk import Desk, Refused, Situation, Turn, evaluated, whole
from vrts.monitor.listings import (
    parameters_text,
    signals_text,
    status_text,
    switches_text,
    where_of_as_text,
    where_text,
)
from vrts.monitor.programs import step_text

INSTALLED = {kind.start: len(kind) for kind in (OUTPUTS, INPUTS, INTERNAL)}
_MOST_BLOCKS = 16  # of 32 signals


def where(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """WHERE: pose, joints and hand at this moment."""
    state = now.state
    block = whole(line, line.operands[0] if line.operands else None, 0, desk, now)
    if desk.dialect.is_as:
        return Turn(where_of_as_text(here_pose(now), state.configuration, block=block))
    angles = desk.dialect.angles
    return Turn(where_text(here_pose(now), state.configuration, state.hand_opening, angles))


def signals(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """IO [n]: the nth 32 signals of each kind."""
    block = whole(line, line.operands[0] if line.operands else None, 1, desk, now)
    if not 1 <= block <= _MOST_BLOCKS:
        known = f"blocks of signals are 1 to {_MOST_BLOCKS}"
        raise Refused(words.starred(words.ILLEGAL_VALUE, known))
    return Turn(signals_text(now.state.signals, block, INSTALLED))


def status(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """STATUS, PCSTATUS."""
    process = line.word.text == "PCSTATUS"
    program = now.state.process if process else now.robot
    title = "PC program" if process else "Robot program"
    speeds = (now.state.monitor_speed, now.state.program_speed)
    if program is None:
        return Turn(status_text(speeds, title, "NOT RUNNING", (0, 0), ()))
    word = _STATUS[program.status]
    cycles = (program.cycles_done, program.cycles_left)
    return Turn(status_text(speeds, title, word, cycles, _frames(program, desk)))


_STATUS = {
    ProgramStatus.NOT_RUNNING: "NOT RUNNING",
    ProgramStatus.RUNNING: "RUNNING",
    ProgramStatus.WAITING: "WAITING",
    ProgramStatus.STOPPED: "STOPPED",
    ProgramStatus.COMPLETED: "NOT RUNNING",
}


def _frames(program: ProgramState, desk: Desk) -> tuple[tuple[str, int, int, str], ...]:
    cause = program.cause
    if cause is None:
        return ()
    stored = desk.programs.get(cause.program)
    text = cause.span.text if stored is None else step_text(stored, cause.step, desk.dialect)
    return ((cause.program, program.priority, cause.step, text),)


def switches(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """SWITCH [name]."""
    states = now.state.switches
    if not line.operands:
        return Turn(switches_text((name, states.get(name, s.on)) for name, s in SWITCHES.items()))
    names = [_system_name(operand, "switch") for operand in line.operands]
    unknown = next((name for name in names if name not in SWITCHES), None)
    if unknown is not None:
        raise Refused(words.starred("Invalid switch", f"there is no switch {unknown}"))
    return Turn(switches_text((name, states.get(name, SWITCHES[name].on)) for name in names))


def parameter(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """PARAMETER [name [= value]]."""
    if line.values is not None:
        return as_instruction(line, desk, now)
    names = [_system_name(operand, "parameter") for operand in line.operands] or list(PARAMETERS)
    unknown = next((name for name in names if name not in PARAMETERS), None)
    if unknown is not None:
        raise Refused(words.starred("Invalid parameter", f"there is no parameter {unknown}"))
    indices = [_index(operand) for operand in line.operands] or [None] * len(names)
    cells = [cell for pair in zip(names, indices, strict=True) for cell in _cells(*pair)]
    return Turn(parameters_text((cell, _value(cell, desk, now)) for cell in cells))


def _value(cell: str, desk: Desk, now: Situation) -> float:
    """Return a number of a parameter as programs read it."""
    value = evaluated(f"PARAMETER({cell})", Type.REAL, desk, now)
    assert isinstance(value, float)
    return value


def _cells(name: str, index: int | None) -> tuple[str, ...]:
    """Return the numbers of a parameter that are to be shown: all, or the one with an index."""
    known = PARAMETERS[name].cells
    if index is None:
        return known
    wanted = f"{name}[{index}]"
    if wanted not in known:
        has = f"from 1 to {len(known)}" if len(known) > 1 else "none"
        raise Refused(words.starred("Illegal array index", f"the index of {name}: {has}"))
    return (wanted,)


def _index(operand: object) -> int | None:
    """Return the index in `NEST.POS[2]`; None where none is written."""
    if not isinstance(operand, Element) or not operand.subscripts:
        return None
    (first, *more) = operand.subscripts
    if more or not isinstance(first, Number):
        raise Refused(words.starred("Illegal array index", "one number belongs into the brackets"))
    return round_half_away(first.value)


def _system_name(operand: object, what: str) -> str:
    if isinstance(operand, Element):
        operand = operand.name
    if not isinstance(operand, Name):
        raise Refused(words.starred(words.INVALID_NAME, f"here the name of a {what} belongs"))
    return operand.text.upper()


def free(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FREE: what memory holds; the simulator has no end of it."""
    count = len(desk.programs)
    total = sum(len(program.lines) for program in desk.programs.values())
    return Turn(
        f"{count} program{'' if count == 1 else 's'}, {total} step{'' if total == 1 else 's'}, "
        f"{len(now.state.variables)} values in memory; there is room for more\n"
    )


def time(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """TIME: simulated seconds since the controller was turned on."""
    return Turn(f"{now.state.time_s:.3f} s\n")


def identify(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """ID: what this is."""
    return Turn(f"vrts {__version__}, simulated {desk.dialect.title} controller\n")
