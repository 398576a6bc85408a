"""The two kinds of path between two points, as functions of a parameter u from 0 to 1.

A joint path is linear in the joints. On a line the tool's position is linear in u, and the hand
turns evenly.
"""

from typing import NamedTuple, TypeAlias

from vrts.engine.motion.lines.path import LinePath
from vrts.robots.model import Configuration


class JointPath(NamedTuple):
    """From one configuration to another."""

    start: Configuration
    goal: Configuration

    def needed(self, speeds: Configuration, fraction: float) -> float:
        """Return the time the slowest joint needs at a share of its full speed [s]."""
        return max(
            abs(b - a) / (v * fraction)
            for a, b, v in zip(self.start, self.goal, speeds, strict=True)
        )

    @property
    def change(self) -> Configuration:
        """Goal minus start [rad]."""
        return tuple([b - a for a, b in zip(self.start, self.goal, strict=True)])  # type: ignore[return-value]


Path: TypeAlias = JointPath | LinePath
