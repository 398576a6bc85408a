"""What is left of a program that stopped and may go on, while another one is executed."""

from typing import NamedTuple

from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import Bound
from vrts.engine.memory.records import Ending
from vrts.engine.memory.trace import Activation
from vrts.engine.programs.frames import Frame, activations_of
from vrts.engine.programs.watches import Watch


class Stopped(NamedTuple):
    """All of a `Context` that belongs to the program it executes, by the same names."""

    frames: list[Frame]
    activation: Activation | None
    phase: int
    until: float
    operands: object
    fault: RuntimeFault | None
    priority: int
    watches: list[Watch]
    reactions_wait: bool
    error_program: int | None
    last_error: RuntimeFault | None
    program: str
    cycles_left: int
    cycles_done: int
    kept_cycles: int | None
    ending: Ending
    started_s: float
    step_was_cut: bool

    def copy(self, copies: dict[int, Bound]) -> "Stopped":
        """Return an independent copy over copied cells."""
        frames = [frame.copy(copies) for frame in self.frames]
        return self._replace(
            frames=frames,
            activation=activations_of(self.activation, frames),
            watches=[watch.copy() for watch in self.watches],
        )
