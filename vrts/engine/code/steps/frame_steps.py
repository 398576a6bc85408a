"""TOOL and BASE as closures: in which frames locations are understood from now on."""

from vrts.base.oat import pose_from_components
from vrts.base.pose import (
    IDENTITY,
    Pose,
)
from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression


class FrameStepCompiler:
    """Compiles changes of frames."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def tool(self, pose: Expression | None, following: int) -> Step:
        """Return the step of TOOL."""
        tool = self.expressions.pose(pose) if pose is not None else None

        def set_tool(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            c.planner.set_tool(tool(c) if tool is not None else IDENTITY)
            c.system.held_tool.assign(c.planner.tool, c.finished)
            return following

        return set_tool

    def base(self, instruction: ir.SetBase | ir.SetBaseFrame, following: int) -> Step:
        """Return the step of BASE."""
        e = self.expressions
        if isinstance(instruction, ir.SetBaseFrame):
            frame = e.pose(instruction.pose)

            def base(c: Context) -> Pose:
                return frame(c).inverse()
        else:
            operands = tuple(
                e.real(operand) if operand is not None else None
                for operand in (
                    instruction.dx,
                    instruction.dy,
                    instruction.dz,
                    instruction.rotation,
                )
            )

            def base(c: Context) -> Pose:
                dx, dy, dz, turn = (0.0 if o is None else o(c) for o in operands)
                return pose_from_components(dx, dy, dz, 90.0 + turn, -90.0, 0.0)

        def set_base(c: Context) -> int:
            if not reached(c, c.planner.settled_at):
                return BLOCKED
            c.planner.base = base(c)
            c.system.held_base.assign(c.planner.base, c.finished)
            return following

        return set_base
