"""Which instructions the engine carries out; the rest stops a run where it is reached."""

from vrts.ir import instructions as ir

_INSTRUCTIONS = frozenset(
    {
        ir.AbortProcess,
        ir.Align,
        ir.Assign,
        ir.AssignHere,
        ir.BeginCase,
        ir.BeginFor,
        ir.Brake,
        ir.Break,
        ir.Call,
        ir.CallNamed,
        ir.Decompose,
        ir.Delay,
        ir.DelayedSignal,
        ir.Depart,
        ir.Draw,
        ir.Drive,
        ir.EndProcess,
        ir.Grasp,
        ir.Halt,
        ir.Ignore,
        ir.Jump,
        ir.JumpIf,
        ir.Lock,
        ir.Move,
        ir.MoveHand,
        ir.Nest,
        ir.NextFor,
        ir.Pack,
        ir.Pause,
        ir.Prompt,
        ir.Pulse,
        ir.React,
        ir.ReactError,
        ir.Ready,
        ir.RequestBranch,
        ir.Reset,
        ir.Return,
        ir.ReturnError,
        ir.SetAcceleration,
        ir.SetAccuracy,
        ir.SetAnalog,
        ir.SetBase,
        ir.SetBaseFrame,
        ir.SetBits,
        ir.SetDuration,
        ir.SetIntegration,
        ir.SetMonitorSpeed,
        ir.SetNulling,
        ir.SetParameter,
        ir.SetSpeed,
        ir.SetTimer,
        ir.SetTool,
        ir.SetTurns,
        ir.Signal,
        ir.StartProcess,
        ir.Stop,
        ir.Switch,
        ir.TestCase,
        ir.TestFor,
        ir.Type,
        ir.Wait,
        ir.WaitTime,
    }
)
_ROBOT_ONLY = frozenset(
    {
        ir.Move,
        ir.Depart,
        ir.Drive,
        ir.Draw,
        ir.Align,
        ir.Ready,
        ir.Nest,
        ir.Delay,
        ir.SetSpeed,
        ir.SetAccuracy,
        ir.SetNulling,
        ir.SetIntegration,
        ir.SetTurns,
        ir.RequestBranch,
        ir.MoveHand,
        ir.Grasp,
        ir.SetTool,
        ir.SetBase,
        ir.SetBaseFrame,
        ir.AssignHere,
    }
)  # marked [R] [manual language/motion#robot-steps]


def simulates(instruction: ir.Instruction) -> bool:
    """Return whether the engine carries an instruction out."""
    return type(instruction) in _INSTRUCTIONS


def robot_only(instruction: ir.Instruction) -> bool:
    """Return whether an instruction may stand in the robot program only."""
    return type(instruction) in _ROBOT_ONLY
