"""What the commands of the monitor share: the text in memory, the present state, their answers."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple, Protocol

from vrts.base.numbers import round_half_away
from vrts.base.source import SourceFile
from vrts.engine.memory.records import ProgramState, ProgramStatus
from vrts.engine.run import State
from vrts.ir.commands import Command, DeletePrograms, Kill, Load
from vrts.ir.module import Module
from vrts.ir.values import Type, Value
from vrts.lang.dialect import VAL2, Dialect
from vrts.lang.meaning.constants import number_of
from vrts.lang.names import SIGNIFICANT, key
from vrts.lang.syntax.expressions import Element, FormatItem, Item, Name
from vrts.lang.typed.commands import CommandLine, FileName
from vrts.monitor import words
from vrts.monitor.folder import Folder
from vrts.monitor.programs import StoredProgram, compiled, in_view

ALONE = "monitor.do"  # the program of one instruction
ANSWER = "monitor.answer"  # a variable of forks, in which expressions are worked out
_EXECUTING = frozenset({ProgramStatus.RUNNING, ProgramStatus.WAITING})

Operand = Item | FileName | None
Calculate = Callable[[Module], Mapping[str, Value] | str]
"""Executes a module of one step beside the run; returns the variables then, or why it failed."""


def executes(program: ProgramState | None) -> bool:
    """Return whether a program is under way."""
    return program is not None and program.status in _EXECUTING


def stopped(program: ProgramState | None) -> frozenset[str]:
    """Return the programs of one that can be resumed: the first, and the one it has stopped in."""
    if program is None or program.status is not ProgramStatus.STOPPED:
        return frozenset()
    inner = program.cause.program if program.cause is not None else program.program
    return frozenset({program.program, inner})


class Refused(Exception):  # noqa: N818 -- names the situation
    """A command is not carried out; `text` says why, as the monitor prints it."""

    def __init__(self, text: str) -> None:
        """Keep the text."""
        super().__init__(text)
        self.text = text


class Turn(NamedTuple):
    """What the monitor does about one line."""

    text: str = ""  # printed at once
    commands: tuple[Command, ...] = ()  # issued to the controller, in this order
    mode: "Mode | None" = None  # who reads the next line; None: the monitor itself


class Situation(NamedTuple):
    """The controller at the moment of a command."""

    state: State
    calculate: Calculate
    robot: ProgramState | None  # the robot program; a DO that is over does not count
    asks: bool  # a PROMPT waits for a line

    @property
    def executing(self) -> bool:
        """Whether a robot program executes."""
        return executes(self.robot)

    def occupies(self, name: str) -> bool:
        """Return whether a program is being executed, also as a caller or process program."""
        robot, process = self.robot, self.state.process
        running: set[str] = set()
        if robot is not None and executes(robot):
            running |= {robot.program, *(cause.program for cause in self.state.call_stack)}
        if process is not None and executes(process):
            running |= {process.program, *(cause.program for cause in self.state.process_stack)}
        return name in running


class Mode(Protocol):
    """A part of the dialogue that reads lines itself: questions, the editor, teaching."""

    @property
    def prompt(self) -> str:
        """Return what is printed before the line is typed."""
        ...

    def enter(self, line: str, desk: "Desk", now: Situation) -> Turn:
        """Take a line."""
        ...

    def interrupt(self, desk: "Desk", now: Situation) -> Turn:
        """Take Ctrl-C."""
        ...


@dataclass(slots=True)
class Desk:
    """The monitor's own memory."""

    folder: Folder
    dialect: Dialect = VAL2
    asks: bool = True  # before what cannot be undone; otherwise it is done
    overwrite: bool = False  # STORE may replace files unasked
    replace: bool = False  # LOAD may replace programs
    room: int | None = None  # characters of programs that memory holds; None: no end
    programs: dict[str, StoredProgram] = field(default_factory=dict[str, StoredProgram])
    last_executed: str | None = None
    last_process: str | None = None
    last_edited: tuple[str, int] | None = None
    last_do: str | None = None

    def program(self, name: str) -> StoredProgram:
        """Return a program of the memory, or refuse."""
        found = self.programs.get(name)
        if found is None:
            raise Refused(words.starred(words.UNDEFINED, f"there is no program `{name}`"))
        return found

    def has_room(self, program: StoredProgram, added: str) -> bool:
        """Return whether one more step of a program that is edited fits into memory."""
        if self.room is None:
            return True
        others = (known for name, known in self.programs.items() if name != program.name)
        taken = sum(len(each.text) for each in (*others, program))
        return taken + len(added) + 1 <= self.room

    def install(self, program: StoredProgram, now: Situation) -> Turn:
        """Put a program in memory; one of this name that has stopped cannot go on."""
        found = compiled(program, self.programs, now.state.variables, self.dialect)
        self.programs[found.name] = found
        kill: tuple[Command, ...] = ()
        text = ""
        if found.name in stopped(now.robot):
            kill = (Kill(),)
            text = f"`{found.name}` has changed: what had stopped cannot be resumed\n"
        if found.program is not None:
            return Turn(text, (*kill, Load(Module({found.name: found.program}, ()))))
        return Turn(text, (*kill, *self._gone(found.name, now)))

    def remove(self, name: str, now: Situation) -> tuple[Command, ...]:
        """Take a program out of memory; return what tells the controller."""
        del self.programs[name]
        return self._gone(name, now)

    def _gone(self, name: str, now: Situation) -> tuple[Command, ...]:
        return (DeletePrograms((name,)),) if name in now.state.module.programs else ()


