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


def under_way(module: Module, entry: str) -> frozenset[tuple[str, int]]:
    """Return every instruction, as program and index, before which the arm may still move."""
    return _Search(module).moving(entry)


class _Search:
    def __init__(self, module: Module) -> None:
        self.module = module
        self.seen: set[tuple[_Point, bool]] = set()
        self.waiting: list[tuple[_Point, bool]] = []
        self.callers: dict[str, set[_Point]] = {}  # where programs go on behind their calls
        self.left: dict[str, set[bool]] = {}  # how programs were left

    def moving(self, entry: str) -> frozenset[tuple[str, int]]:
        self._reach(_Point(entry, 0), moves=False)
        while self.waiting:
            point, moves = self.waiting.pop()
            self._from(point, moves=moves)
        return frozenset((point.program, point.at) for point, moves in self.seen if moves)

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


def looks(instruction: ir.Instruction) -> bool:
    """Return whether something of an instruction looks at the outside."""
    if isinstance(instruction, ir.AssignHere):
        return True
    applied = (part for part in parts(instruction) if isinstance(part, Apply))
    return any(apply.function in LOOKS for apply in applied)
