"""V+ of Adept: nearly all of VAL-II, with yaw, pitch and roll.

See [manual language/dialects#to-vplus].
"""

from typing import ClassVar

from vrts.dispatch.posts.post import Post
from vrts.lang.dialect import VPLUS
from vrts.lang.syntax import statements


class VPlus(Post):
    """Writes V+."""

    name = "vplus"
    dialect = VPLUS
    suffix = ".v2"
    LACKS: ClassVar[frozenset[str]] = frozenset({"DECOMPOSE"})  # its angles differ
    LEFT_OUT: ClassVar[frozenset[str]] = frozenset({"INTON", "INTOFF"})
    LACKS_FUNCTIONS: ClassVar[frozenset[str]] = frozenset({"adc", "ioget", "instr"})
    FUNCTIONS: ClassVar[dict[str, str]] = {"maxval": "MAX", "minval": "MIN"}

    def _write_react(self, node: statements.ReactStatement) -> tuple[str, ...]:
        if node.always:
            raise self.lacking(node, f"{node.word} ALWAYS")
        return (self.rewritten(node),)

    def _write_reacti(self, node: statements.ReactStatement) -> tuple[str, ...]:
        return self._write_react(node)

    def _write_pcexecute(self, node: statements.Simple) -> tuple[str, ...]:
        """EXECUTE runs a program as a task beside this one; task 0 has the robot."""
        if not node.operands:
            raise self.lacking(node, "PCEXECUTE without a program", "name the program")
        return (f"EXECUTE 1 {self.started(node, '()')}",)

    def _write_pcabort(self, node: statements.Simple) -> tuple[str, ...]:
        """ABORT stops a task too, but vrts reads no such step."""
        raise self.lacking(node, "PCABORT and can be verified here", "let a variable end its loop")

    def _write_pcend(self, node: statements.Simple) -> tuple[str, ...]:
        """CYCLE.END of V+ waits for the task, or stops it at its next STOP."""
        raise self.lacking(node, "PCEND", "let a variable end its loop")

    def _write_ready(self, node: statements.Simple) -> tuple[str, ...]:
        """READY of the arm that was simulated: that of another arm is elsewhere."""
        return self.ready(node, "MOVE")

    def _write_draw(self, node: statements.Simple) -> tuple[str, ...]:
        """DRAW is a straight motion to where the last one ends, shifted."""
        if any(node.operands[3:]):
            raise self.lacking(node, "DRAW that turns the hand or has a speed")
        return (f"MOVES SHIFT(DEST BY {self.listed(node.operands)})",)

    def _write_shift(self, node: statements.ShiftStatement) -> tuple[str, ...]:
        place = self.expression(node.target)
        return (f"SET {place} = SHIFT({place} BY {self.listed(node.offsets)})",)

    def _write_grasp(self, node: statements.Simple) -> tuple[str, ...]:
        return self.grasped(node)
