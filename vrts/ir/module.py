"""Programs and data of one compilation."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from vrts.base.source import Span
from vrts.ir.entry import Entry, Outline, entry_among, program_called
from vrts.ir.expressions import Slot
from vrts.ir.instructions import Instruction
from vrts.ir.values import Value


class Origin(NamedTuple):
    """Where an instruction comes from."""

    step: int  # as the controller numbers lines: from 1, blank and comment lines included
    span: Span  # the statement, without label and comment


@dataclass(frozen=True, slots=True)
class Program:
    """One program: a flat list of instructions that ends with Return."""

    name: str  # lower case
    formals: tuple[Slot, ...]
    array_formals: frozenset[int]  # slots that are arrays, written `a[]`
    instructions: tuple[Instruction, ...]
    origins: tuple[Origin, ...]  # beside instructions
    steps: tuple[int, ...]  # steps[k] is the first instruction at or after step k + 1
    loops: int  # number of FOR loops; frames keep a limit and an increment for each
    cases: int  # number of CASE structures; frames keep a selector for each
    span: Span  # the .PROGRAM line
    autos: tuple[Slot, ...] = ()  # variables of each activation, numbered after the formals

    @property
    def outline(self) -> Outline:
        """What decides whether it is the one that is executed."""
        called = (program_called(instruction) for instruction in self.instructions)
        return Outline(self.name, bool(self.formals), frozenset(n for n in called if n is not None))


class Datum(NamedTuple):
    """An initial value from a data section."""

    name: str  # as Global.name
    subscripts: tuple[int, ...]
    value: Value
    span: Span


@dataclass(frozen=True, slots=True)
class Module:
    """All that one compilation yields."""

    programs: Mapping[str, Program]  # by name, in source order
    data: tuple[Datum, ...]

    @property
    def main(self) -> str | None:
        """The program that is executed when none is named; None where there is none."""
        entry = self.entry
        return None if entry is None else entry.name

    @property
    def entry(self) -> Entry | None:
        """The same, with those that might be meant as well."""
        return entry_among([program.outline for program in self.programs.values()])
