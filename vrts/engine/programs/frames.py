"""Programs that were called and have not returned: where each is, and what it counts."""

from enum import IntEnum
from typing import NamedTuple

from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import Bound, copy_bound
from vrts.engine.memory.trace import Activation


class FrameKind(IntEnum):
    """Why a program was called."""

    CALL = 0
    REACTION = 1
    ERROR = 2


class Interrupted(NamedTuple):
    """What a step that waits had come to when a reaction interrupted it."""

    phase: int
    until: float
    operands: object
    fault: RuntimeFault | None
    priority: int


class Frame:
    """One activation of a program."""

    __slots__ = (
        "cases",
        "increments",
        "index",
        "interrupted",
        "kind",
        "limits",
        "program",
        "slots",
    )

    def __init__(self, program: int, slots: list[Bound], loops: int, cases: int) -> None:
        """Start at the first instruction."""
        self.program = program  # number of the executable program
        self.index = 0  # next instruction
        self.slots = slots
        self.limits: list[float | None] = [None] * loops
        self.increments: list[float] = [0.0] * loops
        self.cases: list[float | str] = [0.0] * cases
        self.kind = FrameKind.CALL
        self.interrupted: Interrupted | None = None  # of the frame below

    def copy(self, copies: dict[int, Bound]) -> "Frame":
        """Return an independent frame over copied cells."""
        other = Frame(self.program, [copy_bound(slot, copies) for slot in self.slots], 0, 0)
        other.index = self.index
        other.limits = self.limits.copy()
        other.increments = self.increments.copy()
        other.cases = self.cases.copy()
        other.kind, other.interrupted = self.kind, self.interrupted
        return other


def activations_of(old: Activation | None, frames: list[Frame]) -> Activation | None:
    """Return the activations of copied frames; `old` are those of the frames copied."""
    if old is None:
        return None
    if old.caller is None and len(frames) == 1:
        return Activation(old.program, frames[0].slots, old.called_from, None)
    chain: list[Activation] = []
    while old is not None:
        chain.append(old)
        old = old.caller
    found: Activation | None = None
    for activation, frame in zip(reversed(chain), frames, strict=True):
        found = activation._replace(slots=frame.slots, caller=found)
    return found
