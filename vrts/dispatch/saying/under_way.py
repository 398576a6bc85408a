"""Where the arm may be moving while a step is carried out, in any run of the programs.

VAL-II goes on with its steps while the arm moves; LinuxCNC and URScript read an input when it
stands. So what looks at the outside may stand only where the arm surely rests.
"""

from typing import NamedTuple

from vrts.dispatch.saying.parts import parts
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function
from vrts.ir.module import Module

MOTIONS = (ir.Move, ir.Depart, ir.Draw, ir.Drive, ir.Align, ir.Ready, ir.Nest, ir.Delay)
STOPS = (ir.Break, ir.Grasp, ir.SetTool, ir.SetBase, ir.RequestBranch, ir.Halt, ir.Pause)
LOOKS = frozenset(
    {
        *(Function.SIG, Function.BITS, Function.ADC, Function.TIMER, Function.TIME),
        *(Function.HERE, Function.HERE_JOINTS),
    }
)
ENDINGS = (ir.Return, ir.Stop, ir.Halt)


class _Point(NamedTuple):
    program: str
    at: int  # index of an instruction


def under_way(module: Module, *entries: str, moves: bool = False) -> frozenset[tuple[str, int]]:
    """Return every instruction, as program and index, before which the arm may still move.

    Args:
        module: The programs.
        entries: Those that begin by themselves.
        moves: Whether the arm moves then.
    """
    return _Search(module).moving(entries, moves=moves)


class _Search:
    def __init__(self, module: Module) -> None:
        self.module = module
        self.seen: set[tuple[_Point, bool]] = set()
        self.waiting: list[tuple[_Point, bool]] = []
        self.callers: dict[str, set[_Point]] = {}  # where programs go on behind their calls
        self.left: dict[str, set[bool]] = {}  # how programs were left

    def moving(self, entries: tuple[str, ...], *, moves: bool) -> frozenset[tuple[str, int]]:
        for entry in entries:
            self._reach(_Point(entry, 0), moves=moves)
        while self.waiting:
            point, under = self.waiting.pop()
            self._from(point, moves=under)
        return frozenset((point.program, point.at) for point, under in self.seen if under)

    def _reach(self, point: _Point, *, moves: bool) -> None:
        if (point, moves) not in self.seen:
            self.seen.add((point, moves))
            self.waiting.append((point, moves))

    def _from(self, point: _Point, *, moves: bool) -> None:
        program = self.module.programs[point.program]
        instruction = program.instructions[point.at]
        following = point._replace(at=point.at + 1)
        if isinstance(instruction, ir.Return):
            self.left.setdefault(point.program, set()).add(moves)
            for caller in self.callers.get(point.program, ()):
                self._reach(caller, moves=moves)
            return
        if isinstance(instruction, ENDINGS):
            return
        if isinstance(instruction, ir.Call) and instruction.program in self.module.programs:
            self.callers.setdefault(instruction.program, set()).add(following)
            self._reach(_Point(instruction.program, 0), moves=moves)
            for was in self.left.get(instruction.program, ()):
                self._reach(following, moves=was)
            return
        if isinstance(instruction, MOTIONS):
            moves = True
        elif isinstance(instruction, STOPS) or (
            isinstance(instruction, ir.MoveHand) and instruction.immediate
        ):
            moves = False
        for target in ir.jumps_of(instruction):
            self._reach(point._replace(at=target), moves=moves)
        if not isinstance(instruction, ir.Jump | ir.NextFor):
            self._reach(following, moves=moves)


def tells_place(instruction: ir.Instruction) -> bool:
    """Return whether an instruction tells where the arm is."""
    applied = (part.function for part in parts(instruction) if isinstance(part, Apply))
    here = (Function.HERE, Function.HERE_JOINTS)
    return isinstance(instruction, ir.AssignHere) or any(function in here for function in applied)


def looks(instruction: ir.Instruction) -> bool:
    """Return whether something of an instruction looks at the outside, or at the clock."""
    if isinstance(instruction, ir.AssignHere | ir.SetTimer | ir.WaitTime | ir.SetBits):
        return True
    applied = (part for part in parts(instruction) if isinstance(part, Apply))
    return any(apply.function in LOOKS for apply in applied)


def left_moving(module: Module, entry: str) -> bool:
    """Return whether a program that begins at rest may be left while the arm moves."""
    search = _Search(module)
    search.moving((entry,), moves=False)
    return True in search.left.get(entry, ())
