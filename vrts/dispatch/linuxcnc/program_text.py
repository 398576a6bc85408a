"""The programs of a module as one file of G-code: a subroutine each, then the main one."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.dispatch.linuxcnc.jumps import GOTO, write_jump
from vrts.dispatch.linuxcnc.levels import levels, shallow
from vrts.dispatch.linuxcnc.locations import constant
from vrts.dispatch.linuxcnc.memory import Memory
from vrts.dispatch.linuxcnc.names import LONGEST, comment, number
from vrts.dispatch.linuxcnc.steps import STOP, Steps
from vrts.dispatch.linuxcnc.structures import Structures
from vrts.dispatch.linuxcnc.values import CLOCK
from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.calls import called_by
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.signals import read_outputs
from vrts.dispatch.saying.stretches import Stretches, ends, jumps, numbered
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.timers import timers
from vrts.dispatch.saying.under_way import looks, under_way
from vrts.ir import instructions as ir
from vrts.ir.module import Module, Program
from vrts.ir.values import Type
from vrts.lang.compiler import Resolved
from vrts.lang.meaning.structure import word_of
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import Declare

CANNOT_SAY = Rule("V870", "linuxcnc-cannot")
INDENT = "  "
OURS = "v_"  # begins the names of the library's subroutines
ENDING = ("G94", "M2")
INTERNAL = re.compile(r"#<_signal_\d+>")


class Said(NamedTuple):
    """Programs in G-code, as far as they could be said."""

    text: str
    diagnostics: tuple[Diagnostic, ...]  # errors: what could not be


def said(found: Resolved, module: Module, entry: str, table: Table) -> Said:
    """Return the file of a program and all that it calls.

    Args:
        found: The programs as syntax trees.
        module: The same compiled.
        entry: The program that is executed.
        table: Pins of inputs and outputs.
    """
    main = module.programs[entry].span
    try:
        names = called_by(module, entry)
        memory = Memory(module)
        for name in names:
            if plain(name).startswith(OURS):
                raise CannotSay(f"`{name}` is a name of the library", "rename the program")
    except CannotSay as cannot:
        return Said("", (cannot.diagnostic(CANNOT_SAY, main),))
    deep = levels(module, names, entry)
    writer = _Writer(found, module, table, memory, under_way(module, entry), deep)
    texts = {program.name: program for program in found.programs}
    bodies = {name: writer.program(texts[name], main=name == entry) for name in names}
    written = [row for body in bodies.values() for row in body]
    rows = [
        f"; {plain(entry)}, written by vrts: each step stands before what became of it.",
        "; What the v_ subroutines do is said in their own files, in the folder `library`.",
        *(row for name in names if name != entry for row in bodies[name]),
        "",
        "G21 G90 G40 G49 G80 G94 G61.1",
        "o<v_setup> call",
        *_places(module, memory),
        *_clocks(module),
        *(f"#<_out_{signal}> = 0" for signal in sorted(read_outputs(module))),
        *(f"{name} = 0" for name in sorted(set(INTERNAL.findall("\n".join(written))))),
        *bodies[entry],
        *ENDING,
    ]
    return Said("\n".join(rows) + "\n", tuple(writer.errors))


def _clocks(module: Module) -> list[str]:
    """Return what begins the timers: all count from the beginning until they are set."""
    found = timers(module)
    begun = [f"#<_timer_{number}> = #<_v_now>" for number in found]
    return [CLOCK, *begun] if found else []


def _places(module: Module, memory: Memory) -> list[str]:
    """Return where locations and arrays are kept, and what the data say of them."""
    rows = ["; where locations and arrays are kept"]
    rows += [f"#<{kept.parameter}> = {kept.address}" for kept in memory.kept.values()]
    rows.append("; what the program was taught")
    for datum in module.data:
        kept, value = memory.kept.get(datum.name), datum.value
        if isinstance(value, str):
            continue
        if kept is None:
            if isinstance(value, float):
                rows.append(f"#<_val_{plain(datum.name)}> = {number(value)}")
            continue
        at = f"#<{kept.parameter}>"
        if datum.subscripts:
            at += f" + {datum.subscripts[0] * kept.width}"
        rows.append(
            f"#[{at}] = {number(value)}" if isinstance(value, float) else constant(at, value)
        )
    return rows


class _Writer:
    def __init__(
        self,
        found: Resolved,
        module: Module,
        table: Table,
        memory: Memory,
        moving: frozenset[tuple[str, int]],
        level: Mapping[str, int],
    ) -> None:
        self.module, self.table = module, table
        self.memory, self.moving, self.level = memory, moving, level
        self.problems = found.resolver.problems
        self.errors: list[Diagnostic] = []
        self.arguments = Arguments(module, frozenset({Type.REAL}))

    def program(self, text: ProgramText, *, main: bool) -> list[str]:
        """Return the lines of a program."""
        program = self.module.programs[text.name]
        steps = Steps(self.memory, self.table, self.arguments)
        structures = Structures(steps)
        rows = [""]
        if not main:
            rows.append(f"o<{plain(text.name)}> sub")
            names = (plain(formal.name) for formal in program.formals)
            rows += [f"{INDENT}#<{name}> = #{k}" for k, name in enumerate(names, start=1)]
        if jumps(program, text):
            rows += self._by_numbers(program, text, steps, main=main)
            return rows
        base = 0 if main else 1
        for step in text.steps:
            node = step.statement
            if node is None:
                continue
            depth = structures.depth
            try:
                self._step(program, step, steps, structures, main=main)
            except CannotSay as cannot:
                self.errors.append(
                    cannot.diagnostic(CANNOT_SAY, self.problems.span(node.start, node.end))
                )
                steps.take()
                structures.pass_over(word_of(step) or "", depth)
                continue
            indent = INDENT * (base + min(depth, structures.depth))
            rows.append(indent + self._comment(step))
            rows += [indent + line for line in steps.take()]
        return [*rows, *self._ended(program, main=main)]

    def _ended(self, program: Program, *, main: bool) -> list[str]:
        if main:
            return [STOP]
        rows = [INDENT + row for row in _given_back(program, self.arguments)]
        return [*rows, f"o<{plain(program.name)}> endsub"]

    def _by_numbers(
        self, program: Program, text: ProgramText, steps: Steps, *, main: bool
    ) -> list[str]:
        """Return a program that jumps: a loop that goes from one numbered part to the next."""
        by_number = {step.number: step for step in text.steps if step.statement is not None}
        stretches = numbered(program)
        loop, choice = steps.label(), steps.label()
        rows = ["; it jumps, so each stretch without jumps has a number"]
        rows += [f"{GOTO} = 0", f"o{loop} while [{GOTO} GE 0]"]
        for here, (first, last) in enumerate(stretches):
            rows.append(f"{INDENT}o{choice} {'elseif' if here else 'if'} [{GOTO} EQ {here}]")
            told = 0
            for k in range(first, last):
                step = by_number.get(program.origins[k].step)
                try:
                    self._instruction(program, k, steps, stretches, here, main=main)
                except CannotSay as cannot:
                    if step is None or step.statement is None:
                        raise
                    node = step.statement
                    span = self.problems.span(node.start, node.end)
                    self.errors.append(cannot.diagnostic(CANNOT_SAY, span))
                    steps.take()
                    continue
                if step is not None and step.number != told:
                    rows.append(INDENT * 2 + self._comment(step))
                    told = step.number
                rows += [INDENT * 2 + line for line in steps.take()]
            if not ends(program.instructions[last - 1]):
                rows.append(f"{INDENT * 2}{GOTO} = {here + 1}")
        rows += [f"{INDENT}o{choice} endif", f"o{loop} endwhile"]
        if not main:
            rows = [*(INDENT + row for row in rows), f"o<{plain(program.name)}> endsub"]
        return rows

    def _instruction(
        self,
        program: Program,
        k: int,
        steps: Steps,
        stretches: Stretches,
        here: int,
        *,
        main: bool,
    ) -> None:
        instruction = program.instructions[k]
        self._looks(program, [k], steps)
        if isinstance(instruction, ir.Return):
            _leave(program, instruction, steps, self.arguments, main=main)
        elif not write_jump(program, k, steps, stretches, here):
            steps.write(instruction)
        self._fits(program, steps)

    def _comment(self, step: Step) -> str:
        node = step.statement
        assert node is not None
        return comment(f"{step.number:>3}  {self.problems.source.text[node.start : node.end]}")

    def _step(
        self, program: Program, step: Step, steps: Steps, structures: Structures, *, main: bool
    ) -> None:
        last = len(program.instructions) - 1  # the end of the program
        at = [k for k, o in enumerate(program.origins) if o.step == step.number and k < last]
        found = [program.instructions[k] for k in at]
        self._looks(program, at, steps)
        word = word_of(step)
        if word is not None:
            structures.write(word, found)
        elif isinstance(step.statement, Declare):
            raise CannotSay("G-code has no variables of a program's own", "use other names")
        for instruction in found if word is None else ():
            if isinstance(instruction, ir.Return):
                _leave(program, instruction, steps, self.arguments, main=main)
            else:
                steps.write(instruction)
        self._fits(program, steps)

    def _looks(self, program: Program, at: list[int], steps: Steps) -> None:
        """Let the arm rest before a step that looks at the outside, or refuse it."""
        if not any(looks(program.instructions[k]) for k in at):
            return
        if any((program.name, k) in self.moving for k in at):
            raise CannotSay(
                "the arm may still move when this looks at the outside",
                "write BREAK before it: LinuxCNC reads inputs at rest",
            )
        steps.lines.append(STOP)

    def _fits(self, program: Program, steps: Steps) -> None:
        shallow(steps.lines, self.level[program.name])
        if any(len(line) > LONGEST for line in steps.lines):
            raise CannotSay("the step is too long for a line of G-code", "work it out in parts")


def _leave(
    program: Program, leave: ir.Return, steps: Steps, arguments: Arguments, *, main: bool
) -> None:
    if leave.skip is not None:
        raise CannotSay("G-code cannot skip steps of the caller")
    if main:
        steps.lines += [STOP, *ENDING]
        return
    steps.lines += _given_back(program, arguments)
    steps.lines.append(f"o<{plain(program.name)}> return")


def _given_back(program: Program, arguments: Arguments) -> list[str]:
    return [f"#<_{to}> = #<{plain(own.name)}>" for to, own in arguments.back(program)]
