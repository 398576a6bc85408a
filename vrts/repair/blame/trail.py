"""The steps of a robot program as what may be to blame: lines, and who wrote what they read.

What was executed, read and written is told by `vrts.why`, from which chains of causes are made too.
"""

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from vrts.engine.memory.events import Cause
from vrts.engine.run import Run
from vrts.ir.expressions import Place
from vrts.ir.motion import Depart, Draw, Drive, Move
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.read import element, readings
from vrts.why.slicing.sources import written

MOTIONS = (Move, Depart, Drive, Draw)


class Written(NamedTuple):
    """Where a value that a step read was written."""

    line: int | None  # of a data section
    step: int | None  # index of the executed step


class Trail:
    """The steps that a run's robot program executed, in their order."""

    def __init__(self, run: Run) -> None:
        """Look at a run."""
        self.run = run
        self._found = Steps(run)
        self.steps: tuple[Executed, ...] = self._found.of_robot

    @property
    def lines(self) -> frozenset[int]:
        """Lines of steps that were executed."""
        return frozenset(step.line for step in self.steps)

    @cached_property
    def motion_steps(self) -> Mapping[int, int]:
        """For each motion the executed step that asked for it."""
        found = ((m, self._found.motion_index(m)) for m in range(len(self.run.motions)))
        return {motion: k for motion, k in found if k is not None and k < len(self.steps)}

    @cached_property
    def _motion_of(self) -> Mapping[int, int]:
        """For each executed step that asked for a motion the number of that motion."""
        return {k: motion for motion, k in self.motion_steps.items()}

    def motion_before(self, k: int) -> int | None:
        """Return the executed step of the motion to a place before that of a step; None: none.

        Of a step that failed: of the last motion, if it is a step that moves.
        """
        motion = self._motion_of.get(k)
        if motion is None:
            last = k + 1 == len(self.steps) and isinstance(self.steps[k].instruction, MOTIONS)
            motion = len(self.run.motions) if last else None
        while motion:
            motion -= 1
            begun = self.motion_steps.get(motion)
            if begun is None or not isinstance(self.steps[begun].instruction, Depart):
                return begun  # a way out goes on from the place before it, turned as there
        return None

    def reads(self, k: int) -> Iterator[Written]:
        """Yield where the values were written that a step read."""
        for each in readings(self._found, self.steps[k]):
            if each.cell is None:
                continue
            source = written(self._found, each.cell, each.before)
            if source is None:
                continue
            if source.step is None:
                yield Written(None if source.span is None else source.span.line, None)
            elif not source.step.process:
                yield Written(None, self._found.robot_index(source.step.number))

    def unknown(self, k: int) -> Iterator[str]:
        """Yield the names of variables, or their arrays, that a step read and that had no value.

        Of an argument the name that its caller gave.
        """
        for each in readings(self._found, self.steps[k]):
            if not each.known:
                name = element(self._found, each.place, each.before, each.activation)
                yield name.partition("[")[0]

    def writes(self, k: int) -> str | None:
        """Return the name of the variable, or its array, that a step gives a value."""
        place = getattr(self.steps[k].instruction, "place", None)
        return place.variable.name if isinstance(place, Place) else None

    def data_read(self) -> frozenset[int]:
        """Return the lines of data that any step read."""
        found: set[int] = set()
        for k in range(len(self.steps)):
            found.update(w.line for w in self.reads(k) if w.line is not None)
        return frozenset(found)

    def caller(self, k: int) -> int | None:
        """Return the executed step that led to a step: a CALL, or what a reaction interrupted."""
        entered = self._found.entered(self.steps[k].activation)
        return None if entered is None else self._found.robot_index(entered.number)

    def step_of(self, cause: Cause | None, time_s: float) -> int | None:
        """Return the last executed step of a cause that is not after a time."""
        step = self._found.last(cause, time_s)
        index = None if step is None or step.process else self._found.robot_index(step.number)
        return index if index is not None and index < len(self.steps) else None

    def motion_at(self, time_s: float) -> int:
        """Return the number of the last motion that has begun at a time."""
        return self._found.motion_at(time_s) or 0

    def time_of(self, k: int) -> float:
        """Return when a step was executed [s]."""
        return self._found.time_of(self.steps[k])
