"""What of the language the engine carries out; the rest stops a run where it is reached."""

from vrts.engine.functions import PURE
from vrts.ir import instructions as ir
from vrts.ir.expressions import Function

_INSTRUCTIONS = frozenset(
    {
        ir.Assign,
        ir.AssignHere,
        ir.BeginCase,
        ir.BeginFor,
        ir.Break,
        ir.Call,
        ir.Decompose,
        ir.Delay,
        ir.Depart,
        ir.Drive,
        ir.Halt,
        ir.Jump,
        ir.JumpIf,
        ir.Move,
        ir.MoveHand,
        ir.NextFor,
        ir.Pack,
        ir.Pause,
        ir.Ready,
        ir.RequestBranch,
        ir.Reset,
        ir.Return,
        ir.SetBase,
        ir.SetBits,
        ir.SetSpeed,
        ir.SetTimer,
        ir.SetTool,
        ir.Signal,
        ir.Stop,
        ir.TestCase,
        ir.TestFor,
        ir.Type,
        ir.Wait,
    }
)
_STATEFUL = frozenset(
    {
        Function.BASE,
        Function.BITS,
        Function.DECODE,
        Function.DEFINED,
        Function.DEST,
        Function.DEST_JOINTS,
        Function.ENCODE,
        Function.HAND,
        Function.HERE,
        Function.HERE_JOINTS,
        Function.INRANGE,
        Function.LAST,
        Function.RANDOM,
        Function.SIG,
        Function.SPEED,
        Function.TAS,
        Function.TIMER,
        Function.TOOL,
        Function.UNPACK,
    }
)


def simulates(instruction: ir.Instruction) -> bool:
    """Return whether the engine carries an instruction out, with the operands it has."""
    match instruction:
        case ir.Move(opening=opening) if opening is not None:
            return False
        case ir.SetSpeed(rotation=rotation) if rotation is not None:
            return False
        case ir.Return(skip=skip) if skip is not None:
            return False
        case _:
            return type(instruction) in _INSTRUCTIONS


def evaluates(function: Function) -> bool:
    """Return whether the engine knows the value of a function."""
    return function in _STATEFUL or function in PURE
