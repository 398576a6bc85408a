"""Which steps the scenarios executed, and which ways decisions went in them.

Scenarios add up: what one of them executed counts for all.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vrts.dispatch.manifest import Executed
from vrts.engine.history import ProgramHistory
from vrts.engine.memory.events import Reacted
from vrts.engine.run import Run
from vrts.ir import instructions as ir
from vrts.ir.module import Module, Program

MOVING = (
    ir.Move,
    ir.Depart,
    ir.Drive,
    ir.Draw,
    ir.Align,
    ir.Ready,
    ir.Nest,
    ir.MoveHand,
    ir.Grasp,
    ir.Opaque,  # nobody knows what it does
)  # what moves the arm or the hand
_SILENT = (ir.Jump, ir.Return, ir.NextFor)  # END, ELSE and the end of a program


class Covered(NamedTuple):
    """What happened in all scenarios together; instructions by program and index."""

    executed: frozenset[tuple[str, int]]
    followed: frozenset[tuple[str, int, int]]  # an instruction, and the one of its program after it
    reactions: frozenset[str]  # programs that reactions to signals began; "" for none


def covered(runs: Sequence[Run]) -> Covered:
    """Return what runs of one module covered together."""
    executed: set[tuple[str, int]] = set()
    followed: set[tuple[str, int, int]] = set()
    reactions: set[str] = set()
    for run in runs:
        places = _places(run)
        for history in (run.history.robot, run.history.process):
            numbers = _numbers(run, history)
            executed |= {places[k] for k in np.unique(numbers).tolist()}
            pairs = np.unique(np.stack([numbers[:-1], numbers[1:]]), axis=1) if len(numbers) else ()
            for before, after in zip(*pairs, strict=True) if len(pairs) else ():
                program, index = places[int(before)]
                other, following = places[int(after)]
                if other == program:
                    followed.add((program, index, following))
        for event in run.events:
            if isinstance(event, Reacted) and event.signal != 0:
                reactions.add(event.program)
    return Covered(frozenset(executed), frozenset(followed), frozenset(reactions))


def _numbers(run: Run, history: ProgramHistory) -> np.ndarray[tuple[int], np.dtype[np.uint32]]:
    count = history.trace.executed(run.statements)
    return np.frombuffer(history.trace.instructions, np.uint32)[:count]


def _places(run: Run) -> list[tuple[str, int]]:
    """Return program and index of every instruction, by its number in the run."""
    code = run.history.code
    return [
        (program.name, index)
        for program in code.programs
        for index in range(len(program.instructions))
    ]


def executed_steps(module: Module, known: Covered) -> tuple[Executed, ...]:
    """Return for every program how many of its steps were executed."""
    return tuple(_executed(program, known) for program in module.programs.values())


def _executed(program: Program, known: Covered) -> Executed:
    done: set[int] = set()
    all_: set[int] = set()
    moving: set[int] = set()
    for index, (instruction, origin) in enumerate(
        zip(program.instructions, program.origins, strict=True)
    ):
        if isinstance(instruction, _SILENT):
            continue
        all_.add(origin.step)
        if isinstance(instruction, MOVING):
            moving.add(origin.step)
        if (program.name, index) in known.executed:
            done.add(origin.step)
    return Executed(
        program.name,
        len(all_),
        len(done),
        len(moving),
        len(moving & done),
        tuple(sorted(all_ - done)),
    )