# --- operands -------------------------------------------------------------------------------------


def program_name(operand: Operand) -> str:
    """Return the program that an operand names, or refuse."""
    if isinstance(operand, Name) and operand.text[0] not in "$#":
        return key(operand.text)
    raise Refused(words.starred(words.INVALID_NAME, "here the name of a program belongs"))


def whole(line: CommandLine, operand: Operand, default: int, desk: Desk, now: Situation) -> int:
    """Return the whole number of an operand; the default where it is left out."""
    if operand is None:
        return default
    return round_half_away(real(line, operand, desk, now))


def real(line: CommandLine, operand: Operand, desk: Desk, now: Situation) -> float:
    """Return the number that an operand is or stands for."""
    if operand is None or isinstance(operand, FileName | FormatItem):
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    known = number_of(operand)
    if known is not None:
        return known
    value = evaluated(written(line, operand), Type.REAL, desk, now)
    assert isinstance(value, float)
    return value


def written(line: CommandLine, operand: Item) -> str:
    """Return an operand as typed."""
    at = line.rest_start
    return line.rest[operand.start - at : operand.end - at]


def place(
    line: CommandLine, operand: Operand, desk: Desk, now: Situation
) -> tuple[str, tuple[int, ...]]:
    """Return the name and the indices of a variable, or refuse."""
    if isinstance(operand, Name):
        return key(operand.text), ()
    if isinstance(operand, Element):
        indices = tuple(whole(line, index, 0, desk, now) for index in operand.subscripts)
        if any(not 0 <= index <= 32767 for index in indices):
            raise Refused(words.starred("Illegal array index", "an index is from 0 to 32767"))
        return key(operand.name.text), indices
    raise Refused(words.starred(words.INVALID_NAME, "here the name of a variable belongs"))


def cell(name: str, indices: tuple[int, ...]) -> str:
    """Return the name of a variable as states list it: `a[1]`."""
    return f"{name}[{','.join(map(str, indices))}]" if indices else name


def is_name(name: str) -> bool:
    """Return whether a name is short enough to be one."""
    return len(name.lstrip("$#")) <= SIGNIFICANT


def evaluated(text: str, wanted: Type, desk: Desk, now: Situation) -> Value:
    """Return the value of an expression, or refuse as the controller would."""
    sigil = {Type.STRING: "$", Type.JOINTS: "#"}.get(wanted, "")
    set_ = "POINT " if desk.dialect.is_as else "SET "
    verb = set_ if wanted in (Type.POSE, Type.JOINTS) else ""
    name = f"{sigil}{ANSWER}"
    module = one_step(f"{verb}{name} = {text}", desk, now)
    found = now.calculate(module)
    if isinstance(found, str):
        raise Refused(found)
    return found[name]


def one_step(text: str, desk: Desk, now: Situation) -> Module:
    """Return an instruction as a program of its own, or refuse."""
    source = SourceFile("DO", f".PROGRAM {ALONE}\n{text}\n.END\n")
    found = in_view(source, (text,), desk.programs, now.state.variables, desk.dialect)
    told = [
        replace(d, help=tuple(line for line in d.help if ANSWER not in line))  # nobody wrote that
        for d in found.diagnostics
    ]
    refused = words.first_refusal(told)
    if refused is not None or found.module is None:
        raise Refused(refused or words.starred(words.ILLEGAL_COMMAND))
    return Module({ALONE: found.module.programs[ALONE]}, ())
