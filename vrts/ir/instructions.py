"""Instructions of the IR: a flat list per program, jumps by index.

Operands are expressions in the language's units (mm, degrees, seconds, percent). Motion settings
carry their scope. The instructions stand in three files; this one names them all.
"""

from typing import TypeAlias

from vrts.ir.control import (
    AbortProcess,
    BeginCase,
    BeginFor,
    Call,
    CallNamed,
    EndProcess,
    Halt,
    Ignore,
    Jump,
    JumpIf,
    Lock,
    NextFor,
    Pause,
    React,
    ReactError,
    Return,
    ReturnError,
    StartProcess,
    Stop,
    TestCase,
    TestFor,
    Wait,
    WaitTime,
)
from vrts.ir.data import (
    Assign,
    AssignHere,
    Decompose,
    DelayedSignal,
    Opaque,
    Pack,
    Prompt,
    Pulse,
    Reset,
    SetAnalog,
    SetBits,
    SetParameter,
    SetTimer,
    Signal,
    Switch,
    Type,
)
from vrts.ir.motion import (
    Accuracy,
    Align,
    Brake,
    BranchRequest,
    Break,
    Delay,
    Depart,
    Draw,
    Drive,
    Grasp,
    HandAction,
    Interpolation,
    Move,
    MoveHand,
    Nest,
    Ready,
    RequestBranch,
    Scope,
    SetAcceleration,
    SetAccuracy,
    SetBase,
    SetBaseFrame,
    SetDuration,
    SetIntegration,
    SetMonitorSpeed,
    SetNulling,
    SetSpeed,
    SetTool,
    SetTurns,
    SpeedUnit,
)

__all__ = [
    "AbortProcess",
    "Accuracy",
    "Align",
    "Assign",
    "AssignHere",
    "BeginCase",
    "BeginFor",
    "Brake",
    "BranchRequest",
    "Break",
    "Call",
    "CallNamed",
    "Decompose",
    "Delay",
    "DelayedSignal",
    "Depart",
    "Draw",
    "Drive",
    "EndProcess",
    "Grasp",
    "Halt",
    "HandAction",
    "Ignore",
    "Instruction",
    "Interpolation",
    "Jump",
    "JumpIf",
    "Lock",
    "Move",
    "MoveHand",
    "Nest",
    "NextFor",
    "Opaque",
    "Pack",
    "Pause",
    "Prompt",
    "Pulse",
    "React",
    "ReactError",
    "Ready",
    "RequestBranch",
    "Reset",
    "Return",
    "ReturnError",
    "Scope",
    "SetAcceleration",
    "SetAccuracy",
    "SetAnalog",
    "SetBase",
    "SetBaseFrame",
    "SetBits",
    "SetDuration",
    "SetIntegration",
    "SetMonitorSpeed",
    "SetNulling",
    "SetParameter",
    "SetSpeed",
    "SetTimer",
    "SetTool",
    "SetTurns",
    "Signal",
    "SpeedUnit",
    "StartProcess",
    "Stop",
    "Switch",
    "TestCase",
    "TestFor",
    "Type",
    "Wait",
    "WaitTime",
]

Instruction: TypeAlias = (
    Move
    | Depart
    | Drive
    | Draw
    | Align
    | Ready
    | Nest
    | Delay
    | Break
    | Brake
    | SetSpeed
    | SetMonitorSpeed
    | SetAcceleration
    | SetDuration
    | SetAccuracy
    | SetNulling
    | SetIntegration
    | SetTurns
    | RequestBranch
    | MoveHand
    | Grasp
    | SetTool
    | SetBase
    | SetBaseFrame
    | Jump
    | JumpIf
    | BeginFor
    | TestFor
    | NextFor
    | BeginCase
    | TestCase
    | Call
    | CallNamed
    | Return
    | ReturnError
    | Stop
    | Halt
    | Pause
    | Wait
    | WaitTime
    | React
    | ReactError
    | Ignore
    | Lock
    | StartProcess
    | AbortProcess
    | EndProcess
    | Assign
    | AssignHere
    | Decompose
    | Pack
    | Signal
    | Reset
    | SetBits
    | Pulse
    | DelayedSignal
    | SetAnalog
    | Type
    | Prompt
    | Switch
    | SetParameter
    | SetTimer
    | Opaque
)


def jumps_of(instruction: object) -> tuple[int, ...]:
    """Return where an instruction may go on but behind itself."""
    match instruction:
        case Jump(target) | JumpIf(_, _, target):
            return (target,)
        case TestFor(_, _, leave):
            return (leave,)
        case NextFor(_, _, test):
            return (test,)
        case TestCase(_, _, otherwise):
            return (otherwise,)
        case Grasp(_, int(missing)):
            return (missing,)
        case _:
            return ()
