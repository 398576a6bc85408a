"""What closing fingers meet: the first body whose width the opening comes down to, if it is held.

Frames: F is the flange, P stands between the pads, O is an object.
"""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.engine.hand.grip import Between, between
from vrts.geometry.shapes import Piece
from vrts.robots.model import Gripper

LOOK = 7e-3  # [s] between looks at a closing hand that moves: a quarter tick [assumed]
INSTANT = 1e-7  # [s] to which the instant of a grasp is found


class Lying(NamedTuple):
    """A body that may be grasped, where it lies."""

    name: str
    pieces: tuple[Piece, ...]
    X_WO: Pose


class Met(NamedTuple):
    """A body that is grasped."""

    time_s: float
    name: str


class Fingers(NamedTuple):
    """Fingers that close, at a hand that may move."""

    gripper: Gripper
    start_m: float  # opening at the beginning
    begin_s: float
    stop_s: float  # when they are closed, unless they meet something
    flange: Callable[[float], Pose]  # X_WF at a run time
    moves: bool  # the arm does

    def opening(self, time_s: float) -> float:
        """Return the opening while nothing is met [m]."""
        return self.start_m - self.gripper.finger_speed * (time_s - self.begin_s)

    def first_met(self, bodies: Iterable[Lying]) -> Met | str | None:
        """Return the first grasp, else the name of a body that is met off its middle, or None."""
        missed: str | None = None
        best: Met | None = None
        for body in bodies:
            found = self._meets(body)
            if isinstance(found, str):
                missed = missed or found
            elif found is not None and (best is None or found.time_s < best.time_s):
                best = found
        return best or missed

    def _meets(self, body: Lying) -> Met | str | None:
        first = self._look(body, self.begin_s)
        if not self.moves:
            if first is None or self._excess(self.begin_s, first) < 0.0:
                return None
            if not self._holds(first):
                return body.name
            needed = (self.start_m - first.width) / self.gripper.finger_speed
            return Met(self.begin_s + needed, body.name)
        before, met = self.begin_s, first
        while before < self.stop_s:
            after = min(before + LOOK, self.stop_s)
            now = self._look(body, after)
            if (
                met is not None
                and now is not None
                and self._excess(before, met) >= 0.0 >= self._excess(after, now)
            ):
                return self._at_the_instant(body, before, after)
            before, met = after, now
        return None

    def _at_the_instant(self, body: Lying, before: float, after: float) -> Met | str:
        while after - before > INSTANT:
            middle = 0.5 * (before + after)
            met = self._look(body, middle)
            if met is not None and self._excess(middle, met) > 0.0:
                before = middle
            else:
                after = middle
        met = self._look(body, before)
        if met is None or not self._holds(met):
            return body.name
        return Met(before, body.name)

    def _look(self, body: Lying, time_s: float) -> Between | None:
        X_PO = (self.flange(time_s) @ self.gripper.X_FP).inverse() @ body.X_WO
        return between(self.gripper, body.pieces, X_PO)

    def _excess(self, time_s: float, met: Between) -> float:
        """Return by how much the opening is wider than the body [m]."""
        return self.opening(time_s) - met.width

    def _holds(self, met: Between) -> bool:
        return met.centred and met.overlap >= self.gripper.overlap_min
