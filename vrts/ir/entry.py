"""Which program is executed where none is named: one rule for every command.

It is `main`; without one the only program that no other calls; else the first of the file, which
is a guess, so whoever executes it says so. Programs that take arguments cannot be executed by
themselves, so they count only where there are no others.
"""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.ir.control import Call, CallNamed, React, ReactError, StartProcess
from vrts.ir.expressions import Constant
from vrts.ir.instructions import Instruction

MAIN = "main"


class Outline(NamedTuple):
    """What decides whether a program is executed."""

    name: str  # lower case
    takes_arguments: bool
    calls: frozenset[str]  # names of programs, lower case


class Entry(NamedTuple):
    """The program that is executed, and those that might be meant as well."""

    name: str
    rivals: tuple[str, ...] = ()  # in the order of the file; empty: it is beyond doubt


def entry_among(programs: Sequence[Outline]) -> Entry | None:
    """Return the program to execute; None where there is none."""
    able = [program for program in programs if not program.takes_arguments] or list(programs)
    if not able:
        return None
    if any(program.name == MAIN for program in able):
        return Entry(MAIN)
    called = {name for program in programs for name in program.calls - {program.name}}
    free = [program.name for program in able if program.name not in called]
    meant = free or [program.name for program in able]
    return Entry(meant[0], tuple(meant[1:]))


def program_called(instruction: Instruction) -> str | None:
    """Return the program that an instruction calls, starts, or lets a signal or error call."""
    match instruction:
        case Call(program=str(name)) | StartProcess(program=str(name)):
            return name
        case React(program=str(name)) | ReactError(program=str(name)):
            return name
        case CallNamed(program=Constant(value=str(name))):
            return name.lower()
        case _:
            return None
