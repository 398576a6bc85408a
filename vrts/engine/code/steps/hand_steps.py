"""Instructions of the hand, as closures."""

import math

from vrts.base.units import mm
from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.motion.profile import TICK_TOLERANCE
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.runtime_errors import RuntimeErrorKind

HAND_TIME = "HAND.TIME"  # parameter: wait after OPENI, CLOSEI, RELAXI and GRASP [s]


class HandStepCompiler:
    """Compiles the hand."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def move_hand(self, instruction: ir.MoveHand, following: int, cause: Cause) -> Step:
        """Return the step of OPEN, CLOSE, RELAX and their immediate forms."""
        action = instruction.action
        if instruction.immediate:
            return self._at_once(action, following, cause)

        def with_next_motion(c: Context) -> int:
            c.next_hand.append((action, cause))
            return following

        return with_next_motion

    def _at_once(self, action: ir.HandAction, following: int, cause: Cause) -> Step:
        def at_once(c: Context) -> int:
            if not acted(c, action, cause):
                return BLOCKED
            return following

        return at_once

    def grasp(self, instruction: ir.Grasp, following: int, cause: Cause) -> Step:
        """Return the step of GRASP."""
        least = self.expressions.real(instruction.distance)
        missing = instruction.missing

        def grasp(c: Context) -> int:
            if not acted(c, ir.HandAction.CLOSE, cause, tested=True):
                return BLOCKED
            opening, wanted = mm(c.hand.opening(c.now)), least(c)
            if opening >= wanted:
                return following
            if missing is not None:
                return missing
            raise RuntimeFault(
                RuntimeErrorKind.HAND_CLOSED_TOO_FAR,
                f"the hand closed to {opening:.1f} mm, less than {wanted:g} mm: no part is in it",
                cause.span,
                help=("name a label to go to when the part is missing: `GRASP distance, label`",),
                data={"opening_mm": opening},
            )

        return grasp


def hand_time(c: Context) -> float:
    """Return the parameter HAND.TIME at the start [s] [manual language/hand#at-once]."""
    said = c.planner.model.programs.hand_s
    return c.hand.gripper.stroke_time if said is None else said


def acted(c: Context, action: ir.HandAction, cause: Cause, *, tested: bool = False) -> bool:
    """Do an action of the hand once the arm stands still; return whether HAND.TIME is over."""
    if c.phase == 0:
        if not reached(c, c.planner.settled_at):
            return False
        command_hand(c, action, c.now, cause, tested=tested)
        tick = c.planner.arm.tick
        seconds = max(c.system.parameter(HAND_TIME, hand_time(c)), 0.0)
        c.until = c.now + math.ceil(seconds / tick - TICK_TOLERANCE) * tick
        c.phase = 1
    if not reached(c, c.until):
        return False
    c.phase = 0
    return True


def command_hand(
    c: Context, action: ir.HandAction, time_s: float, cause: Cause, *, tested: bool = False
) -> None:
    """Begin an action of the hand at a time, along the motion planned."""
    c.hand.command(action, time_s, cause, c.events, tested=tested)
