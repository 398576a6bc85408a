"""Which instructions a program in execution may still come to, whatever its variables hold."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import after_step
from vrts.engine.programs.loaded import Loaded, Programs
from vrts.ir import instructions as ir


class At(NamedTuple):
    """An instruction of a program."""

    program: int
    number: int  # of the instruction


def ahead(c: Context) -> list[ir.Instruction]:
    """Return the instructions that a program may still execute; none when it is over."""
    if not c.running:
        return []
    loaded = c.system.programs.loaded
    places = _reached(c.system.programs, _begins(c))
    return [loaded[at.program].program.instructions[at.number] for at in places]


def texts(programs: Programs, name: str) -> list[ir.Instruction]:
    """Return all instructions of a program and of those that it may call, reached or not."""
    number = programs.numbers.get(name)
    if number is None:
        return []
    called = {at.program for at in _reached(programs, [At(number, 0)])}
    return [one for k in sorted(called) for one in programs.loaded[k].program.instructions]


def _reached(programs: Programs, begins: Iterable[At]) -> list[At]:
    """Return where a program may come to from some places, these included."""
    catches = any(
        isinstance(instruction, ir.ReactError) and instruction.program is not None
        for loaded in programs.loaded
        for instruction in loaded.program.instructions
    )
    seen: set[At] = set()
    left = list(begins)
    skips = False
    while left:
        at = left.pop()
        instructions = programs.loaded[at.program].program.instructions
        if at in seen or not 0 <= at.number < len(instructions):
            continue
        seen.add(at)
        instruction = instructions[at.number]
        left += _following(programs, at, instruction)
        if catches and not isinstance(instruction, ir.Jump):  # it may fail, and be gone on after
            left.append(At(at.program, after_step(programs.loaded[at.program].program, at.number)))
        skips |= isinstance(instruction, ir.Return) and instruction.skip is not None
        if skips and not left:  # RETURN n goes on anywhere in what called
            left += [one for one in _everywhere(programs.loaded, seen) if one not in seen]
    return sorted(seen)


def _begins(c: Context) -> Iterator[At]:
    """Yield where a program is, where its callers are, and what may interrupt it."""
    programs = c.system.programs
    yield from (At(frame.program, frame.index) for frame in c.frames)
    if c.cycles_left not in (0, 1) or c.kept_cycles is not None:
        yield At(programs.numbers[c.program], 0)
    yield from (At(w.program, 0) for w in c.watches if w.program is not None)
    if c.error_program is not None:
        yield At(c.error_program, 0)


def _following(programs: Programs, at: At, instruction: ir.Instruction) -> Iterator[At]:
    here, following = at.program, at.number + 1
    match instruction:
        case ir.Jump(target=target) | ir.NextFor(test=target):
            yield At(here, target)
            return
        case ir.Return() | ir.ReturnError() | ir.Stop() | ir.Halt() | ir.Pause():
            return
        case ir.JumpIf(target=target) | ir.TestFor(leave=target) | ir.TestCase(otherwise=target):
            yield At(here, target)
        case ir.Grasp(missing=int(target)):
            yield At(here, target)
        case ir.CallNamed():
            yield from (At(number, 0) for number in programs.numbers.values())
        case (
            ir.Call(program=name)
            | ir.React(program=name)
            | ir.ReactError(program=name)
            | ir.StartProcess(program=name)
        ) if name in programs.numbers:
            yield At(programs.numbers[name], 0)
        case _:
            pass
    yield At(here, following)


def _everywhere(loaded: tuple[Loaded, ...], seen: set[At]) -> Iterator[At]:
    for program in {at.program for at in seen}:
        yield from (At(program, k) for k in range(len(loaded[program].program.instructions)))
